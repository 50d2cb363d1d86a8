// A driver that draws into no half floats: as GpuLimits says, for there is hardly one left to try.
#include "tests/engine/render/image_fixture.h"

#include <cstdlib>

namespace plumbline::render {
namespace {

class NoHalfFloatsGl : public ImageGl {
protected:
    RenderFrame ball_under_the_sun() {
        RenderFrame frame = empty_frame(64, 48);
        frame.camera = camera_at({0.0F, 3.0F, 6.0F}, Vec3f{0.0F});
        frame.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{-0.4F, -1.0F, -0.3F}),
                                     .radiance = Vec3f{2.0F}};
        frame.sun_shadow = SunShadow{.size_px = 256, .distance_m = 30.0F};
        frame.ambient = Vec3f{0.05F};
        frame.post = Post{.exposure = 0.8F, .bloom = 0.2F, .adapts = true};
        add_box(frame, {20.0F, 1.0F, 20.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.5F}));
        add_box(frame, Vec3f{1.0F}, {0.0F, 0.5F, 0.0F}, matt({0.8F, 0.3F, 0.2F}));
        return frame;
    }
};

TEST_F(NoHalfFloatsGl, LightIsKeptInEightBitsAndTheImageIsNearlyTheSame) {
    RenderFrame frame = ball_under_the_sun();
    frame.post->bloom = 0.0F;
    frame.post->adapts = false;
    const assets::ImageData usual = draw(frame);
    testing::internal::CaptureStderr();
    make_renderer(PL_SOURCE_DIR "/shaders", {.half_float_targets = false});
    const assets::ImageData coarse = draw(frame);
    draw(frame);
    const std::string said = testing::internal::GetCapturedStderr();
    const std::size_t first = said.find("the driver draws into no half floats");
    EXPECT_NE(first, std::string::npos) << said;
    EXPECT_EQ(said.find("half floats", first + 40), std::string::npos) << "said twice: " << said;
    ASSERT_EQ(coarse.bytes.size(), usual.bytes.size());
    int most = 0;
    for (std::size_t i = 0; i < usual.bytes.size(); ++i)
        most = std::max(most, std::abs(int{usual.bytes[i]} - int{coarse.bytes[i]}));
    EXPECT_LE(most, 3);
}

TEST_F(NoHalfFloatsGl, BloomAndEyesThatAdaptAreLeftOut) {
    RenderFrame frame = ball_under_the_sun();
    make_renderer(PL_SOURCE_DIR "/shaders", {.half_float_targets = false});
    const assets::ImageData asked = draw(frame);
    for (const PassTiming& pass : renderer_->stats().passes) {
        EXPECT_NE(pass.name, "post.bloom");
        EXPECT_NE(pass.name, "post.exposure");
    }
    frame.post->bloom = 0.0F;
    frame.post->adapts = false;
    EXPECT_EQ(draw(frame).bytes, asked.bytes);
}

// Lines, half the size and smooth edges go through every later step.
TEST_F(NoHalfFloatsGl, AllOtherStepsAreAsUsual) {
    RenderFrame frame = ball_under_the_sun();
    frame.quality.render_scale = 0.5F;
    frame.quality.anti_aliasing = AntiAliasing::Fxaa;
    frame.lines.add({-1.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F});
    frame.post = Post{};
    const Pixel usual = pixel_at(draw(frame), 8, 40);
    make_renderer(PL_SOURCE_DIR "/shaders", {.half_float_targets = false});
    const Pixel coarse = pixel_at(draw(frame), 8, 40);
    EXPECT_NEAR(coarse.r, usual.r, 3);
    EXPECT_NEAR(coarse.g, usual.g, 3);
    EXPECT_NEAR(coarse.b, usual.b, 3);
}

}  // namespace
}  // namespace plumbline::render
