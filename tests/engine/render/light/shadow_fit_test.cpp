#include "engine/render/light/shadow_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::uint32_t kSize_px = 1024;
constexpr float kDistance_m = 60.0F;
const Vec3f kSun = glm::normalize(Vec3f{-0.4F, -1.0F, -0.3F});

ViewShape view_at(const Vec3f& position, const Vec3f& forward) {
    return {.position_world = position,
            .forward_world = glm::normalize(forward),
            .fov_y_rad = radians_from_degrees(60.0F),
            .aspect = 16.0F / 9.0F};
}

Vec3f clip_of(const SunShadowFit& fit, const Vec3f& point_world) {
    return Vec3f{fit.clip_from_world * Vec4f{point_world, 1.0F}};
}

TEST(SunShadowFit, CoversAllInSightWithinTheDistance) {
    for (int step = 0; step < 40; ++step) {
        const float angle = 0.4F * static_cast<float>(step);
        const ViewShape view = view_at({3.7F * static_cast<float>(step), 1.7F, -2.0F},
                                       {std::sin(angle), 0.3F * std::cos(angle), std::cos(angle)});
        const SunShadowFit fit = fit_sun_shadow(view, kSun, kDistance_m, kSize_px);
        const Vec3f right = glm::normalize(glm::cross(view.forward_world, Vec3f{0.0F, 1.0F, 0.0F}));
        const Vec3f up = glm::cross(right, view.forward_world);
        const float tan_y = std::tan(view.fov_y_rad * 0.5F);
        for (const float x : {-1.0F, 0.0F, 1.0F}) {
            for (const float y : {-1.0F, 0.0F, 1.0F}) {
                const Vec3f ray = glm::normalize(
                    view.forward_world + right * (x * tan_y * view.aspect) + up * (y * tan_y));
                for (const float distance_m : {0.0F, 30.0F, kDistance_m}) {
                    const Vec3f clip = clip_of(fit, view.position_world + ray * distance_m);
                    EXPECT_LE(std::abs(clip.x), 1.0F);
                    EXPECT_LE(std::abs(clip.y), 1.0F);
                    EXPECT_LE(std::abs(clip.z), 1.0F);
                }
            }
        }
    }
}

TEST(SunShadowFit, MovesByWholeTexelsOnly) {
    const SunShadowFit first =
        fit_sun_shadow(view_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F}), kSun, kDistance_m, kSize_px);
    for (int step = 1; step < 60; ++step) {
        const SunShadowFit fit = fit_sun_shadow(
            view_at({0.731F * static_cast<float>(step), 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}),
            kSun,
            kDistance_m,
            kSize_px);
        EXPECT_FLOAT_EQ(fit.texel_m, first.texel_m);
        const Vec3f shift_px = (clip_of(fit, Vec3f{0.0F}) - clip_of(first, Vec3f{0.0F})) *
                               (static_cast<float>(kSize_px) * 0.5F);
        EXPECT_NEAR(shift_px.x, std::round(shift_px.x), 2e-2F);
        EXPECT_NEAR(shift_px.y, std::round(shift_px.y), 2e-2F);
    }
}

// However the camera moves and turns: texels keep their size, and stay where they are in the world.
TEST(SunShadowFit, TurningShiftsItByWholeTexelsToo) {
    const SunShadowFit first =
        fit_sun_shadow(view_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F}), kSun, kDistance_m, kSize_px);
    int moved = 0;
    for (int step = 1; step < 200; ++step) {
        const float t = static_cast<float>(step);
        const Vec3f forward{
            std::sin(0.37F * t), 0.9F * std::sin(0.23F * t), std::cos(0.37F * t) + 0.01F};
        const Vec3f position{0.013F * t, 1.7F, 2.0F * std::sin(0.1F * t)};
        const SunShadowFit fit =
            fit_sun_shadow(view_at(position, forward), kSun, kDistance_m, kSize_px);
        EXPECT_EQ(fit.texel_m, first.texel_m);
        // The matrices are the same but for a shift: every direction stays one.
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(fit.clip_from_world[axis], first.clip_from_world[axis]);
        const Vec3f shift_px = (clip_of(fit, Vec3f{0.0F}) - clip_of(first, Vec3f{0.0F})) *
                               (static_cast<float>(kSize_px) * 0.5F);
        EXPECT_NEAR(shift_px.x, std::round(shift_px.x), 2e-2F);
        EXPECT_NEAR(shift_px.y, std::round(shift_px.y), 2e-2F);
        moved += std::abs(shift_px.x) + std::abs(shift_px.y) > 0.5F ? 1 : 0;
    }
    EXPECT_GT(moved, 50);
}

