#include "engine/physics/collision/manifold.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

void expect_frame(const Vec3& normal) {
    const auto [u, v] = tangents_of(normal);
    constexpr double kRounding = 4e-7;
    EXPECT_NEAR(static_cast<double>(glm::length(u)), 1, kRounding);
    EXPECT_NEAR(static_cast<double>(glm::dot(u, normal)), 0, kRounding);
    EXPECT_NEAR(static_cast<double>(glm::length(glm::cross(normal, u) - v)), 0, 2 * kRounding);
}

TEST(Tangents, MakeARightHandedFrameWithAnyNormal) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal{0, 0, 0};
        normal[axis] = 1;
        expect_frame(normal);
        expect_frame(-normal);
    }
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 direction{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (glm::length(direction) > 0.1_r) expect_frame(glm::normalize(direction));
    }
}

TEST(Manifold, TellsPointsByTheNearerOfTheirSides) {
    Manifold manifold;
    for (int i = 0; i < 6; ++i) {
        ManifoldPoint& point = manifold.points.emplace_back();
        point.a.local_m.x = static_cast<Real>(i);
        point.b.local_m.y = static_cast<Real>(10 * i);
    }
    ManifoldPoint sought;
    sought.a.local_m = {4.25_r, 0, 0};
    sought.b.local_m = {0, 20.5_r, 0};
    EXPECT_EQ(nearest_point(manifold.points, sought, 1), &manifold.points[4]);
    EXPECT_EQ(nearest_point(manifold.points, sought, 0.25_r), nullptr) << "nearer than that";
    sought.b.local_m = {0, 20.125_r, 0};
    EXPECT_EQ(nearest_point(manifold.points, sought, 1), &manifold.points[2]) << "on b";
}

TEST(Manifold, PutsTheLastPointWhereOneIsTakenOut) {
    Manifold manifold;
    for (const std::uint32_t feature : {1U, 2U, 3U, 4U}) manifold.points.push_back({feature});
    remove_point(manifold, 1);
    remove_point(manifold, 2);
    ASSERT_EQ(manifold.points.size(), 2U);
    EXPECT_EQ(manifold.points[0].feature, 1U);
    EXPECT_EQ(manifold.points[1].feature, 4U);
}

TEST(Manifold, ForgetsWhatItCarriedAndKeepsItsPoints) {
    Manifold manifold;
    manifold.points.push_back({.feature = 7, .distance_m = -0.01_r, .normal_Ns = 2});
    manifold.points.front().load = {.normal_N = 3, .friction_N = {1, 2}, .twist_Nm = 4};
    manifold.load = {.step = 9, .age_steps = 5, .normal_N = 3, .lasting_N = 3};
    forget_loads(manifold);
    ASSERT_EQ(manifold.points.size(), 1U);
    const ManifoldPoint& point = manifold.points.front();
    EXPECT_EQ(point.feature, 7U);
    EXPECT_EQ(point.distance_m, -0.01_r);
    EXPECT_EQ(point.normal_Ns, 0);
    EXPECT_EQ(point.load.normal_N, 0);
    EXPECT_EQ(point.load.friction_N[1], 0);
    EXPECT_EQ(point.load.twist_Nm, 0);
    EXPECT_EQ(manifold.load.step, 0U);
    EXPECT_EQ(manifold.load.lasting_N, 0);
}

}  // namespace
}  // namespace plumbline::physics
