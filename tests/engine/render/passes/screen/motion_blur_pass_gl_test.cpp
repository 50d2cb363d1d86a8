// Streaks of a camera that moves.
#include "tests/engine/render/passes/screen/lens_fixture.h"

#include <vector>

namespace plumbline::render {
namespace {

class MotionBlurPassGl : public LensGl {};

TEST_F(MotionBlurPassGl, APanSpreadsABarOverItsWay) {
    RenderFrame frame = empty_frame(kLensSide_px, kLensSide_px);
    frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
    // Black wall, white bar 0.02 m wide 1 m ahead: 8 pixels.
    add_box(frame, {20.0F, 20.0F, 0.1F}, {0.0F, 0.0F, -3.0F}, unlit(Vec3f{0.0F}));
    add_box(frame, {0.02F, 1.5F, 0.0002F}, {0.0F, 0.0F, -1.0F}, unlit(Vec3f{1.0F}));
    const float pan_rad = 0.05F;
    frame.motion_blur =
        MotionBlur{.orientation_before =
                       frame.camera.orientation * glm::angleAxis(pan_rad, Vec3f{0.0F, 1.0F, 0.0F}),
                   .samples = 64};
    const auto row = middle_row(draw(frame));
    const float streak_px = pixels_at_1m() * std::tan(pan_rad);
    const float bar_px = 0.02F * pixels_at_1m();
    float sum = 0.0F;
    for (const float light : row) sum += light;
    // No light is lost, and it is spread evenly over the bar's way.
    EXPECT_NEAR(sum, bar_px, 1.0F);
    const float level = bar_px / streak_px;
    std::size_t lit_px = 0;
    for (const float light : row) lit_px += light > 0.5F * level ? 1 : 0;
    EXPECT_NEAR(static_cast<float>(lit_px), streak_px, 2.0F);
}

TEST_F(MotionBlurPassGl, ACameraThatStoodStillBlursNothing) {
    RenderFrame frame = edge(5.0F);
    const auto plain = draw(frame);
    frame.motion_blur = MotionBlur{.orientation_before = frame.camera.orientation, .samples = 8};
    EXPECT_EQ(draw(frame).bytes, plain.bytes);
}

TEST_F(MotionBlurPassGl, StreaksAreNoLongerThanATwelfthOfTheImage) {
    RenderFrame frame = edge(5.0F);
    frame.motion_blur =
        MotionBlur{.orientation_before =
                       frame.camera.orientation * glm::angleAxis(0.5F, Vec3f{0.0F, 1.0F, 0.0F}),
                   .samples = 64};
    const auto row = middle_row(draw(frame));
    EXPECT_LE(crossing(row, 0.98F) - crossing(row, 0.02F), kLensSide_px / 12.0F + 1.0F);
    EXPECT_GE(crossing(row, 0.98F) - crossing(row, 0.02F), kLensSide_px / 12.0F * 0.9F);
}

}  // namespace
}  // namespace plumbline::render
