#include "engine/study/scenarios/world/scenario_world.h"

#include "engine/physics/totals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace plumbline::study {
namespace {

TEST(ScenarioWorld, RemembersWhatMoves) {
    ScenarioWorld world(Setting{});
    world.floor();
    world.room(5);
    world.kinematic_box({0, 3, 0}, {1, 1, 1});
    EXPECT_TRUE(world.movers.empty());
    const auto ball = world.sphere({0, 2, 0}, 0.1, {.mass_kg = 3, .velocity_mps = {1, 0, 0}});
    const auto box = world.box({2, 2, 0}, {1, 1, 1});
    EXPECT_EQ(world.movers, (std::vector<physics::BodyId>{ball, box}));
    EXPECT_EQ(world.velocity(ball), (Vec3d{1, 0, 0}));
    EXPECT_EQ(world.physics.state(ball).mass.mass_kg, Real{3});
    EXPECT_EQ(body_count(world.physics), 10U) << "floor, six walls, three";
}

// Walls give back all: a ball goes to and fro between them for ever.
TEST(ScenarioWorld, ARoomHasWallsAllRoundThatGiveEverythingBack) {
    ScenarioWorld world(Setting{.step_hz = 240, .substeps = 4}, {0, 0, 0});
    world.room(1);
    const auto ball = world.sphere({0, 0, 0}, 0.1, {.restitution = 1, .velocity_mps = {2, 3, -5}});
    world.run(20);
    for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(world.at(ball)[axis]), 0.95) << axis;
    EXPECT_NEAR(glm::length(world.velocity(ball)), std::sqrt(38.0), 0.02);
}

TEST(ScenarioWorld, SaysWhenSomethingIsNoNumberAnyMore) {
    ScenarioWorld world(Setting{});
    const auto ball = world.sphere({0, 0, 0}, 0.1);
    const auto pivot = world.join({.kind = physics::JointKind::BallAndSocket, .a = ball});
    world.run(0.1);
    EXPECT_FALSE(world.broken());
    EXPECT_LT(world.joint(pivot).error_m, 1e-6);
    world.physics.set_velocity(ball, {std::numeric_limits<Real>::quiet_NaN(), 0, 0}, {0, 0, 0});
    world.run(0.1);
    EXPECT_TRUE(world.broken());
    EXPECT_TRUE(std::isnan(world.joint(pivot).error_m)) << "it went with its body";
}

TEST(ScenarioWorld, StepsAreWholeAndRounded) {
    ScenarioWorld world(Setting{.step_hz = 60}, {0, 0, 0});
    const auto ball = world.sphere({0, 0, 0}, 0.1, {.velocity_mps = {60, 0, 0}});
    world.run(0.99 / 60);
    EXPECT_NEAR(world.at(ball).x, 1, 1e-5);
    world.run(0.4 / 60);
    EXPECT_NEAR(world.at(ball).x, 1, 1e-5) << "less than half a step is none";
}

}  // namespace
}  // namespace plumbline::study
