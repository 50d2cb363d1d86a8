// Shadows of the sun, where geometry puts them.
#include "tests/engine/render/image_fixture.h"
#include "tests/engine/render/renderer_fixture.h"

namespace plumbline::render {
namespace {

/// Ground, a box of 2 m on it, and a sun whose shadow of the box can be computed.
class ShadowPassGl : public ImageGl {
protected:
    static constexpr std::uint32_t kSide_px = 300;
    static constexpr float kHalf_m = 6.0F;

    void SetUp() override {
        ImageGl::SetUp();
        frame_ = empty_frame(kSide_px, kSide_px);
        // From high above with a narrow lens: nearly a map.
        frame_.camera = camera_at({0.0F, 60.0F, 0.0F}, Vec3f{0.0F});
        frame_.camera.fov_y_rad = 2.0F * std::atan(kHalf_m / 60.0F);
        add_box(frame_, {40.0F, 1.0F, 40.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        add_box(frame_, Vec3f{2.0F}, {0.0F, 1.0F, 0.0F}, matt({0.8F, 0.1F, 0.1F}));
        frame_.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{1.0F, -1.0F, 0.0F}),
                                      .radiance = Vec3f{3.0F}};
        frame_.sun_shadow = SunShadow{.size_px = 2048, .distance_m = 80.0F};
    }

    /// Acne would darken single pixels of the lit ground, at any height of the sun.
    void expect_no_specks() {
        for (const float height : {0.25F, 0.6F, 3.0F}) {
            frame_.sun->direction_world = glm::normalize(Vec3f{1.0F, -height, 0.37F});
            const auto image = draw(frame_);
            const int lit = ground(image, -5.0F, -5.0F);
            for (float z = -5.5F; z < 5.5F; z += 0.1F) {
                for (float x = -5.5F; x < -1.3F; x += 0.1F) {
                    ASSERT_NEAR(ground(image, x, z), lit, 4) << x << ' ' << z << ' ' << height;
                }
            }
        }
    }

    /// How bright the ground is at (x, z), 0 to 255.
    int ground(const assets::ImageData& image, float x, float z) const {
        const auto pixel = [](float at_m) {
            return static_cast<std::uint32_t>((at_m + kHalf_m) / (2.0F * kHalf_m) * kSide_px);
        };
        return pixel_at(image, pixel(x), pixel(z)).g;
    }

