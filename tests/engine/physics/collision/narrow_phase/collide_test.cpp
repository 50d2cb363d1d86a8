#include "engine/physics/collision/narrow_phase/collide.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Real kCollideNear = sizeof(Real) == sizeof(float) ? 1e-6_r : 1e-13_r;
using Kind = ConvexShape::Kind;

const ConvexShape kCube{.kind = Kind::Box, .half_m = {0.5_r, 0.5_r, 0.5_r}};
const ConvexShape kMarble{.kind = Kind::Sphere, .radius_m = 0.25_r};
const ConvexShape kRod{.kind = Kind::Capsule, .radius_m = 0.1_r, .half_height_m = 0.4_r};

/// Turned about z by `turn_rad`.
Transform placed_at(const Vec3& position_m, Real turn_rad = 0) {
    const Real c = std::cos(turn_rad);
    const Real s = std::sin(turn_rad);
    return {.rotation = Mat3{c, s, 0, -s, c, 0, 0, 0, 1}, .position_m = position_m};
}

void expect_vector_near(const Vec3& found, const Vec3& wanted) {
    EXPECT_NEAR(glm::distance(found, wanted), 0, 4 * kCollideNear)
        << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(Collide, AStackedCubeHasFourPointsOnTheLower) {
    const Transform low = placed_at({0, 0, 0});
    const Transform high = placed_at({0.2_r, 1.01_r, 0});
    const ConvexContact found = collide({kCube, high}, {kCube, low}, 0.05_r);
    ASSERT_EQ(found.points().size(), 4U);
    for (const ConvexPoint& point : found.points()) {
        expect_vector_near(point.normal, {0, 1, 0});
        EXPECT_NEAR(point.on_b.y, 0.5_r, kCollideNear);
        EXPECT_NEAR(point.distance_m, 0.01_r, kCollideNear);
        // The common face reaches from -0.3 to 0.5.
        EXPECT_NEAR(std::abs(point.on_b.x - 0.1_r), 0.4_r, kCollideNear);
        EXPECT_NEAR(std::abs(point.on_b.z), 0.5_r, kCollideNear);
    }
    EXPECT_NEAR(found.same_m, 0.1_r, kCollideNear) << "a fifth of the half edge";
    EXPECT_TRUE(collide({kCube, high}, {kCube, low}, 0.009_r).points().empty());
}

TEST(Collide, ASphereHasOnePointWhicheverComesFirst) {
    const Transform cube = placed_at({1, 0, 0});
    const Transform marble = placed_at({1.1_r, 0.7_r, 0.2_r});
    const auto first = collide({kMarble, marble}, {kCube, cube}, 0);
    ASSERT_EQ(first.points().size(), 1U);
    expect_vector_near(first.list[0].normal, {0, 1, 0});
    expect_vector_near(first.list[0].on_b, {1.1_r, 0.5_r, 0.2_r});
    EXPECT_NEAR(first.list[0].distance_m, -0.05_r, kCollideNear);
    const auto second = collide({kCube, cube}, {kMarble, marble}, 0);
    ASSERT_EQ(second.points().size(), 1U);
    expect_vector_near(second.list[0].normal, {0, -1, 0});
    expect_vector_near(second.list[0].on_b, {1.1_r, 0.45_r, 0.2_r});
    EXPECT_EQ(second.list[0].distance_m, first.list[0].distance_m);
}

TEST(Collide, TwoSpheresHaveAPointOnTheLineOfTheirCentres) {
    const ConvexShape ball{.kind = Kind::Sphere, .radius_m = 0.75_r};
    const Transform low = placed_at({1, 2, 3}, 0.3_r);
    // 3-4-5: the centres are 1.25 m apart, the surfaces a quarter.
    const Transform high = placed_at({1.75_r, 3, 3}, 1.1_r);
    const auto first = collide({kMarble, high}, {ball, low}, 0.251_r);
    ASSERT_EQ(first.points().size(), 1U);
    expect_vector_near(first.list[0].normal, {0.6_r, 0.8_r, 0});
    expect_vector_near(first.list[0].on_b, {1.45_r, 2.6_r, 3});
    EXPECT_NEAR(first.list[0].distance_m, 0.25_r, 4 * kCollideNear);
    const auto second = collide({ball, low}, {kMarble, high}, 0.251_r);
    expect_vector_near(second.list[0].normal, {-0.6_r, -0.8_r, 0});
    expect_vector_near(second.list[0].on_b, {1.6_r, 2.8_r, 3});
    EXPECT_TRUE(collide({kMarble, high}, {ball, low}, 0.249_r).points().empty());
}

TEST(Collide, SpheresWithOneCentrePartAlongX) {
    const Transform there = placed_at({1, 2, 3});
    const auto found = collide({kMarble, there}, {kMarble, there}, 0);
    ASSERT_EQ(found.points().size(), 1U);
    expect_vector_near(found.list[0].normal, {1, 0, 0});
    expect_vector_near(found.list[0].on_b, {1.25_r, 2, 3});
    EXPECT_NEAR(found.list[0].distance_m, -0.5_r, kCollideNear);
}

TEST(Collide, ALyingCapsuleHasAPointUnderEachEnd) {
    constexpr Real kQuarter = 1.5707963267948966_r;
    const Transform rod = placed_at({0, 0.59_r, 0.1_r}, kQuarter);
    const Transform cube = placed_at({0, 0, 0});
    const auto found = collide({kRod, rod}, {kCube, cube}, 0);
    ASSERT_EQ(found.points().size(), 2U);
    // Its own +Y points along -x: the lower end is at +0.4.
    expect_vector_near(found.list[0].on_b, {0.4_r, 0.5_r, 0.1_r});
    expect_vector_near(found.list[1].on_b, {-0.4_r, 0.5_r, 0.1_r});
    for (const ConvexPoint& point : found.points())
        EXPECT_NEAR(point.distance_m, -0.01_r, 4 * kCollideNear);
}

TEST(Collide, ACapsuleAcrossAnEdgeHasAPointBetweenItsEnds) {
    // At 45 degrees across the edge at (0.5, 0.5): the axis is 0.09 m from it, nearest at its middle.
    constexpr Real kEighth = 0.7853981633974483_r;
    const Real out_m = 0.09_r * std::sqrt(0.5_r);
    const Transform rod = placed_at({0.5_r + out_m, 0.5_r + out_m, 0}, kEighth);
    const Transform cube = placed_at({0, 0, 0});
    const auto found = collide({kRod, rod}, {kCube, cube}, 0);
    ASSERT_EQ(found.points().size(), 1U) << "the ends are 0.25 m away";
    EXPECT_NEAR(found.list[0].distance_m, -0.01_r, 1e-5_r);
    EXPECT_NEAR(glm::distance(found.list[0].on_b, Vec3{0.5_r, 0.5_r, 0}), 0, 1e-5_r);
    EXPECT_EQ(collide({kRod, rod}, {kCube, cube}, 1).points().size(), 3U);
}

TEST(TouchingCenter, IsOnTheAxisOfWhatIsRound) {
    const Transform at = placed_at({1, 2, 3});
    const Vec3 side{1, 0, 0};
    // 1 mm beside the sphere's surface: the centre is the sphere's own all the same.
    expect_vector_near(round_side({kMarble, at}, {1.251_r, 2, 3}, side).center, {1, 2, 3});
    expect_vector_near(round_side({kRod, at}, {1.1_r, 2.3_r, 3.001_r}, side).center, {1, 2.3_r, 3});
    expect_vector_near(round_side({kCube, at}, {1.5_r, 2.3_r, 3}, side).center, {1.5_r, 2.3_r, 3});
}

}  // namespace
}  // namespace plumbline::physics
