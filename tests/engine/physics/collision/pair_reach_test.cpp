#include "engine/physics/collision/pair_reach.h"

#include "engine/physics/world/body_record.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr Real kReachNear = sizeof(Real) == sizeof(float) ? 1e-6_r : 1e-13_r;

/// Two bodies of 0.5 m in steps of 0.1 s; a goes at 2 m/s towards b, along -y.
struct Closing {
    BodyMotion motion_a{.velocity_mps = {0, -2, 0}, .inverse_mass = 1};
    BodyMotion motion_b{.inverse_mass = 3};
    BodyRecord a;
    BodyRecord b;
    Pair pair{.a = &a, .b = &b, .base_m = 0.02_r, .touches = true};
    CollideStep step{.step_s = 0.1_r, .drop_m = 0.01_r};

    Closing() {
        a.motion = &motion_a;
        b.motion = &motion_b;
        for (BodyRecord* body : {&a, &b}) {
            body->kind = BodyKind::Dynamic;
            body->traits.radius_m = 0.5_r;
        }
    }

    /// A point between them, this far apart.
    Manifold point_at(Real distance_m) {
        Manifold manifold{.a = &a, .b = &b};
        ManifoldPoint& point = manifold.points.emplace_back();
        point.distance_m = distance_m;
        point.a.surface_m = {0, distance_m, 0};
        return manifold;
    }
};

TEST(Reach, GrowsByWhatBodiesCoverInAStep) {
    Closing bodies;
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.002_r + 0.21_r, kReachNear);
    bodies.motion_b.spin_radps = {0, 0, 0.4_r};
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.002_r + 0.23_r, kReachNear) << "its rim";
    bodies.motion_a.velocity_mps = {0, -20, 0};
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.002_r + 0.25_r, kReachNear)
        << "farther ones are swept, from a quarter of a radius each";
    bodies.pair.round = true;
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.02_r + 2.03_r, kReachNear);
}

TEST(Reach, OfSlowPairsIsTheBase) {
    Closing bodies;
    bodies.motion_a.velocity_mps = {};
    bodies.pair.round = true;
    EXPECT_EQ(reach_of(bodies.pair, bodies.step), 0.02_r);
    bodies.pair.round = false;
    EXPECT_NEAR(near_m(bodies.pair), 0.002_r, kReachNear);
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.002_r + 0.01_r, kReachNear);
}

TEST(Reach, GrowsByPredictedChanges) {
    Closing bodies;
    bodies.pair.round = true;
    EXPECT_FALSE(knows_less(bodies.pair, bodies.step));
    bodies.b.small.predicted.change_mps = {0, 0, 0.5_r};
    EXPECT_EQ(predicted_mps(bodies.pair), 0.5_r);
    EXPECT_NEAR(reach_of(bodies.pair, bodies.step), 0.02_r + 0.26_r, kReachNear);
    EXPECT_TRUE(knows_less(bodies.pair, bodies.step));
    bodies.pair.predicted_mps = 0.45_r;
    EXPECT_FALSE(knows_less(bodies.pair, bodies.step)) << "5 mm are within half the base";
}

TEST(Reachable, IsWhatBodiesCloseInTheStep) {
    Closing bodies;
    const auto reachable = [&bodies](Real distance_m) {
        const Manifold manifold = bodies.point_at(distance_m);
        return is_reachable(manifold, manifold.points[0], 0.02_r, bodies.step);
    };
    EXPECT_TRUE(reachable(0.229_r)) << "0.02 + 0.2 + 0.01";
    EXPECT_FALSE(reachable(0.231_r));
    bodies.motion_a.velocity_mps = {0, 2, 0};
    EXPECT_TRUE(reachable(0.029_r)) << "parting ones too may fall";
    EXPECT_FALSE(reachable(0.031_r));
}

TEST(Reachable, IsNoPointThatItsBodiesLeft) {
    Closing bodies;
    Manifold manifold = bodies.point_at(0);
    manifold.points[0].a.surface_m.x = 0.019_r;
    EXPECT_TRUE(is_reachable(manifold, manifold.points[0], 0.02_r, bodies.step));
    manifold.points[0].a.surface_m.x = 0.021_r;
    EXPECT_FALSE(is_reachable(manifold, manifold.points[0], 0.02_r, bodies.step));
}

TEST(Impact, IsSharedByMass) {
    Closing bodies;
    bodies.pair.reach_m = 0.23_r;
    bodies.pair.manifolds.push_back(bodies.point_at(0.1_r));
    bodies.pair.manifolds[0].material.restitution = 0.5_r;
    // 2 m/s, and half of it back: 3 m/s. a has three times the mass of b.
    const PairImpact impact = impact_of(bodies.pair, bodies.step);
    EXPECT_NEAR(impact.on_a.change_mps.y, 0.75_r, kReachNear);
    EXPECT_NEAR(impact.on_b.change_mps.y, -2.25_r, kReachNear);
    EXPECT_FALSE(impact.on_a.backed);
}

TEST(Impact, OnWhatGivesWayToNothingIsAllTheOthers) {
    Closing bodies;
    bodies.pair.reach_m = 0.23_r;
    bodies.motion_b.inverse_mass = 0;
    bodies.pair.manifolds.push_back(bodies.point_at(0.1_r));
    const PairImpact impact = impact_of(bodies.pair, bodies.step);
    EXPECT_NEAR(impact.on_a.change_mps.y, 2, kReachNear);
    EXPECT_TRUE(impact.on_a.backed);
    EXPECT_EQ(impact.on_b.change_mps, (Vec3{0, 0, 0}));
}

TEST(Impact, IsNoneOfBodiesThatDoNotMeet) {
    Closing bodies;
    bodies.pair.reach_m = 0.23_r;
    bodies.pair.manifolds.push_back(bodies.point_at(0.21_r));
    EXPECT_EQ(impact_of(bodies.pair, bodies.step).on_a.change_mps, (Vec3{0, 0, 0}));
}

}  // namespace
}  // namespace plumbline::physics
