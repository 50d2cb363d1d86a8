#include "engine/physics/collision/pair_points.h"

#include "engine/physics/world/body_record.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace plumbline::physics {
namespace {

/// Two cubes with a manifold between, a's lower face on b's upper one.
struct TwoCubes {
    BodyMotion motion_a{.at = {.position_m = {0, 1, 0}}};
    BodyMotion motion_b;
    BodyRecord a;
    BodyRecord b;
    Manifold manifold{.a = &a, .b = &b};

    TwoCubes() {
        a.motion = &motion_a;
        b.motion = &motion_b;
        const ConvexShape cube{.kind = ConvexShape::Kind::Box, .half_m = {0.5_r, 0.5_r, 0.5_r}};
        for (BodyRecord* body : {&a, &b}) {
            body->kind = BodyKind::Dynamic;
            body->traits.radius_m = 0.87_r;
            body->traits.geometry =
                std::make_shared<const BodyGeometry>(BodyGeometry{.parts = {{.shape = cube}}});
        }
    }

    /// Points on b's upper face, at these places.
    void find(std::initializer_list<Vec2> places) {
        std::vector<ConvexPoint> found;
        for (const Vec2& place : places)
            found.push_back({{0, 1, 0}, {place.x, 0.5_r, place.y}, -0.01_r});
        renew_points(manifold, {}, found, 0.1_r);
    }
};

TEST(PairPoints, LieOnBothBodies) {
    TwoCubes cubes;
    // A quarter turn about y: its x is the world's -z.
    cubes.motion_b.at.rotation = Mat3{0, 0, -1, 0, 1, 0, 1, 0, 0};
    cubes.motion_b.at.position_m = {0.125_r, 0, 0};
    cubes.find({{0.25_r, 0.5_r}});
    ASSERT_EQ(cubes.manifold.points.size(), 1U);
    const ManifoldPoint& point = cubes.manifold.points[0];
    EXPECT_EQ(point.normal_world, (Vec3{0, 1, 0}));
    EXPECT_EQ(point.distance_m, -0.01_r);
    EXPECT_EQ(point.b.surface_m, (Vec3{0.25_r, 0.5_r, 0.5_r}));
    EXPECT_EQ(point.b.offset_m, (Vec3{0.125_r, 0.5_r, 0.5_r}));
    EXPECT_EQ(point.b.local_m, (Vec3{-0.5_r, 0.5_r, 0.125_r}));
    EXPECT_EQ(point.a.surface_m, (Vec3{0.25_r, 0.5_r - 0.01_r, 0.5_r}));
    EXPECT_EQ(point.a.radius_m, 0);
    EXPECT_EQ(point.feature, 1U);
    EXPECT_EQ(point.age_steps, 0);
}

TEST(PairPoints, FoundAgainKeepTheirFeaturesAndLoads) {
    TwoCubes cubes;
    cubes.find({{0.5_r, 0.5_r}, {-0.5_r, 0.5_r}});
    for (ManifoldPoint& point : cubes.manifold.points) {
        point.load.normal_N = static_cast<Real>(point.feature);
        point.normal_Ns = 5;
    }
    // In another order, 5 cm further; and one that was not there.
    cubes.find({{-0.45_r, 0.5_r}, {0.5_r, -0.5_r}, {0.5_r, 0.45_r}});
    const auto& points = cubes.manifold.points;
    ASSERT_EQ(points.size(), 3U);
    const std::uint32_t features[]{2, 3, 1};
    const Real loads_N[]{2, 0, 1};
    const int ages[]{1, 0, 1};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(points[i].feature, features[i]) << i;
        EXPECT_EQ(points[i].load.normal_N, loads_N[i]) << i;
        EXPECT_EQ(points[i].age_steps, ages[i]) << i;
        EXPECT_EQ(points[i].normal_Ns, 0) << "of the step that is to come";
    }
}

TEST(PairPoints, AreNewWhereNoneWasNear) {
    TwoCubes cubes;
    cubes.find({{0, 0}});
    cubes.manifold.points[0].load.normal_N = 7;
    cubes.find({{0.15_r, 0}});
    EXPECT_EQ(cubes.manifold.points[0].feature, 2U) << "more than same_m on either body";
    EXPECT_EQ(cubes.manifold.points[0].load.normal_N, 0);
    // The lower body goes along: on it the point has not moved.
    cubes.motion_b.at.position_m.x = 0.15_r;
    cubes.find({{0.3_r, 0}});
    EXPECT_EQ(cubes.manifold.points[0].feature, 2U);
}

TEST(PairPoints, OneThatBecomesTwoGivesBothItsLoad) {
    TwoCubes cubes;
    cubes.find({{0, 0}});
    cubes.manifold.points[0].load.normal_N = 7;
    cubes.find({{0.02_r, 0}, {-0.02_r, 0}});
    ASSERT_EQ(cubes.manifold.points.size(), 2U);
    EXPECT_EQ(cubes.manifold.points[0].feature, 1U);
    EXPECT_EQ(cubes.manifold.points[1].feature, 2U) << "no two have the same";
    for (const ManifoldPoint& point : cubes.manifold.points) EXPECT_EQ(point.load.normal_N, 7);
}

TEST(PairPoints, GoWhenNoneIsFound) {
    TwoCubes cubes;
    cubes.find({{0, 0}, {0.3_r, 0}});
    cubes.find({});
    EXPECT_TRUE(cubes.manifold.points.empty());
    cubes.find({{0, 0}});
    EXPECT_EQ(cubes.manifold.points[0].feature, 3U) << "a feature is never used again";
}

TEST(PairPoints, ThatTheBodiesCannotCloseAreLeftOut) {
    TwoCubes cubes;
    Pair pair{.a = &cubes.a, .b = &cubes.b, .base_m = 0.02_r, .reach_m = 0.5_r};
    const CollideStep step{.step_s = 0.1_r};
    cubes.motion_a.at.position_m.y = 1.1_r;
    // 0.1 m apart; 2 mm count anyway, as a tenth of base_m.
    cubes.motion_a.velocity_mps = {0, -0.97_r, 0};
    find_points(pair, step);
    EXPECT_FALSE(pair.touches);
    cubes.motion_a.velocity_mps = {0, -0.99_r, 0};
    find_points(pair, step);
    ASSERT_EQ(pair.manifolds.size(), 1U);
    EXPECT_EQ(pair.manifolds[0].points.size(), 4U);
}

}  // namespace
}  // namespace plumbline::physics
