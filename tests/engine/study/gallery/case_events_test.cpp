// Events of a hard case: done before the step that begins at their time, once.
#include "engine/study/gallery/case_events.h"

#include "engine/physics/totals.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

using scene::CaseEventKind;
using scene::HardCaseEvent;
using scene::SceneDescription;
using test::cube;
using test::scene_of;

constexpr double kMass_kg = 1000;  // of a cube

struct PlayedCase : test::Running {
    explicit PlayedCase(const SceneDescription& description) : test::Running(description) {
        play_case_events(*simulation);
    }
};

/// One cube afloat, and what happens to it.
SceneDescription afloat(const HardCaseEvent& event) {
    SceneDescription scene = scene_of({cube("cube", {0, 5, 0}), cube("other", {20, 5, 0})});
    scene.gravity_mps2 = {0, 0, 0};
    scene.hard_case = scene::HardCase{.id = "H1", .events = {event}};
    return scene;
}

Vec3d velocity(PlayedCase& run) {
    return Vec3d{run.state("cube").velocity_mps};
}

TEST(CaseEvents, ATeleportHappensOnceAtItsStep) {
    PlayedCase run(
        afloat({.kind = CaseEventKind::Teleport, .of = "cube", .at_s = 0.5, .value = {3, 4, 5}}));
    run.step(30);
    EXPECT_EQ(run.state("cube").world_from_body.position, (Vec3{0, 5, 0}));
    run.step(1);
    EXPECT_EQ(run.state("cube").world_from_body.position, (Vec3{3, 4, 5}));
    run->physics.set_pose(run.body("cube"), {{7, 7, 7}, {}});
    run.step(1);
    EXPECT_EQ(run.state("cube").world_from_body.position, (Vec3{7, 7, 7}));
}

TEST(CaseEvents, WhatIsPastDoesNotHappenAgain) {
    for (const double start_s : {0.45, 0.55}) {
        PlayedCase run(afloat(
            {.kind = CaseEventKind::Teleport, .of = "cube", .at_s = 0.5, .value = {3, 4, 5}}));
        run->set_time(start_s);
        run.step(6);
        const Vec3 expected = start_s < 0.5 ? Vec3{3, 4, 5} : Vec3{0, 5, 0};
        EXPECT_EQ(run.state("cube").world_from_body.position, expected) << start_s;
    }
    // A force that still acts goes on.
    PlayedCase run(afloat({.kind = CaseEventKind::Force,
                           .of = "cube",
                           .at_s = 0.5,
                           .duration_s = 1,
                           .value = {6000, 0, 0}}));
    run->set_time(1);
    run.step(60);
    EXPECT_NEAR(velocity(run).x, 6000 / kMass_kg * 0.5, 1e-4);
}

TEST(CaseEvents, AForceActsForItsTimeAndOneStepAtLeast) {
    const double step_s = 1.0 / 60;
    for (const double for_s : {0.0, 0.5}) {
        PlayedCase run(afloat({.kind = CaseEventKind::Force,
                               .of = "cube",
                               .at_s = 0.1,
                               .duration_s = for_s,
                               .value = {6000, 0, 0}}));
        run.step(60);
        const double expected = 6000 / kMass_kg * std::max(for_s, step_s);
        EXPECT_NEAR(velocity(run).x, expected, expected * 1e-5) << for_s << " s";
    }
}

TEST(CaseEvents, AnImpulseAsideTurnsTheBody) {
    PlayedCase run(afloat({.kind = CaseEventKind::Impulse,
                           .of = "cube",
                           .value = {1000, 0, 0},
                           .point_m = {0, 0.5_r, 0}}));
    run.step(1);
    EXPECT_NEAR(velocity(run).x, 1, 1e-5);
    // L = r x p = -500 about z; a cube of 1 m has I = m / 6.
    EXPECT_NEAR(static_cast<double>(run.state("cube").angular_velocity_radps.z), -3, 1e-4);
    EXPECT_NEAR(run->added_energy_J, 0.5 * 1000 + 0.5 * kMass_kg / 6 * 9, 1);
}

TEST(CaseEvents, VelocityGravityAndRemoval) {
    {
        PlayedCase run(afloat({.kind = CaseEventKind::Velocity,
                               .of = "cube",
                               .value = {1, 2, 3},
                               .angular_velocity_radps = {0, 1, 0}}));
        run.step(1);
        EXPECT_NEAR(glm::distance(velocity(run), Vec3d{1, 2, 3}), 0, 1e-5);
        EXPECT_NEAR(static_cast<double>(run.state("cube").angular_velocity_radps.y), 1, 1e-5);
    }
    {
        PlayedCase run(afloat({.kind = CaseEventKind::Gravity, .at_s = 0.5, .value = {0, 2, 0}}));
        run.step(90);
        EXPECT_NEAR(velocity(run).y, 2, 1e-4);
    }
    {
        PlayedCase run(afloat({.kind = CaseEventKind::Remove, .of = "cube", .at_s = 0.5}));
        run.step(30);
        EXPECT_EQ(body_count(run->physics), 2U);
        run.step(5);
        EXPECT_EQ(body_count(run->physics), 1U);
        EXPECT_EQ(run->moving_bodies().size(), 1U);
        EXPECT_FALSE(run->registry.alive(run->find("cube")));
    }
}

TEST(CaseEvents, WhatIsNotFiniteIsTakenOutAlone) {
    PlayedCase run(afloat({.kind = CaseEventKind::NotFinite, .of = "cube", .at_s = 0.1}));
    run.step(30);
    EXPECT_EQ(run->physics.report().isolated.size(), 1U);
    EXPECT_EQ(run.state("other").world_from_body.position, (Vec3{20, 5, 0}));
}

TEST(CaseEvents, AMotorIsSwitchedOff) {
    SceneDescription scene = afloat({.kind = CaseEventKind::MotorOff, .of = "axle", .at_s = 0.5});
    scene.joints = {{.name = "axle",
                     .kind = physics::JointKind::Hinge,
                     .a = "cube",
                     .b = "world",
                     .anchor_a_m = {0, 5, 0},
                     .anchor_b_m = {0, 5, 0},
                     .motor = physics::JointMotor{.target = 100, .max = 1000}}};
    PlayedCase run(scene);
    run.step(30);
    const physics::JointId axle = run->joints()[0].joint;
    EXPECT_TRUE(run->physics.joint(axle).def.motor);
    const Real spin = run.state("cube").angular_velocity_radps.y;
    run.step(30);
    EXPECT_FALSE(run->physics.joint(axle).def.motor);
    EXPECT_NEAR(run.state("cube").angular_velocity_radps.y, spin, 1e-3_r);
}

}  // namespace
}  // namespace plumbline::study
