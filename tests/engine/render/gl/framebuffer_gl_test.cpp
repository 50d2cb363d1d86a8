// Where drawing goes.
#include "engine/render/gl/framebuffer.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

class FramebufferGl : public GlTest {};

TEST_F(FramebufferGl, TakesColourOrDepthOrBothOfOneNumberOfSamples) {
    using gl::Filter;
    using gl::TargetFormat;
    using gl::Texture;
    const Texture color = Texture::target(TargetFormat::Rgba8, 4, 4, Filter::Nearest);
    const Texture depth = Texture::target(TargetFormat::Depth24, 4, 4, Filter::Nearest);
    EXPECT_TRUE(gl::Framebuffer(&color, &depth).complete());
    EXPECT_TRUE(gl::Framebuffer(&color, nullptr).complete());
    EXPECT_TRUE(gl::Framebuffer(nullptr, &depth).complete()) << "a shadow map has no colour";
    const Texture samples = Texture::multisampled(TargetFormat::Rgba8, 4, 4, 2);
    ASSERT_GT(samples.samples(), 1U);
    EXPECT_TRUE(gl::Framebuffer(&samples, nullptr).complete());
    EXPECT_FALSE(gl::Framebuffer(&samples, &depth).complete()) << "one sample beside several";
    EXPECT_FALSE(gl::Framebuffer().complete());
    EXPECT_FALSE(gl::Framebuffer());
}

}  // namespace
}  // namespace plumbline::render
