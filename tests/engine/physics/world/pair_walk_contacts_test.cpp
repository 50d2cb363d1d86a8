// When two bodies have contact points, and how many.
#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

struct Floor {
    const char* name;
    ShapeDef shape;
    Real height_m;  ///< of its top
};

std::vector<Floor> floors() {
    return {{"plane", PlaneShape{}, 0},
            {"box", BoxShape{.size_m = {40, 1, 40}}, 0.5_r},
            {"mesh", flat_mesh(40, 1), 0}};
}

TEST(FastPairs, BallsMeetFloorsBeforeTheyTouch) {
    for (const Floor& floor : floors()) {
        SCOPED_TRACE(floor.name);
        TestWorld test(in_small_steps());
        test.add(floor.shape, {0, 0, 0}, {.kind = BodyKind::Static});
        // 4 m/s are 67 mm a step: 50 mm above the floor it must be seen, or it ends 17 mm inside.
        // Seen, it may go as far as half a sub-step.
        const BodyId ball = test.add(SphereShape{.radius_m = 0.1_r},
                                     {0.2_r, floor.height_m + 0.15_r, 0.3_r},
                                     {.kind = BodyKind::Dynamic, .velocity_mps = {0, -4, 0}});
        test.world.step();
        EXPECT_EQ(test.world.report().cost.contacts, 1U);
        EXPECT_GT(test.at(ball).y, static_cast<double>(floor.height_m) + 0.1 - 0.0085);
    }
}

TEST(FastPairs, BallsMeetBallsBeforeTheyTouch) {
    TestWorld test(in_small_steps());
    const BodyDef right{.kind = BodyKind::Dynamic, .velocity_mps = {4, 0, 0}};
    const BodyDef left{.kind = BodyKind::Dynamic, .velocity_mps = {-4, 0, 0}};
    // A gap of 0.1 m, closed at 8 m/s: within the step.
    const BodyId a = test.add(SphereShape{.radius_m = 0.1_r}, {-0.15_r, 5, 0}, right);
    const BodyId b = test.add(SphereShape{.radius_m = 0.1_r}, {0.15_r, 5, 0}, left);
    test.world.step();
    EXPECT_EQ(test.world.report().cost.contacts, 1U);
    EXPECT_GT(test.at(b).x - test.at(a).x, 0.2 - 0.017) << "33 mm where they are not seen";
}

TEST(FastPairs, WhatPassesByIsNotMet) {
    for (const Floor& floor : floors()) {
        SCOPED_TRACE(floor.name);
        TestWorld test(in_small_steps());
        test.add(floor.shape, {0, 0, 0}, {.kind = BodyKind::Static});
        test.add(SphereShape{.radius_m = 0.1_r},
                 {-3, floor.height_m + 0.15_r, 0.3_r},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0.5_r, 0}});
        test.world.step();
        EXPECT_EQ(test.world.report().cost.contacts, 0U);
        EXPECT_TRUE(test.world.report().islands.empty());
    }
}

TEST(FastPairs, SlowOnesAreMetOnlyWhereTheyNearlyTouch) {
    TestWorld test({.gravity_mps2 = {0, 0, 0}, .substeps = 4, .solver = Solver::SmallStep});
    test.ground();
    test.add(SphereShape{.radius_m = 0.1_r},
             {0, 0.15_r, 0},
             {.kind = BodyKind::Dynamic, .velocity_mps = {0, -0.01_r, 0}});
    test.world.step();
    EXPECT_EQ(test.world.report().cost.contacts, 0U);
}

TEST(FastPairs, ABlowIsHandedOnThroughARow) {
    // Six balls above each other, 1 cm apart, fall at 4.6 m/s. In one step the lowest meets the
    // floor and all the others what they stood still against a moment before.
    TestWorld test(in_small_steps(8));
    test.add(BoxShape{.size_m = {40, 1, 40}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static});
    std::vector<BodyId> balls;
    for (int i = 0; i < 6; ++i) {
        balls.push_back(test.add(SphereShape{.radius_m = 0.1_r},
                                 {0, 0.105_r + 0.21_r * static_cast<Real>(i), 0},
                                 {.kind = BodyKind::Dynamic, .velocity_mps = {0, -4.6_r, 0}}));
    }
    test.world.step();
    EXPECT_EQ(test.world.report().cost.contacts, 6U);
    double deepest = 0.1 - test.at(balls[0]).y;
    for (std::size_t i = 1; i < balls.size(); ++i) {
        deepest = std::max(deepest, 0.2 - (test.at(balls[i]).y - test.at(balls[i - 1]).y));
    }
    EXPECT_LT(deepest, 0.008) << "47 mm where the others are not seen";
}

TEST(FastPairs, NeighboursOfARowAreNot) {
    // Two rows side by side: what falls together does not meet sideways.
    TestWorld test(in_small_steps());
    test.add(BoxShape{.size_m = {40, 1, 40}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static});
    for (int i = 0; i < 8; ++i) {
        test.add(
            SphereShape{.radius_m = 0.1_r},
            {0.21_r * static_cast<Real>(i % 2), 0.105_r + 0.21_r * static_cast<Real>(i / 2), 0},
            {.kind = BodyKind::Dynamic, .velocity_mps = {0, -4.6_r, 0}});
    }
    test.world.step();
    EXPECT_EQ(test.world.report().cost.contacts, 8U);
    EXPECT_EQ(test.world.report().islands.size(), 2U);
}

TEST(RoundBodies, ARollingBallHasOnePoint) {
    for (const Floor& floor : floors()) {
        SCOPED_TRACE(floor.name);
        TestWorld test(in_small_steps());
        test.add(floor.shape, {0, 0, 0}, {.kind = BodyKind::Static});
        const BodyId ball = test.add(SphereShape{.radius_m = 0.3_r},
                                     {-10, floor.height_m + 0.3_r, 0.4_r},
                                     {.kind = BodyKind::Dynamic,
                                      .velocity_mps = {3, 0, 0},
                                      .angular_velocity_radps = {0, 0, -10}});
        std::uint32_t most = 0;
        for (int i = 0; i < 120; ++i) {
            test.world.step();
            most = std::max(most, test.world.report().cost.contacts);
        }
        EXPECT_LE(most, 2U) << "two only over a seam of the mesh";
        EXPECT_NEAR(test.velocity(ball).x, 3.0, 0.003);
    }
}

TEST(PairFilter, GroupsThatDoNotAgreeHaveNoPoints) {
    TestWorld test(in_small_steps());
    test.ground();
    const BodyId ghost =
        test.add(BoxShape{},
                 {0, 0.4_r, 0},
                 {.kind = BodyKind::Dynamic, .filter = {.group = 2, .collides_with = 2}});
    test.run(0.5);
    EXPECT_EQ(test.world.report().cost.contacts, 0U);
    EXPECT_LT(test.at(ghost).y, -0.5);
}

TEST(Compounds, AreMetByTheirParts) {
    TestWorld test(in_small_steps());
    test.ground();
    CompoundShape dumbbell;
    for (const Real x : {-0.5_r, 0.5_r}) {
        dumbbell.children.push_back(
            {.shape = SphereShape{.radius_m = 0.2_r}, .body_from_child = {.position = {x, 0, 0}}});
    }
    const BodyId body = test.add(dumbbell, {0, 0.25_r, 0});
    test.run(1.0);
    EXPECT_EQ(all_contacts(test.world).size(), 1U);
    EXPECT_NEAR(test.at(body).y, 0.2, 2e-3);
}

}  // namespace
}  // namespace plumbline::physics
