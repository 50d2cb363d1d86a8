// How large a frame is drawn, at which quality, and which shadows it needs.
#include "engine/render/passes/screen/frame_targets.h"
#include "tests/engine/render/image_fixture.h"
#include "tests/engine/render/renderer_fixture.h"

#include <cstdlib>

namespace plumbline::render {
namespace {

class FrameSetupGl : public RendererGl {};

TEST_F(FrameSetupGl, SurvivesSizesOfZero) {
    RenderFrame frame = sunny_box();
    for (const auto& [width, height] : {std::pair{0U, 0U}, {64U, 0U}, {0U, 48U}}) {
        frame.width_px = width;
        frame.height_px = height;
        EXPECT_TRUE(draw(frame).bytes.empty());
        EXPECT_TRUE(renderer_->stats().passes.empty());
    }
    frame.width_px = 64;
    frame.height_px = 48;
    EXPECT_EQ(draw(frame).bytes.size(), 64U * 48U * 3U);
}

TEST_F(FrameSetupGl, FollowsTheFramesSize) {
    RenderFrame frame = sunny_box();
    frame.post = Post{.exposure = 1.0F, .bloom = 0.1F};
    for (const std::uint32_t side : {16U, 200U, 33U, 1U, 128U}) {
        frame.width_px = side;
        frame.height_px = side;
        EXPECT_EQ(draw(frame).width, side);
        // Light in half floats and codes of 4 bytes, each with a depth of 4.
        EXPECT_EQ(bytes_of("targets"), std::uint64_t{side} * side * (8 + 4 + 4 + 4));
    }
    // Twice the same size costs the same memory: nothing leaks.
    const std::uint64_t before = bytes_of("post");
    draw(frame);
    EXPECT_EQ(bytes_of("post"), before);
}

// EXPERIENCE A9
TEST_F(FrameSetupGl, ShortOfMemoryHalvesTheRenderScaleOnceThenTakesTheLowestLevel) {
    RenderFrame frame = sunny_box();
    frame.width_px = 200;
    frame.height_px = 100;
    frame.post = Post{};  // wants an image of light
    const std::size_t whole = 200 * 100 * (8 + 4);
    make_renderer(PL_SOURCE_DIR "/shaders", {.target_bytes = whole});
    draw(frame);
    EXPECT_EQ(renderer_->stats().scene_width_px, 200U);
    make_renderer(PL_SOURCE_DIR "/shaders", {.target_bytes = whole - 1});
    EXPECT_EQ(draw(frame).width, 200U);
    EXPECT_EQ(renderer_->stats().scene_width_px, 100U);
    EXPECT_EQ(renderer_->stats().scene_height_px, 50U);
    make_renderer(PL_SOURCE_DIR "/shaders", {.target_bytes = whole / 4 - 1});
    draw(frame);
    EXPECT_EQ(renderer_->stats().scene_width_px, 80U);  // four tenths
    make_renderer(PL_SOURCE_DIR "/shaders", {.target_bytes = 100});
    draw(frame);
    EXPECT_TRUE(renderer_->stats().passes.empty());
}

// EXPERIENCE A12
TEST_F(FrameSetupGl, ImageBeyondTheTextureLimitIsDrawnSmallerInItsShapeAndScaledUp) {
    // The renderer's own present target has the driver's limit, so it is the window's that can be
    // larger than an image; here the scene's limit alone is lowered.
    RenderFrame frame = sunny_box();
    frame.width_px = 20'000;
    frame.height_px = 10;
    EXPECT_EQ(draw(frame).width, 16'384U);
    EXPECT_LE(renderer_->stats().scene_width_px, 16'384U);
    frame.quality.render_scale = 0.5F;
    frame.width_px = 400;
    frame.height_px = 200;
    const auto image = draw(frame);
    EXPECT_EQ(image.width, 400U);
    EXPECT_EQ(renderer_->stats().scene_width_px, 200U);
    EXPECT_EQ(renderer_->stats().scene_height_px, 100U);
}

class FrameSetupImageGl : public ImageGl {};

TEST_F(FrameSetupImageGl, AFlashlightAtTheEyeNeedsNoShadowMap) {
    RenderFrame frame = wall(matt(Vec3f{0.8F}), 6.0F);
    frame.width_px = 301;
    frame.height_px = 301;
    add_box(frame, Vec3f{0.6F}, {0.5F, 0.2F, -3.0F}, matt(Vec3f{0.8F, 0.2F, 0.2F}));
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{60.0F},
                                  .radius_m = 30.0F,
                                  .inner_rad = 0.15F,
                                  .outer_rad = 0.4F};
    const auto without = draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    // A tenth of a millimetre aside it has one. What that hides is thinner than a pixel; the map's own
    // coarseness shows at the box's edge, where it is a texel of 6 m * 2 tan 0.4 / 1024 wide.
    frame.flashlight->position_world.x = 1e-4F;
    const auto with = draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
    int unlike = 0;
    for (std::uint32_t y = 0; y < 301; ++y) {
        for (std::uint32_t x = 0; x < 301; ++x)
            unlike += std::abs(pixel_at(without, x, y).r - pixel_at(with, x, y).r) > 3;
    }
    EXPECT_LT(unlike, 301 * 301 / 200);
    EXPECT_GT(pixel_at(without, 150, 150).r, 100);
}

TEST_F(FrameSetupGl, ShadowsBeyondTheScenesDistanceTakeOneMoreCascade) {
    RenderFrame frame = sunny_box();
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 256U * 256U * 4U);
    frame.quality.far_shadows = true;
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 2U * 256U * 256U * 4U);
    frame.sun_shadow->cascades = 4;
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 4U * 256U * 256U * 4U) << "no more than four";
    frame.sun_shadow->cascades = 1;
    frame.camera.far_m = frame.sun_shadow->distance_m;
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 256U * 256U * 4U) << "nothing is seen beyond";
    frame.quality.shadow_detail = 0.5F;
    draw(frame);
    EXPECT_EQ(bytes_of("sun_shadow"), 128U * 128U * 4U);
}

TEST_F(FrameSetupGl, ASunThatDoesNotReachTheGroundThrowsNoShadow) {
    RenderFrame frame = sunny_box();
    const auto sunny = draw(frame);
    frame.sun_reaches_ground = false;
    frame.ambient = Vec3f{0.2F};
    const auto shaded = draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    EXPECT_EQ(bytes_of("sun_shadow"), 0U);
    frame.sun.reset();
    frame.sun_shadow.reset();
    EXPECT_EQ(draw(frame).bytes, shaded.bytes) << "as if there were none";
}

}  // namespace
}  // namespace plumbline::render
