// What cannot move, where the light's view goes aside.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

/// Pillars that cannot move and a box that does, on a floor, seen from above.
class ShadowStaticsGl : public ImageGl {
protected:
    static constexpr std::uint32_t kSide_px = 200;
    static constexpr std::size_t kMover = 0;
    static constexpr std::size_t kPillar = 2;
    static constexpr std::uint32_t kPillars = 15 * 15;

    void SetUp() override {
        ImageGl::SetUp();
        frame_ = empty_frame(kSide_px, kSide_px);
        frame_.camera.fov_y_rad = 0.8F;
        add_box(frame_, Vec3f{2.0F}, {0.0F, 2.0F, 0.0F}, matt({0.8F, 0.1F, 0.1F}));
        add_box(frame_, {300.0F, 1.0F, 300.0F}, {0.0F, -0.5F, 0.0F}, matt(Vec3f{0.8F}));
        for (int x = -7; x <= 7; ++x) {
            for (int z = -7; z <= 7; ++z)
                add_box(frame_,
                        {1.0F, 4.0F, 1.0F},
                        {5.0F * static_cast<float>(x) + 0.7F * static_cast<float>(z % 3),
                         2.0F,
                         5.0F * static_cast<float>(z)},
                        matt(Vec3f{0.5F}));
        }
        for (DrawItem& item : frame_.items) item.is_static = true;
        frame_.items[kMover].is_static = false;
        frame_.sun = DirectionalLight{.direction_world = glm::normalize(Vec3f{0.6F, -1.0F, 0.2F}),
                                      .radiance = Vec3f{3.0F}};
        frame_.sun_shadow = SunShadow{.size_px = kMap_px, .distance_m = 80.0F};
        look_from(Vec3f{0.0F});
    }

    void look_from(const Vec3f& place) {
        frame_.camera = camera_at(place + Vec3f{0.0F, 40.0F, 0.01F}, place);
        frame_.camera.fov_y_rad = 0.8F;
    }

    void move_box(float x) {
        frame_.items[kMover].world_from_body = glm::translate(Mat4f{1.0F}, {x, 2.0F, 1.0F});
    }

    /// The same with a map that keeps nothing of the one before.
    assets::ImageData draw_anew() {
        frame_.sun_shadow->size_px = kMap_px / 2;
        draw(frame_);
        frame_.sun_shadow->size_px = kMap_px;
        return draw(frame_);
    }

    static int count_differing(const assets::ImageData& a, const assets::ImageData& b) {
        int count = 0;
        for (std::uint32_t y = 0; y < kSide_px; ++y) {
            for (std::uint32_t x = 0; x < kSide_px; ++x)
                count += std::abs(pixel_at(a, x, y).g - pixel_at(b, x, y).g) > 2 ? 1 : 0;
        }
        return count;
    }

    static constexpr std::uint32_t kMap_px = 1024;
    RenderFrame frame_;
};

TEST_F(ShadowStaticsGl, AStepAsideDrawsWhatComesIntoViewAndShowsTheSame) {
    draw(frame_);
    const auto whole = renderer_->stats().triangles;
    int steps = 0;
    // There and back on a slant: to the right and the left, up and down.
    for (int i = 1; i <= 24; ++i) {
        const float way_m = 2.7F * static_cast<float>(i <= 12 ? i : 24 - i);
        look_from({way_m, 0.0F, -0.6F * way_m});
        move_box(0.1F * static_cast<float>(i));
        const auto shown = draw(frame_);
        const auto drawn = renderer_->stats().triangles;
        const auto anew = draw_anew();
        // Without a step only what moves is drawn; the image has up to half of the triangles.
        const auto all = renderer_->stats().triangles;
        EXPECT_LT(drawn, all - kPillars * 12U / 4U) << i;
        steps += drawn + kPillars * 12U > all ? 1 : 0;
        EXPECT_LE(count_differing(shown, anew), 2) << i;
    }
    EXPECT_GT(whole, kPillars * 12U);
    EXPECT_GT(steps, 3);
}

TEST_F(ShadowStaticsGl, WhatChangesWithAStepIsDrawnWhereverItIs) {
    draw(frame_);
    for (int i = 1; i <= 5; ++i) {
        look_from({14.0F * static_cast<float>(i % 2), 0.0F, 0.0F});
        DrawItem& pillar = frame_.items[kPillar + kPillars / 2];  // in the middle
        pillar.world_from_body = glm::translate(
            Mat4f{1.0F}, {1.0F + static_cast<float>(i), 2.0F, static_cast<float>(i)});
        const auto shown = draw(frame_);
        EXPECT_EQ(count_differing(shown, draw_anew()), 0) << i;
    }
}

TEST_F(ShadowStaticsGl, AnotherLightOrAJumpLeavesNothingOfTheOldMap) {
    draw(frame_);
    frame_.sun->direction_world = glm::normalize(Vec3f{0.61F, -1.0F, 0.2F});
    const auto turned = draw(frame_);
    EXPECT_EQ(count_differing(turned, draw_anew()), 0);
    look_from({-400.0F, 0.0F, 0.0F});
    draw(frame_);
    look_from(Vec3f{0.0F});
    const auto back = draw(frame_);
    EXPECT_EQ(count_differing(back, draw_anew()), 0);
}

TEST_F(ShadowStaticsGl, WhereDepthsChangeAllIsDrawn) {
    frame_.sun->direction_world = glm::normalize(Vec3f{1.0F, -0.35F, 0.1F});
    frame_.sun_shadow->distance_m = 55.0F;
    int drawn_whole = 0;
    for (int i = 1; i <= 12; ++i) {
        // Steps in depth are 81 m: the first one is 41 m along the light, about here.
        look_from({38.0F + static_cast<float>(i), 0.0F, 0.0F});
        const auto shown = draw(frame_);
        const auto drawn = renderer_->stats().triangles;
        const auto anew = draw_anew();
        if (i > 1 && drawn == renderer_->stats().triangles) ++drawn_whole;
        EXPECT_LE(count_differing(shown, anew), 2) << i;
    }
    EXPECT_EQ(drawn_whole, 1);
}

}  // namespace
}  // namespace plumbline::render
