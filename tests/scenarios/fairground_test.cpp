// The fairground keeps its promises: its chairs hang as far out as the ride's speed says, and what
// nobody touches stands.
#include "engine/physics/totals.h"
#include "tests/scenarios/scene_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace plumbline {
namespace {

using test::SceneRun;

constexpr int kChairs = 10;

class Fairground : public testing::Test {
protected:
    SceneRun run_{"fairground.toml"};

    void SetUp() override { ASSERT_TRUE(run_.simulation); }
    physics::PhysicsWorld& world() { return run_.simulation->physics; }
    /// Of each chair, at its centre of mass: tan of how far its chains hang out, and w^2 r / g.
    void expect_angles(Real speed_radps, Real within) {
        const Vec3 mast = run_.state("ride_crown").world_from_body.position;
        for (int i = 1; i <= kChairs; ++i) {
            const std::string name = fmt::format("ride_chair_{}", i);
            const ecs::Entity chair = run_.simulation->find(name);
            const physics::BodyId body = run_.simulation->registry.get<scene::BodyRef>(chair).body;
            const Pose at = run_.state(name).world_from_body;
            const Vec3 drop = at.orientation * world().state(body).mass.center_of_mass_m;
            const Vec3 hook = at.position - mast;
            const Vec3 outward = glm::normalize(Vec3{hook.x, 0, hook.z});
            const Vec3 middle = hook + drop;
            const Real radius_m = std::hypot(middle.x, middle.z);
            const Real tangent = glm::dot(drop, outward) / -drop.y;
            EXPECT_NEAR(tangent, speed_radps * speed_radps * radius_m / 9.81_r, within) << name;
        }
    }
};

TEST_F(Fairground, ChairsHangAsFarOutAsTheRideIsFast) {
    EXPECT_TRUE(run_.simulation->warnings.empty());
    run_.step(60 * 20);
    EXPECT_NEAR(run_.state("ride_crown").angular_velocity_radps.y, 1.15, 0.005);
    expect_angles(1.15_r, 0.015_r);
    // Slower, they swing until the 3 N m of their hooks have stopped them: those are 0.4 degrees of
    // what the weight of a chair turns back with.
    for (const scene::SceneJoint& joint : run_.simulation->joints()) {
        if (joint.name == "ride_axle")
            world().set_joint_motor(joint.joint, physics::JointMotor{.target = 0.6_r, .max = 1500});
    }
    run_.step(60 * 120);
    EXPECT_NEAR(run_.state("ride_crown").angular_velocity_radps.y, 0.6, 0.005);
    expect_angles(0.6_r, 0.015_r);
    EXPECT_LT(max_joint_error_m(world()), 1e-3);
}

TEST_F(Fairground, WhatNobodyTouchesStandsAndSleeps) {
    // Cylinders are met by Bullet's detector, whose points in float64 let a tin wobble longer.
    constexpr Real kCreep_m = std::is_same_v<Real, double> ? 0.005_r : 0.003_r;
    std::vector<Vec3> start;
    const auto& moving = run_.simulation->moving_bodies();
    for (const scene::MovingBody& one : moving)
        start.push_back(world().state(one.body).world_from_body.position);
    run_.step(60 * 10);
    EXPECT_EQ(awake_count(world()), std::size_t{1 + kChairs}) << "the ride, and no more";
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const auto& name = run_.simulation->registry.get<scene::Name>(moving[i].entity);
        EXPECT_FALSE(name.label.empty()) << name.text;
        if (name.text.starts_with("ride_")) continue;
        const Vec3 end = world().state(moving[i].body).world_from_body.position;
        EXPECT_LT(glm::distance(end, start[i]), kCreep_m) << name.text;
    }
    EXPECT_LT(max_penetration_m(world()), 0.002);
}

}  // namespace
}  // namespace plumbline
