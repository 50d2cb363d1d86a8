// Streaks of things that move before a camera that stands still.
#include "tests/engine/render/passes/screen/lens_fixture.h"

#include <algorithm>

namespace plumbline::render {
namespace {

class MotionVectorsGl : public LensGl {};

TEST_F(MotionVectorsGl, AThingThatMovesIsSpreadOverItsWayAndWhatIsBehindItStaysSharp) {
    RenderFrame frame = empty_frame(kLensSide_px, kLensSide_px);
    frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
    // A wall of an edge, and before it a square 50 mm wide that went 90 mm to the right.
    add_box(frame, {20.0F, 20.0F, 0.1F}, {0.0F, 0.0F, -3.0F}, unlit(Vec3f{0.1F}));
    add_box(frame, {20.0F, 20.0F, 0.1F}, {0.0F, 10.3F, -2.95F}, unlit(Vec3f{0.4F}));
    constexpr float kWide_m = 0.05F;
    constexpr float kWay_m = 0.09F;
    add_box(frame, {kWide_m, 0.1F, 0.0002F}, {0.0F, 0.0F, -1.0F}, unlit(Vec3f{1.0F}));
    const auto still = draw(frame);
    const DrawItem& square = frame.items.back();
    frame.motion_blur =
        MotionBlur{.samples = 64,
                   .moved = {{.mesh = square.mesh,
                              .world_from_body = square.world_from_body,
                              .world_from_body_before =
                                  glm::translate(Mat4f{1.0F}, Vec3f{-kWay_m, 0.0F, 0.0F}) *
                                  square.world_from_body}}};
    const auto image = draw(frame);
    const auto row = middle_row(image);
    const auto px = [](float x_m) { return 0.5F * kLensSide_px + x_m * pixels_at_1m(); };
    // For more than half of the time it hid each place between, less towards both ends of its way.
    const auto hidden = [](float x_m) {
        const float first = std::max(x_m - 0.5F * kWide_m, -kWay_m);
        const float last = std::min(x_m + 0.5F * kWide_m, 0.0F);
        return std::max(last - first, 0.0F) / kWay_m;
    };
    for (float x_m = -0.2F; x_m < 0.1F; x_m += 0.01F) {
        const float expected = 0.1F + 0.9F * hidden(x_m);
        EXPECT_NEAR(row[static_cast<std::size_t>(px(x_m))], expected, 0.03F) << x_m;
    }
    // The wall's edge above it is as it was.
    for (std::uint32_t y = 0; y < kLensSide_px / 3; ++y)
        for (std::uint32_t x = 0; x < kLensSide_px; x += 16)
            ASSERT_EQ(pixel_at(image, x, y).g, pixel_at(still, x, y).g) << x << ' ' << y;
    // Behind what hides it a thing that moves does not show.
    add_box(frame, {1.0F, 1.0F, 0.01F}, {0.0F, 0.0F, -0.8F}, unlit(Vec3f{0.2F}));
    for (const float light : middle_row(draw(frame))) EXPECT_LT(light, 0.22F);
}

TEST_F(MotionVectorsGl, WhatMovesLessThanHalfAPixelOrOutOfSightIsNotDrawnAgain) {
    RenderFrame frame = edge(5.0F);
    frame.motion_blur = MotionBlur{};
    draw(frame);
    const auto without = renderer_->stats().draw_calls;
    const auto with_way = [&](const Vec3f& way_m, const Vec3f& place_m) {
        frame.motion_blur->moved = {
            {.mesh = frame.items[0].mesh,
             .world_from_body = glm::translate(Mat4f{1.0F}, place_m),
             .world_from_body_before = glm::translate(Mat4f{1.0F}, place_m - way_m)}};
        draw(frame);
        return renderer_->stats().draw_calls - without;
    };
    const float pixel_m = 5.0F / pixels_at_1m();
    EXPECT_EQ(with_way({0.4F * pixel_m, 0.0F, 0.0F}, {0.0F, 0.0F, -5.1F}), 0U);
    EXPECT_EQ(with_way({2.0F * pixel_m, 0.0F, 0.0F}, {0.0F, 0.0F, -5.1F}), 1U);
    EXPECT_EQ(with_way({1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 90.0F}), 0U) << "behind the camera";
    frame.motion_blur->moved = {{.mesh = {}}};
    draw(frame);
    EXPECT_EQ(renderer_->stats().draw_calls, without) << "a mesh that is none";
}

}  // namespace
}  // namespace plumbline::render