TEST(SunShadowFit, StaysPutWhileTheCameraMovesLittle) {
    // A step is an eighth of the map: on a 120 m walk of 600 frames the map moves a dozen times.
    int moves = 0;
    Mat4f before{0.0F};
    for (int step = 0; step < 600; ++step) {
        const SunShadowFit fit = fit_sun_shadow(
            view_at({0.2F * static_cast<float>(step), 1.7F, 0.0F}, {0.0F, 0.0F, -1.0F}),
            kSun,
            kDistance_m,
            kSize_px);
        if (fit.clip_from_world != before) ++moves;
        before = fit.clip_from_world;
    }
    EXPECT_GE(moves, 8);
    EXPECT_LE(moves, 40);
}

TEST(SunShadowFit, DepthsStayWhileTheCameraGoesFar) {
    // With the light, 60 m off: 1.98 (2 * 8 / 7 - 1) radii are one step.
    const SunShadowFit first =
        fit_sun_shadow(view_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F}), kSun, kDistance_m, kSize_px);
    const float radius_m = first.texel_m * static_cast<float>(kSize_px) * 0.5F * 7.0F / 8.0F;
    const float step_m = 1.98F * (2.0F * 8.0F / 7.0F - 1.0F) * radius_m;
    std::vector<float> places_m;
    float before = clip_of(first, Vec3f{0.0F}).z;
    for (float way_m = 0.0F; way_m < 3.0F * step_m; way_m += 0.1F) {
        const SunShadowFit fit =
            fit_sun_shadow(view_at(kSun * way_m, {0.0F, 0.0F, -1.0F}), kSun, kDistance_m, kSize_px);
        const float z = clip_of(fit, Vec3f{0.0F}).z;
        if (z != before) places_m.push_back(way_m);
        before = z;
    }
    ASSERT_EQ(places_m.size(), 3U);
    EXPECT_NEAR(places_m[1] - places_m[0], step_m, 0.2F);
    EXPECT_NEAR(places_m[2] - places_m[1], step_m, 0.2F);
}

TEST(SunShadowFit, PutsWhatIsNearerTheLightInFront) {
    const SunShadowFit fit = fit_sun_shadow(
        view_at(Vec3f{0.0F}, {0.0F, 0.0F, -1.0F}), {0.0F, -1.0F, 0.0F}, kDistance_m, kSize_px);
    EXPECT_LT(clip_of(fit, {0.0F, 5.0F, 0.0F}).z, clip_of(fit, {0.0F, 0.0F, 0.0F}).z);
}

TEST(SunShadowFit, OneCascadesCoordinatesLeadToAnothers) {
    const ViewShape view = view_at({12.3F, 1.7F, -4.0F}, {0.3F, -0.2F, 1.0F});
    const SunShadowFit near = fit_sun_shadow(view, kSun, 20.0F, kSize_px);
    const SunShadowFit far = fit_sun_shadow(view, kSun, 140.0F, kSize_px);
    const Vec4f lead = cascade_from_first(near, far);
    EXPECT_NEAR(lead.w, 20.0F / 140.0F, 1e-4F);
    for (const Vec3f& point : {Vec3f{0.0F}, Vec3f{30.0F, 2.0F, -50.0F}, Vec3f{-8.0F, 9.0F, 3.0F}}) {
        const Vec3f in_near = clip_of(near, point) * 0.5F + 0.5F;
        const Vec3f in_far = clip_of(far, point) * 0.5F + 0.5F;
        EXPECT_LT(glm::distance(in_near * lead.w + Vec3f{lead}, in_far), 1e-4F);
    }
}

