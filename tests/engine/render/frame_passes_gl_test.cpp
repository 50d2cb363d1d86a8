// Which passes see the scene's light before it is shown, and what they leave behind.
#include "tests/engine/render/renderer_fixture.h"

#include <string_view>
#include <vector>

namespace plumbline::render {
namespace {

class FramePassesGl : public RendererGl {};

TEST_F(FramePassesGl, WhatAFrameDoesNotAskForHoldsNoMemory) {
    RenderFrame frame = sunny_box();
    frame.flashlight = Flashlight{};
    frame.post = Post{.exposure = 1.0F, .bloom = 0.1F};
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 256U * 256U * 4U);
    EXPECT_EQ(bytes_of("flashlight"), 1024U * 1024U * 4U);
    EXPECT_GT(bytes_of("post"), 0U);

    frame.flashlight.reset();
    frame.sun_shadow.reset();
    frame.post.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 0U);
    EXPECT_EQ(bytes_of("flashlight"), 0U);
    EXPECT_EQ(bytes_of("post"), 0U);
    EXPECT_EQ(bytes_of("sky"), 0U);
    ASSERT_EQ(renderer_->stats().passes.size(), 1U);
    EXPECT_EQ(renderer_->stats().passes[0].name, "opaque");

    renderer_->forget_scene();
    EXPECT_EQ(bytes_of("meshes"), 0U);
}

// Without anything that blends surfaces write codes themselves; glass, even out of sight, needs the pass.
TEST_F(FramePassesGl, CodesOfSurfacesAreThoseOfThePass) {
    RenderFrame frame = sunny_box();
    frame.clear_color = {0.02F, 0.4F, 0.9F};
    const assets::ImageData by_surfaces = draw(frame);
    ASSERT_EQ(renderer_->stats().passes.back().name, "opaque");
    const assets::MaterialId glass =
        library_.add_material({.name = "glass", .alpha_mode = assets::AlphaMode::Blend});
    add_box(frame, Vec3f{1.0F}, {0.0F, 0.0F, 500.0F}, glass);
    const assets::ImageData by_pass = draw(frame);
    ASSERT_EQ(renderer_->stats().passes.back().name, "image");
    ASSERT_EQ(by_pass.bytes.size(), by_surfaces.bytes.size());
    for (std::size_t i = 0; i < by_pass.bytes.size(); ++i)
        ASSERT_NEAR(by_pass.bytes[i], by_surfaces.bytes[i], 1) << i;
}

TEST_F(FramePassesGl, PassesRunInTheirOrderAndFreeWhatTheyHeld) {
    RenderFrame frame = sunny_box();
    frame.depth_of_field = DepthOfField{};
    frame.quality.anti_aliasing = AntiAliasing::Msaa2;
    draw(frame);
    const auto passes_named = [&] {
        std::vector<std::string_view> names;
        for (const PassTiming& pass : renderer_->stats().passes) names.push_back(pass.name);
        return names;
    };
    EXPECT_EQ(passes_named(),
              (std::vector<std::string_view>{"shadow.sun", "opaque", "resolve", "focus", "image"}));
    EXPECT_GT(bytes_of("depth_of_field"), 0U);
    frame.depth_of_field.reset();
    frame.quality.anti_aliasing = AntiAliasing::Off;
    draw(frame);
    EXPECT_EQ(bytes_of("depth_of_field"), 0U);
    for (const auto& name : passes_named()) EXPECT_NE(name, "resolve");
}

TEST_F(FramePassesGl, AQualityThatNeverDrawsThemLeavesThemOut) {
    RenderFrame frame = sunny_box();
    frame.occlusion = AmbientOcclusion{};
    frame.shafts = SunShafts{};
    frame.quality.ambient_occlusion = Drawn::Never;
    frame.quality.sun_shafts = Drawn::OnGpu;  // tests draw on a CPU
    draw(frame);
    EXPECT_EQ(bytes_of("ambient_occlusion"), 0U);
    EXPECT_EQ(bytes_of("sun_shafts"), 0U);
}

}  // namespace
}  // namespace plumbline::render
