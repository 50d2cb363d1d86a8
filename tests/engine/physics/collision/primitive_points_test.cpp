#include "engine/physics/collision/primitive_points.h"

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
        for (BodyRecord* body : {&a, &b})
            body->traits.primitive = {.kind = Primitive::Kind::Box,
                                      .half_m = {0.5_r, 0.5_r, 0.5_r}};
    }

    /// Points on b's upper face, at these places.
    void find(std::initializer_list<Vec2> places, Real merge_m = 0) {
        PrimitiveContact found{.same_m = 0.1_r};
        for (const Vec2& place : places)
            found.list[found.count++] = {{0, 1, 0}, {place.x, 0.5_r, place.y}, -0.01_r};
        renew_points(manifold, found, merge_m);
    }
};

TEST(PrimitivePoints, LieOnBothBodies) {
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

TEST(PrimitivePoints, FoundAgainKeepTheirFeaturesAndLoads) {
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

TEST(PrimitivePoints, AreNewWhereNoneWasNear) {
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

TEST(PrimitivePoints, OneThatBecomesTwoGivesBothItsLoad) {
    TwoCubes cubes;
    cubes.find({{0, 0}});
    cubes.manifold.points[0].load.normal_N = 7;
    cubes.find({{0.02_r, 0}, {-0.02_r, 0}});
    ASSERT_EQ(cubes.manifold.points.size(), 2U);
    EXPECT_EQ(cubes.manifold.points[0].feature, 1U);
    EXPECT_EQ(cubes.manifold.points[1].feature, 2U) << "no two have the same";
    for (const ManifoldPoint& point : cubes.manifold.points) EXPECT_EQ(point.load.normal_N, 7);
}

TEST(PrimitivePoints, NearOnesAreOne) {
    TwoCubes cubes;
    cubes.find({{0, 0}, {0.3_r, 0}, {0.01_r, 0}}, 0.02_r);
    ASSERT_EQ(cubes.manifold.points.size(), 2U);
    EXPECT_EQ(cubes.manifold.points[0].b.surface_m.x, 0.01_r) << "the latter, in the first's place";
    EXPECT_EQ(cubes.manifold.points[1].b.surface_m.x, 0.3_r);
}

TEST(PrimitivePoints, GoWhenNoneIsFound) {
    TwoCubes cubes;
    cubes.find({{0, 0}, {0.3_r, 0}});
    cubes.find({});
    EXPECT_TRUE(cubes.manifold.points.empty());
    cubes.find({{0, 0}});
    EXPECT_EQ(cubes.manifold.points[0].feature, 3U) << "a feature is never used again";
}

TEST(PrimitivePoints, ThatTheBodiesCannotCloseAreLeftOut) {
    TwoCubes cubes;
    Pair pair{.a = &cubes.a, .b = &cubes.b, .base_m = 0.02_r, .reach_m = 0.5_r, .boxes = true};
    const CollideStep step{.step_s = 0.1_r};
    cubes.motion_a.at.position_m.y = 1.1_r;
    // 0.1 m apart; 2 mm count anyway, as a tenth of base_m.
    cubes.motion_a.velocity_mps = {0, -0.97_r, 0};
    collide_primitives(pair, cubes.manifold, step);
    EXPECT_TRUE(cubes.manifold.points.empty());
    cubes.motion_a.velocity_mps = {0, -0.99_r, 0};
    collide_primitives(pair, cubes.manifold, step);
    EXPECT_EQ(cubes.manifold.points.size(), 4U);
}

}  // namespace
}  // namespace plumbline::physics
