#include "engine/core/pose.h"

#include "engine/core/random.h"
#include "tests/support/near.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline {
namespace {

using test::near;

// A few units in the last place of numbers of about ten.
constexpr double kTolerance = sizeof(Real) == 4 ? 2e-5 : 1e-13;

Vec3 random_vector(Random& random) {
    const auto number = [&] { return Real{random.uniform(-5.0F, 5.0F)}; };
    const Real x = number();
    const Real y = number();
    return {x, y, number()};
}

Pose random_pose(Random& random) {
    const Vec3 axis = normalize_or(random_vector(random), Vec3{1, 0, 0});
    const Real angle_rad = random.uniform(-3.0F, 3.0F);
    return {.position = random_vector(random), .orientation = glm::angleAxis(angle_rad, axis)};
}

TEST(Pose, TurnsThenMoves) {
    const Pose pose{.position = {10, 0, 0}, .orientation = glm::angleAxis(kPi / 2, Vec3{0, 1, 0})};
    // A quarter turn to the left takes what is ahead (-z) to the left (-x).
    EXPECT_TRUE(near(transform_point(pose, {0, 0, -1}), Vec3{9, 0, 0}, kTolerance));
}

TEST(Pose, ComposingIsApplyingOneAfterTheOther) {
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const Pose a_from_b = random_pose(random);
        const Pose b_from_c = random_pose(random);
        const Vec3 point_c = random_vector(random);
        EXPECT_TRUE(near(transform_point(compose(a_from_b, b_from_c), point_c),
                         transform_point(a_from_b, transform_point(b_from_c, point_c)),
                         kTolerance));
    }
}

TEST(Pose, InverseUndoes) {
    Random random(2);
    for (int i = 0; i < 100; ++i) {
        const Pose pose = random_pose(random);
        const Pose none = compose(invert(pose), pose);
        EXPECT_TRUE(near(none.position, Vec3{0, 0, 0}, kTolerance));
        EXPECT_TRUE(near(none.orientation, kNoRotation, kTolerance));
    }
}

TEST(Pose, BlendsBetweenItsEnds) {
    const Pose a{.position = {0, 0, 0}};
    const Pose b{.position = {4, 2, 0}, .orientation = glm::angleAxis(kPi / 2, Vec3{0, 1, 0})};
    const Pose middle = blend(a, b, 0.25_r);
    EXPECT_TRUE(near(middle.position, Vec3{1, 0.5_r, 0}, kTolerance));
    EXPECT_TRUE(near(middle.orientation, glm::angleAxis(kPi / 8, Vec3{0, 1, 0}), 10 * kTolerance));
    EXPECT_EQ(blend(a, b, Real{0}).position, a.position);
    EXPECT_EQ(blend(a, b, Real{1}).position, b.position);
}

TEST(Pose, BlendTakesTheShorterArc) {
    const Quat small = glm::angleAxis(0.2_r, Vec3{0, 0, 1});
    const Pose b{.orientation = -small};  // the same rotation, the long way round
    EXPECT_TRUE(near(
        blend({}, b, 0.5_r).orientation, glm::angleAxis(0.1_r, Vec3{0, 0, 1}), 10 * kTolerance));
}

TEST(Pose, MatrixDoesWhatThePoseDoes) {
    Random random(3);
    const Pose pose = random_pose(random);
    const Vec3 point = random_vector(random);
    const Vec3 scale{2, 3, 0.5_r};
    const Vec3f by_matrix{matrix_of(pose, scale) * Vec4f(Vec3f{point}, 1.0F)};
    const Vec3f by_pose{transform_point(pose, point * scale)};
    EXPECT_TRUE(near(by_matrix, by_pose, 1e-4));
}

TEST(Pose, KnowsWhenItIsBroken) {
    EXPECT_TRUE(is_finite(Pose{}));
    const Real nan = std::numeric_limits<Real>::quiet_NaN();
    EXPECT_FALSE(is_finite(Pose{.position = {0, nan, 0}}));
    EXPECT_FALSE(is_finite(Pose{.orientation = {1, 0, 0, std::numeric_limits<Real>::infinity()}}));
}

TEST(Math, EulerAnglesTurnAboutXThenYThenZ) {
    const Quat turned = quat_from_euler_deg({90, 90, 0});
    // About x takes y to z; about y then takes z to x.
    EXPECT_TRUE(near(turned * Vec3{0, 1, 0}, Vec3{1, 0, 0}, kTolerance));
    EXPECT_TRUE(near(quat_from_euler_deg({0, 0, 90}) * Vec3{1, 0, 0}, Vec3{0, 1, 0}, kTolerance));
}

TEST(Math, WhatHasNoDirectionGetsTheFallback) {
    EXPECT_EQ(normalize_or(Vec3{0, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 1, 0}));
    EXPECT_TRUE(near(normalize_or(Vec3{0, 0, 3}, Vec3{0, 1, 0}), Vec3{0, 0, 1}, kTolerance));
}

TEST(Math, DegreesAndRadians) {
    EXPECT_NEAR(radians_from_degrees(180.0), 3.14159265358979, 1e-13);
    EXPECT_NEAR(degrees_from_radians(radians_from_degrees(37.5)), 37.5, 1e-12);
}

TEST(Math, LiteralsHaveTheirFullPrecision) {
    static_assert(0.1_r == static_cast<Real>(0.1L));
#ifdef PL_DOUBLE_PRECISION
    static_assert(0.1_r != static_cast<double>(0.1F), "a widened float is not a tenth");
#endif
}

}  // namespace
}  // namespace plumbline