    RenderFrame frame_;
};

TEST_F(ShadowPassGl, AFloorDrawnInPartsLooksAsDrawnAtOnce) {
    frame_.flashlight = Flashlight{.position_world = frame_.camera.position_world,
                                   .direction_world = {0.05F, -1.0F, 0.0F},
                                   .intensity = Vec3f{4000.0F},
                                   .radius_m = 80.0F,
                                   .inner_rad = 0.02F,
                                   .outer_rad = 0.05F};
    const auto in_parts = draw(frame_);
    const auto draws = renderer_->stats().draw_calls;
    // Casters out of sight to both sides: now a shadow may fall anywhere.
    add_box(frame_, Vec3f{0.1F}, {-30.0F, 0.1F, -30.0F}, matt(Vec3f{0.8F}));
    add_box(frame_, Vec3f{0.1F}, {30.0F, 0.1F, 30.0F}, matt(Vec3f{0.8F}));
    const auto at_once = draw(frame_);
    EXPECT_GT(draws, renderer_->stats().draw_calls);
    for (std::uint32_t y = 0; y < kSide_px; ++y) {
        for (std::uint32_t x = 0; x < kSide_px; ++x) {
            ASSERT_NEAR(pixel_at(in_parts, x, y).g, pixel_at(at_once, x, y).g, 1) << x << ' ' << y;
            ASSERT_NEAR(pixel_at(in_parts, x, y).r, pixel_at(at_once, x, y).r, 1) << x << ' ' << y;
        }
    }
}

TEST_F(ShadowPassGl, AFloorWithNothingBelowItIsLeftOutOfTheMap) {
    frame_.items.front().is_static = true;
    // As wide as the map.
    frame_.items.front().world_from_body =
        glm::scale(frame_.items.front().world_from_body, {4.0F, 1.0F, 4.0F});
    add_box(frame_, Vec3f{0.1F}, {0.5F, 1.5F, 0.0F}, matt(Vec3f{0.8F}));  // within the large one
    const auto above = draw(frame_);
    const auto triangles = renderer_->stats().triangles;
    frame_.items.back().world_from_body =
        glm::translate(Mat4f{1.0F}, {0.5F + 4.5F, 1.5F - 4.5F, 0.0F});  // in the shadow of the same
    const auto below = draw(frame_);
    // The floor is in the map now, and hides the small box, from the eye and from the sun.
    EXPECT_EQ(renderer_->stats().triangles + 24U, triangles + 12U);
    for (std::uint32_t y = 0; y < kSide_px; ++y) {
        for (std::uint32_t x = 0; x < kSide_px; ++x)
            ASSERT_NEAR(pixel_at(above, x, y).g, pixel_at(below, x, y).g, 1) << x << ' ' << y;
    }
}

TEST_F(ShadowPassGl, LiesWhereGeometryPutsIt) {
    // 45 degrees: the box from x = -1 to 1, 2 m high, shades the ground from its foot at x = 1
    // to x = 3. The map's texel is under 7 cm here.
    const auto image = draw(frame_);
    const int lit = ground(image, -3.0F, 0.0F);
    const int shaded = ground(image, 2.0F, 0.0F);
    EXPECT_GT(lit, 180);
    EXPECT_LT(shaded, 20);
    for (const float x : {1.15F, 1.5F, 2.8F}) EXPECT_EQ(ground(image, x, 0.0F), shaded) << x;
    for (const float x : {3.2F, 4.0F, -1.2F}) EXPECT_NEAR(ground(image, x, 0.0F), lit, 3) << x;
    EXPECT_EQ(ground(image, 2.0F, 0.85F), shaded);
    EXPECT_NEAR(ground(image, 2.0F, 1.2F), lit, 3);
}

TEST_F(ShadowPassGl, LeavesNoSpecksOnWhatTheSunShinesOn) {
    expect_no_specks();
}

TEST_F(ShadowPassGl, CascadesShowTheSameShadowNearAndFar) {
    // The camera is 60 m up: of four cascades to 300 m the ground lies in the second, of two to
    // 80 m in the last.
    const auto one = draw(frame_);
    for (const auto& [cascades, distance_m] :
         {std::pair{2U, 80.0F}, {2U, 290.0F}, {3U, 100.0F}, {4U, 300.0F}}) {
        frame_.sun_shadow =
            SunShadow{.size_px = 2048, .distance_m = distance_m, .cascades = cascades};
        const auto image = draw(frame_);
        for (const float x : {-3.0F, 1.3F, 2.0F, 2.6F, 3.4F, 5.0F}) {
            EXPECT_NEAR(ground(image, x, 0.0F), ground(one, x, 0.0F), 4)
                << cascades << ' ' << distance_m << ' ' << x;
        }
        EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{2048} * 2048 * 4 * cascades);
    }
}

TEST_F(ShadowPassGl, FarCascadesLeaveNoSpecksEither) {
    frame_.sun_shadow = SunShadow{.size_px = 1024, .distance_m = 200.0F, .cascades = 2};
    expect_no_specks();
}

TEST_F(ShadowPassGl, FarCascadesFollowWhatMovesAFewFramesLater) {
    frame_.sun_shadow = SunShadow{.size_px = 512, .distance_m = 250.0F, .cascades = 2};
    draw(frame_);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 2U);
    int far_drawn = 0;
    for (int i = 1; i <= 12; ++i) {
        frame_.items[1].world_from_body =
            glm::translate(Mat4f{1.0F}, Vec3f{0.1F * static_cast<float>(i), 1.0F, 0.0F});
        draw(frame_);
        far_drawn += static_cast<int>(renderer_->stats().shadow_passes_rendered) - 1;
    }
    EXPECT_EQ(far_drawn, 3);
    // At rest both are kept, once the far one has caught up.
    for (int i = 0; i < 5; ++i) draw(frame_);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 2U);
}

