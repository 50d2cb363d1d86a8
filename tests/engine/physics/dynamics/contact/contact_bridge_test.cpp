// What a manifold hands to the solver and gets back, on numbers that are exact in float32.
#include "engine/physics/dynamics/contact/contact_bridge.h"

#include <gtest/gtest.h>

namespace plumbline::physics {
namespace {

constexpr Real kLong_s = 0.25_r;
constexpr Real kShort_s = 0.125_r;

ManifoldPoint point_at(Real x, Real carried_N) {
    ManifoldPoint point;
    point.a.offset_m = {x, -1, 0};
    point.b.offset_m = {x, 1, 0};
    point.distance_m = -0.5_r;
    point.load.normal_N = carried_N;
    point.age_steps = 5;
    return point;
}

Manifold manifold_with(std::vector<ManifoldPoint> points) {
    Manifold manifold;
    manifold.points = std::move(points);
    return manifold;
}

/// A step whose solver answers with `normal_Ns` at every point.
/// The step of this number.
void step(ContactBridge& bridge, std::uint64_t number, Manifold& manifold, Real h, Real normal_Ns) {
    ContactSet contacts;
    bridge.begin_island(number);
    bridge.add(manifold, {.a = 1, .b = kWorldBody}, h, contacts);
    for (ContactConstraint& constraint : contacts.constraints) {
        constraint.normal_Ns = Lanes{};
        for (int i = 0; i < constraint.count; ++i)
            constraint.normal_Ns[static_cast<std::size_t>(i)] = normal_Ns;
        constraint.total_Ns = constraint.normal_Ns;
    }
    bridge.write_back(contacts, h);
}

TEST(ContactBridge, WarmStartFitsSubstepsOfAnyLength) {
    ContactBridge bridge;
    Manifold manifold = manifold_with({point_at(0, 0), point_at(1, 0)});
    step(bridge, 1, manifold, kLong_s, 2);
    EXPECT_EQ(manifold.points[0].load.normal_N, 8);  // 2 N s in 0.25 s
    EXPECT_EQ(manifold.points[0].normal_Ns, 2);
    ContactSet contacts;
    bridge.begin_island(2);
    bridge.add(manifold, {.a = 1, .b = kWorldBody}, kShort_s, contacts);
    ASSERT_EQ(contacts.constraints.size(), 1U);
    EXPECT_EQ(contacts.constraints[0].count, 2);
    EXPECT_EQ(contacts.constraints[0].normal_Ns[0], 1);  // 8 N for 0.125 s
    EXPECT_EQ(contacts.constraints[0].start_separation_m[1], -0.5_r);
}

TEST(ContactBridge, WhatGivesWayToNothingIsABlocksB) {
    ContactBridge bridge;
    Manifold manifold = manifold_with({point_at(0, 4)});
    manifold.points[0].normal_world = {0, -1, 0};
    manifold.points[0].a.radius_m = 3;
    ContactSet contacts;
    bridge.begin_island(1);
    bridge.add(manifold, {.a = kWorldBody, .b = 2, .a_moves = false}, kLong_s, contacts);
    const ContactConstraint& constraint = contacts.constraints.front();
    EXPECT_EQ(constraint.a, 2U);
    EXPECT_EQ(constraint.b, kWorldBody);
    EXPECT_EQ(constraint.normal, (Vec3{0, 1, 0}));
    EXPECT_EQ(constraint.radius_b, 3);
    EXPECT_EQ(lane(constraint.offset_b, 0), manifold.points[0].a.offset_m);
    const auto tangents = tangents_of({0, -1, 0});
    EXPECT_EQ(constraint.tangent[0], -tangents[0]);
    EXPECT_EQ(constraint.tangent[1], -tangents[1]);
}

TEST(ContactBridge, NewPointsShareWhatLostOnesCarried) {
    ContactBridge bridge;
    Manifold manifold = manifold_with({point_at(0, 0), point_at(1, 0)});
    step(bridge, 1, manifold, kLong_s, 2);  // 8 N each
    manifold.points.pop_back();
    for (const Real x : {2.0_r, 3.0_r}) {
        manifold.points.push_back(point_at(x, 0));
        manifold.points.back().age_steps = 0;
    }
    ContactSet contacts;
    bridge.begin_island(2);
    bridge.add(manifold, {.a = 1, .b = kWorldBody}, kLong_s, contacts);
    const Lanes& normal_Ns = contacts.constraints.front().normal_Ns;
    EXPECT_EQ(normal_Ns[0], 2);  // its own 8 N
    EXPECT_EQ(normal_Ns[1], 1);  // half of the 8 N that went
    EXPECT_EQ(normal_Ns[2], 1);
}

TEST(ContactBridge, AStepWithoutThePairForgetsItsLastingLoad) {
    ContactBridge bridge;
    Manifold manifold = manifold_with({point_at(0, 0)});
    for (std::uint64_t i = 1; i <= 12; ++i) step(bridge, i, manifold, kLong_s, 2);
    bridge.begin_island(13);
    EXPECT_EQ(bridge.lasting_load_N(manifold), 8);
    bridge.begin_island(14);
    EXPECT_EQ(bridge.lasting_load_N(manifold), 0);
}

TEST(ContactBridge, MorePointsThanLanesMakeSeveralBlocks) {
    ContactBridge bridge;
    Manifold manifold;
    for (int i = 0; i < 9; ++i) manifold.points.push_back(point_at(static_cast<Real>(i), 0));
    step(bridge, 1, manifold, kLong_s, 2);
    EXPECT_EQ(bridge.point_count(), 9U);
    for (const ManifoldPoint& point : manifold.points) EXPECT_EQ(point.load.normal_N, 8);
    EXPECT_EQ(manifold.load.normal_N, 72);
}

}  // namespace
}  // namespace plumbline::physics
