#include "engine/render/culling/convex_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace plumbline::render {
namespace {

constexpr float kHalfAngle_rad = radians_from_degrees(20.0F);

Aabb lit_box(const Vec3f& center, float half = 0.5F) {
    return {.min = center - Vec3f{half}, .max = center + Vec3f{half}};
}

/// From the origin down -Z, 50 m far.
ConvexVolume beam() {
    return ConvexVolume::cone(Vec3f{0.0F}, Vec3f{0.0F, 0.0F, -1.0F}, kHalfAngle_rad, 50.0F);
}

/// A camera at the origin that looks down -Z, 90 degrees each way: at 10 m, 10 m are a half image.
Mat4f camera() {
    return glm::perspective(glm::half_pi<float>(), 1.0F, 0.1F, 100.0F);
}

TEST(ConvexVolume, ReachesWhatTouchesItsCone) {
    // At 10 m the cone is 10 tan 20 deg = 3.64 m wide to each side.
    EXPECT_TRUE(beam().reaches(lit_box({0.0F, 0.0F, -10.0F})));
    EXPECT_TRUE(beam().reaches(lit_box({4.0F, 0.0F, -10.0F})));
    EXPECT_FALSE(beam().reaches(lit_box({5.0F, 0.0F, -10.0F})));
    EXPECT_FALSE(beam().reaches(lit_box({0.0F, 0.0F, 5.0F})));
    EXPECT_FALSE(beam().reaches(lit_box({0.0F, 0.0F, -51.0F})));
    EXPECT_FALSE(beam().reaches(Aabb{}));
}

TEST(ConvexVolume, ReachesEverythingWhenItIsNearlyAHalfSpace) {
    const ConvexVolume wide = ConvexVolume::cone(
        Vec3f{0.0F}, Vec3f{0.0F, 0.0F, -1.0F}, radians_from_degrees(85.0F), 50.0F);
    EXPECT_TRUE(wide.reaches(lit_box({0.0F, 0.0F, 5.0F})));
    EXPECT_FLOAT_EQ(wide.part_seen(lit_box({0.0F, 0.0F, -9.0F}), camera()).share(), 1.0F);
}

TEST(ConvexVolume, LightsAWallThatCrossesItAsWideAsItsCone) {
    const Aabb wall{.min = {-100.0F, -100.0F, -10.001F}, .max = {100.0F, 100.0F, -10.0F}};
    const ClipRect lit = beam().part_seen(wall, camera());
    // The pyramid's edges stand out of the cone by 1 / cos 22.5 deg.
    const float edge = std::tan(kHalfAngle_rad) / std::cos(radians_from_degrees(22.5F));
    EXPECT_NEAR(lit.min.x, -edge, 1e-3F);
    EXPECT_NEAR(lit.max.x, edge, 1e-3F);
    EXPECT_NEAR(lit.max.y, edge, 1e-3F);
    EXPECT_NEAR(lit.share(), edge * edge, 1e-3F);
}

TEST(ConvexVolume, LightsNothingOfABoxBesideIt) {
    EXPECT_TRUE(beam().part_seen(lit_box({30.0F, 0.0F, -10.0F}), camera()).empty());
    EXPECT_TRUE(beam().part_seen(lit_box({0.0F, 0.0F, 10.0F}), camera()).empty());
}

/// Whatever the beam, the box and the camera: a place in the cone, in the box and in the image
/// lies in the part that is told.
TEST(ConvexVolume, MissesNoLitPlace) {
    std::mt19937 random(7);
    const auto in = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    int seen = 0;
    for (int round = 0; round < 60; ++round) {
        const Vec3f from{in(-2.0F, 2.0F), in(-2.0F, 2.0F), in(-2.0F, 2.0F)};
        const Vec3f along = glm::normalize(Vec3f{in(-0.6F, 0.6F), in(-0.6F, 0.6F), -1.0F});
        const float half_rad = in(0.1F, 1.2F);
        const ConvexVolume light = ConvexVolume::cone(from, along, half_rad, 30.0F);
        const Vec3f corner{in(-20.0F, 5.0F), in(-20.0F, 5.0F), in(-30.0F, 0.0F)};
        const Aabb box{.min = corner,
                       .max = corner + Vec3f{in(0.1F, 30.0F), in(0.1F, 30.0F), in(0.1F, 30.0F)}};
        const ClipRect lit = light.part_seen(box, camera());
        for (int i = 0; i < 500; ++i) {
            const Vec3f place =
                glm::mix(box.min, box.max, Vec3f{in(0.0F, 1.0F), in(0.0F, 1.0F), in(0.0F, 1.0F)});
            const Vec3f away = place - from;
            const bool in_cone = glm::length(away) < 30.0F &&
                                 glm::dot(away, along) > glm::length(away) * std::cos(half_rad);
            const Vec4f clip = camera() * Vec4f{place, 1.0F};
            const Vec2f at = Vec2f{clip} / clip.w;
            const bool in_image =
                clip.z > -clip.w && glm::abs(at.x) < 1.0F && glm::abs(at.y) < 1.0F;
            if (!in_cone || !in_image) continue;
            ++seen;
            EXPECT_TRUE(light.reaches(box));
            EXPECT_GE(at.x, lit.min.x - 1e-4F);
            EXPECT_LE(at.x, lit.max.x + 1e-4F);
            EXPECT_GE(at.y, lit.min.y - 1e-4F);
            EXPECT_LE(at.y, lit.max.y + 1e-4F);
        }
    }
    EXPECT_GT(seen, 1000);
}

TEST(ConvexVolume, APrismHoldsWhatLiesInItsBoundsAlongItsAxes) {
    std::mt19937 random(11);
    const auto in = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    for (int round = 0; round < 200; ++round) {
        const Vec3f along = glm::normalize(Vec3f{in(-1, 1), in(-1, 1), in(-1, 1)});
        const Mat3f axes = axes_along(along);
        const Aabb bounds{.min = Vec3f{-1.0F, -2.0F, -3.0F}, .max = Vec3f{2.0F, 3.0F, 4.0F}};
        const ConvexVolume prism = ConvexVolume::prism(along, bounds);
        const Vec3f there{in(-4, 6), in(-4, 6), in(-5, 8)};
        const bool inside = glm::all(glm::greaterThan(there, bounds.min)) &&
                            glm::all(glm::lessThan(there, bounds.max));
        EXPECT_EQ(prism.reaches(lit_box(glm::transpose(axes) * there, 1e-4F)), inside);
        EXPECT_NEAR(glm::distance(axes * along, Vec3f{0.0F, 0.0F, 1.0F}), 0.0F, 1e-5F);
    }
}

TEST(ConvexVolume, TellsWhichPartOfTheImageShowsABox) {
    const ClipRect part =
        part_seen({.min = {-5.0F, 0.0F, -20.0F}, .max = {5.0F, 5.0F, -10.0F}}, camera());
    EXPECT_NEAR(part.min.x, -0.5F, 1e-5F);
    EXPECT_NEAR(part.max.x, 0.5F, 1e-5F);
    EXPECT_NEAR(part.min.y, 0.0F, 1e-5F);
    EXPECT_NEAR(part.max.y, 0.5F, 1e-5F);
    EXPECT_TRUE(part_seen(lit_box({0.0F, 0.0F, 9.0F}), camera()).empty());
}

}  // namespace
}  // namespace plumbline::render