TEST_F(ShadowPassGl, WhatCannotMoveIsNotDrawnAgainForWhatMoves) {
    // A wall that cannot move stands half over where the box goes.
    add_box(frame_, {1.0F, 3.0F, 2.0F}, {-2.0F, 1.5F, 0.0F}, matt({0.1F, 0.1F, 0.8F}));
    frame_.items[0].is_static = true;
    frame_.items[2].is_static = true;
    const auto move_to = [&](float x) {
        frame_.items[1].world_from_body = glm::translate(Mat4f{1.0F}, Vec3f{x, 1.0F, 0.4F * x});
    };
    const std::vector<float> places{-3.0F, -2.0F, -0.5F, 1.0F, -0.5F};
    std::vector<assets::ImageData> moved;
    std::vector<std::uint64_t> triangles;
    for (const float x : places) {
        move_to(x);
        moved.push_back(draw(frame_));
        triangles.push_back(renderer_->stats().triangles);
    }
    // First all, the still ones into a map of their own; from then on the box.
    EXPECT_EQ(triangles[1], triangles[0] - 24U);
    EXPECT_EQ(triangles[2], triangles[0] - 24U);
    EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{2048} * 2048 * 4 * 2);
    for (std::size_t i = 0; i < places.size(); ++i) {
        move_to(places[i]);
        // Another size and back: everything is drawn anew.
        frame_.sun_shadow->size_px = 1024;
        draw(frame_);
        frame_.sun_shadow->size_px = 2048;
        EXPECT_EQ(draw(frame_).bytes, moved[i].bytes) << i;
        EXPECT_EQ(renderer_->stats().triangles, triangles[0]);
        EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{2048} * 2048 * 4 * 2);
    }
    // Where nothing stands still, nothing is kept until something has moved.
    frame_.items[0].is_static = false;
    frame_.items[2].is_static = false;
    frame_.sun_shadow->size_px = 1024;
    draw(frame_);
    EXPECT_EQ(bytes_of("sun_shadow"), std::uint64_t{1024} * 1024 * 4);
}

TEST_F(ShadowPassGl, EndsWithItsDistance) {
    frame_.sun_shadow->distance_m = 30.0F;  // the ground is 60 m off
    const auto image = draw(frame_);
    EXPECT_NEAR(ground(image, 2.0F, 0.0F), ground(image, -3.0F, 0.0F), 3);
}

class ShadowPassKept : public RendererGl {};

TEST_F(ShadowPassKept, DrawsShadowsAgainOnlyWhenSomethingMoved) {
    RenderFrame frame = sunny_box();
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 0U);
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);

    frame.camera.position_world.x += 0.05F;  // far less than the map's step
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);

    frame.items[1].world_from_body =
        glm::translate(frame.items[1].world_from_body, Vec3f{0.0F, 0.01F, 0.0F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);

    frame.sun->direction_world = glm::normalize(Vec3f{-0.41F, -1.0F, -0.3F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
}

TEST_F(ShadowPassKept, ThingsThatCastNoShadowMayMoveForFree) {
    RenderFrame frame = sunny_box();
    frame.items[1].casts_shadow = false;
    draw(frame);
    frame.items[1].world_from_body =
        glm::translate(frame.items[1].world_from_body, Vec3f{0.0F, 0.5F, 0.0F});
    draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_cached, 1U);
}

}  // namespace
}  // namespace plumbline::render
