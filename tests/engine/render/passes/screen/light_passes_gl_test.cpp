// Depth of field against the thin lens; streaks of a camera that moves.
#include "tests/engine/render/passes/screen/lens_fixture.h"

#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

class FocusPassGl : public LensGl {};
class MotionBlurPassGl : public LensGl {};

TEST_F(FocusPassGl, AnEdgeOutOfFocusIsAsWideAsTheThinLensSays) {
    struct Case {
        float distance_m;
        float focus_m;
        float aperture_m;
    };
    for (const Case& c : {Case{20.0F, 2.0F, 0.1F},
                          Case{20.0F, 2.0F, 0.06F},
                          Case{100.0F, 5.0F, 0.25F},
                          Case{2.0F, 20.0F, 0.1F}}) {
        RenderFrame frame = edge(c.distance_m);
        frame.depth_of_field =
            DepthOfField{.focus_m = c.focus_m, .aperture_m = c.aperture_m, .samples = 128};
        const float radius_px =
            0.5F * c.aperture_m * pixels_at_1m() * std::abs(1.0F / c.focus_m - 1.0F / c.distance_m);
        EXPECT_GT(radius_px, 5.0F);
        EXPECT_NEAR(blur_radius_px(middle_row(draw(frame))), radius_px, 1.0F)
            << c.distance_m << " m, focus " << c.focus_m << " m";
    }
}

TEST_F(FocusPassGl, WhatIsInFocusStaysSharp) {
    RenderFrame frame = edge(5.0F);
    const auto plain = draw(frame);
    frame.depth_of_field = DepthOfField{.focus_m = 5.0F, .aperture_m = 0.1F};
    EXPECT_EQ(draw(frame).bytes, plain.bytes);
}

TEST_F(FocusPassGl, AThingInFocusDoesNotSmearIntoWhatIsBehindIt) {
    RenderFrame frame = empty_frame(kLensSide_px, kLensSide_px);
    frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
    add_box(frame, {200.0F, 200.0F, 0.1F}, {0.0F, 0.0F, -40.0F}, unlit(Vec3f{0.1F}));
    add_box(frame, {0.4F, 0.4F, 0.02F}, {0.0F, 0.0F, -2.0F}, unlit(Vec3f{1.0F}));
    frame.depth_of_field = DepthOfField{.focus_m = 2.0F, .aperture_m = 0.04F};
    const auto row = middle_row(draw(frame));
    // From black to white within three pixels, and no light beyond.
    const auto half_px = static_cast<std::size_t>(0.1F * pixels_at_1m());
    const std::size_t left = kLensSide_px / 2 - half_px;
    EXPECT_NEAR(row[left - 4], 0.1F, 0.02F);
    EXPECT_NEAR(row[left + 3], 1.0F, 0.01F);
}

TEST_F(FocusPassGl, NobodyPaysUnasked) {
    RenderFrame frame = edge(5.0F);
    draw(frame);
    EXPECT_EQ(bytes_of("depth_of_field"), 0U);
    EXPECT_EQ(bytes_of("motion_blur"), 0U);
    frame.depth_of_field = DepthOfField{};
    frame.motion_blur = MotionBlur{.position_before_world = {0.1F, 0.0F, 0.0F}};
    draw(frame);
    constexpr std::uint64_t kFull = std::uint64_t{kLensSide_px} * kLensSide_px * 8;
    EXPECT_EQ(bytes_of("depth_of_field"), kFull + kFull / 2);
    EXPECT_EQ(bytes_of("motion_blur"), kFull);
    frame.depth_of_field.reset();
    frame.motion_blur.reset();
    draw(frame);
    EXPECT_EQ(bytes_of("depth_of_field"), 0U);
    EXPECT_EQ(bytes_of("motion_blur"), 0U);
    for (const PassTiming& pass : renderer_->stats().passes) {
        EXPECT_NE(pass.name, "focus");
        EXPECT_NE(pass.name, "motion_blur");
    }
}

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
