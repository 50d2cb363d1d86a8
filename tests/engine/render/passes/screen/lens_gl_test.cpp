// Depth of field against the thin lens, motion blur against the camera's way.
#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kLensSide_px = 480;

class LensGl : public ImageGl {
protected:
    /// Black; a white board right of the middle, `distance_m` ahead.
    RenderFrame edge(float distance_m) {
        RenderFrame frame = empty_frame(kLensSide_px, kLensSide_px);
        frame.camera = camera_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F});
        const float size_m = 4.0F * distance_m;
        const auto black = unlit(Vec3f{0.0F});
        const auto white = unlit(Vec3f{1.0F});
        add_box(frame, {size_m, size_m, 0.02F}, {0.0F, 0.0F, -distance_m - 0.02F}, black);
        add_box(frame, {size_m, size_m, 0.02F}, {0.5F * size_m, 0.0F, -distance_m}, white);
        return frame;
    }
    static float pixels_at_1m() {
        return 0.5F * static_cast<float>(kLensSide_px) / std::tan(radians_from_degrees(30.0F));
    }
    static std::vector<float> middle_row(const assets::ImageData& image) {
        std::vector<float> row;
        for (std::uint32_t x = 0; x < image.width; ++x)
            row.push_back(linear_from_srgb(
                static_cast<float>(pixel_at(image, x, image.height / 2).g) / 255.0F));
        return row;
    }
    /// Where the row first gets above that light; pixels, between their middles.
    static float crossing(const std::vector<float>& row, float light) {
        for (std::size_t i = 1; i < row.size(); ++i) {
            if (row[i] >= light && row[i - 1] < light)
                return static_cast<float>(i) - (row[i] - light) / (row[i] - row[i - 1]);
        }
        ADD_FAILURE() << "never above " << light;
        return 0.0F;
    }
    /// Of a row that a disc has blurred across a straight edge: 80 % of its light lie within 1.374
    /// of its radius.
    static float blur_radius_px(const std::vector<float>& row) {
        return (crossing(row, 0.9F) - crossing(row, 0.1F)) / 1.374F;
    }
};

TEST_F(LensGl, AnEdgeOutOfFocusIsAsWideAsTheThinLensSays) {
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

TEST_F(LensGl, WhatIsInFocusStaysSharp) {
    RenderFrame frame = edge(5.0F);
    const auto plain = draw(frame);
    frame.depth_of_field = DepthOfField{.focus_m = 5.0F, .aperture_m = 0.1F};
    EXPECT_EQ(draw(frame).bytes, plain.bytes);
}

TEST_F(LensGl, AThingInFocusDoesNotSmearIntoWhatIsBehindIt) {
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

TEST_F(LensGl, APanSpreadsABarOverItsWay) {
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

TEST_F(LensGl, AThingThatMovesIsSpreadOverItsWayAndWhatIsBehindItStaysSharp) {
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

TEST_F(LensGl, NobodyPaysUnasked) {
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

}  // namespace
}  // namespace plumbline::render