// Equal ratios from 4 m on weigh 0.85, equal lengths 0.15.
TEST(SunShadowFit, CascadesEndWhereThePracticalSplitSchemeSays) {
    const auto mean = [](double by_ratio_m, double by_length_m) {
        return static_cast<float>(0.85 * by_ratio_m + 0.15 * by_length_m);
    };
    EXPECT_NEAR(cascade_end_m(0, 2, 256.0F), mean(32.0, 130.0), 1e-3F);
    EXPECT_NEAR(cascade_end_m(0, 3, 500.0F), mean(20.0, 4.0 + 496.0 / 3.0), 1e-3F);
    EXPECT_NEAR(cascade_end_m(1, 3, 500.0F), mean(100.0, 4.0 + 2.0 * 496.0 / 3.0), 1e-3F);
    EXPECT_NEAR(cascade_end_m(2, 4, 1024.0F), mean(256.0, 769.0), 1e-2F);
    // Of a model on a table all is smaller, and the shares are the same.
    EXPECT_NEAR(cascade_end_m(0, 2, 1.0F) / cascade_end_m(0, 2, 0.001F), 1000.0F, 0.1F);
}

// As the shader chooses: by the distance from the eye, and up to a tenth earlier at the borders.
TEST(SunShadowFit, WhateverIsSeenWithinTheDistanceLiesInItsCascade) {
    for (std::uint32_t count = 1; count <= 4; ++count) {
        for (int step = 0; step < 12; ++step) {
            const float angle = 0.55F * static_cast<float>(step);
            const ViewShape view =
                view_at({9.3F * static_cast<float>(step), 1.7F, -31.0F},
                        {std::sin(angle), 0.4F * std::cos(2.0F * angle), std::cos(angle)});
            const Vec3f right =
                glm::normalize(glm::cross(view.forward_world, Vec3f{0.0F, 1.0F, 0.0F}));
            const Vec3f up = glm::cross(right, view.forward_world);
            const float tan_y = std::tan(view.fov_y_rad * 0.5F);
            for (float distance_m = 0.1F; distance_m <= 300.0F; distance_m *= 1.05F) {
                for (const float sooner : {1.0F, 1.1F}) {
                    std::uint32_t i = 0;
                    while (i + 1 < count && distance_m * sooner > cascade_end_m(i, count, 300.0F))
                        ++i;
                    const SunShadowFit fit =
                        fit_sun_shadow(view, kSun, cascade_end_m(i, count, 300.0F), kSize_px);
                    for (const float x : {-1.0F, 0.3F, 1.0F}) {
                        for (const float y : {-1.0F, 1.0F}) {
                            const Vec3f ray = glm::normalize(view.forward_world +
                                                             right * (x * tan_y * view.aspect) +
                                                             up * (y * tan_y));
                            const Vec3f clip =
                                glm::abs(clip_of(fit, view.position_world + ray * distance_m));
                            ASSERT_LE(std::max({clip.x, clip.y, clip.z}), 1.0F)
                                << count << " cascades, " << distance_m << " m off";
                        }
                    }
                }
            }
        }
    }
}

TEST(SunShadowFit, CascadesEndAtTheDistanceAndGrow) {
    EXPECT_FLOAT_EQ(cascade_end_m(0, 1, 34.0F), 34.0F);
    for (std::uint32_t count = 2; count <= 4; ++count) {
        float before = 0.0F;
        float length = 0.0F;
        for (std::uint32_t i = 0; i < count; ++i) {
            const float end = cascade_end_m(i, count, 140.0F);
            EXPECT_GT(end - before, length);
            length = end - before;
            before = end;
        }
        EXPECT_FLOAT_EQ(before, 140.0F);
    }
}

TEST(SpotShadowFit, SeesTheWholeConeAndNotMuchMore) {
    const float outer_rad = 0.38F;
    const Vec3f position{1.0F, 2.0F, 3.0F};
    const Vec3f direction = glm::normalize(Vec3f{0.2F, -0.5F, -1.0F});
    const Mat4f clip_from_world = fit_spot_shadow(position, direction, outer_rad, 30.0F);
    const Vec3f side = glm::normalize(glm::cross(direction, Vec3f{0.0F, 1.0F, 0.0F}));
    const auto reach = [&](float angle_rad) {
        const Vec3f ray = direction * std::cos(angle_rad) + side * std::sin(angle_rad);
        const Vec4f clip = clip_from_world * Vec4f{position + ray * 10.0F, 1.0F};
        return std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w;
    };
    EXPECT_NEAR(reach(0.0F), 0.0F, 1e-5F);
    EXPECT_LT(reach(outer_rad), 1.0F);
    EXPECT_GT(reach(outer_rad + 0.05F), 1.0F);
}

}  // namespace
}  // namespace plumbline::render
