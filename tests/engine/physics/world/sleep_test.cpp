// Who falls asleep under small_step, who must not, and what wakes them.
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

/// A tower of boxes on the ground, run until it sleeps.
struct Asleep {
    TestWorld test{in_small_steps()};
    BodyId ground;
    std::vector<BodyId> tower;

    explicit Asleep(int height = 3, const BodyDef& def = {.kind = BodyKind::Dynamic})
        : ground(test.ground()) {
        for (int i = 0; i < height; ++i) {
            tower.push_back(test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0}, def));
        }
        test.run(2.0);
        EXPECT_EQ(test.world.awake_count(), 0U);
    }
    std::size_t awake_after_a_step() {
        test.world.step();
        return test.world.awake_count();
    }
};

// --- falling asleep

TEST(Sleep, WhatSleepsStandsStillToTheLastBitAndCostsNoWork) {
    Asleep asleep;
    const std::uint64_t before = asleep.test.hash(asleep.tower);
    for (int i = 0; i < 300; ++i) {
        asleep.test.world.step();
        EXPECT_EQ(asleep.test.world.cost().pairs, 0U);
        EXPECT_EQ(asleep.test.world.cost().row_solves, 0U);
        EXPECT_TRUE(asleep.test.world.islands().empty());
    }
    EXPECT_EQ(asleep.test.hash(asleep.tower), before);
    for (const BodyId id : asleep.tower) {
        EXPECT_FALSE(asleep.test.world.state(id).awake);
        EXPECT_EQ(asleep.test.velocity(id), (Vec3d{0, 0, 0}));
    }
}

TEST(Sleep, OneAwakeBodyLooksAtItsOwnPairsOnly) {
    Asleep asleep(10);
    asleep.test.add(BoxShape{}, {20, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .can_sleep = false});
    asleep.test.run(0.5);
    EXPECT_EQ(asleep.test.world.awake_count(), 1U);
    EXPECT_EQ(asleep.test.world.cost().pairs, 1U);
}

TEST(Sleep, AnIslandFallsAsleepAllAtOnce) {
    TestWorld test(in_small_steps());
    test.ground();
    for (int i = 0; i < 5; ++i) test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0});
    int steps = 0;
    for (; test.world.awake_count() > 0 && steps < 300; ++steps) {
        EXPECT_EQ(test.world.awake_count(), 5U);
        test.world.step();
    }
    EXPECT_GE(steps, 30) << "half a second at least";
    EXPECT_LT(steps, 90);
}

TEST(Sleep, OfThingsOfAnySize) {
    for (const Real size_m : {0.01_r, 0.1_r, 10.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground();
        const BodyId box = test.add(BoxShape{.size_m = {size_m, size_m, size_m}},
                                    {0, 0.55_r * size_m, 0},
                                    {.kind = BodyKind::Dynamic, .mass_kg = 2});
        test.run(3.0);
        EXPECT_FALSE(test.world.state(box).awake);
    }
}

TEST(Sleep, WhoMayNotKeepsItsIslandAwake) {
    TestWorld test(in_small_steps());
    test.ground();
    const BodyId insomniac =
        test.add(BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .can_sleep = false});
    const BodyId on_it = test.add(BoxShape{}, {0, 1.5_r, 0});
    const BodyId elsewhere = test.add(BoxShape{}, {5, 0.5_r, 0});
    test.run(3.0);
    EXPECT_TRUE(test.world.state(insomniac).awake);
    EXPECT_TRUE(test.world.state(on_it).awake);
    EXPECT_FALSE(test.world.state(elsewhere).awake);
}

// --- not falling asleep

TEST(SlowMotion, ASliderKeepsItsTenthOfAMetrePerSecond) {
    for (const Real size_m : {0.1_r, 1.0_r, 8.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground(0);
        const BodyId slider =
            test.add(BoxShape{.size_m = {size_m, size_m, size_m}},
                     {0, 0.5_r * size_m, 0},
                     {.kind = BodyKind::Dynamic, .velocity_mps = {0.1_r, 0, 0}, .friction = 0});
        test.run(10.0);
        EXPECT_NEAR(test.at(slider).x, 1.0, 1e-3);
    }
}

TEST(SlowMotion, ASpinnerKeepsItsHalfRadianPerSecond) {
    for (const Real size_m : {0.05_r, 1.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground(0);
        const BodyId spinner = test.add(
            BoxShape{.size_m = {size_m, size_m, size_m}},
            {0, 0.5_r * size_m, 0},
            {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 0.5_r, 0}, .friction = 0});
        test.run(10.0);
        EXPECT_NEAR(test.spin(spinner).y, 0.5, 1e-3);
    }
}

TEST(SlowMotion, ABallNearTheTopOfAnotherRollsOff) {
    TestWorld test(in_small_steps());
    test.add(SphereShape{}, {0, 0, 0}, {.kind = BodyKind::Static, .friction = 0});
    // 0.2 mm off the top: its speed doubles every sixth of a second, from next to nothing.
    const BodyId ball =
        test.add(SphereShape{}, {0.0002_r, 1, 0}, {.kind = BodyKind::Dynamic, .friction = 0});
    test.run(5.0);
    EXPECT_LT(test.at(ball).y, -1.0);
}

TEST(SlowMotion, AnInvertedPendulumFallsOver) {
    TestWorld test(in_small_steps());
    const double tilt_rad = 0.001;
    const BodyId bob =
        test.add(SphereShape{.radius_m = 0.05_r},
                 {static_cast<Real>(std::sin(tilt_rad)), static_cast<Real>(std::cos(tilt_rad)), 0});
    const auto pivot = test.world.create_joint({.kind = JointKind::BallAndSocket, .a = bob});
    ASSERT_TRUE(pivot.ok());
    double lowest = 1;
    for (int i = 0; i < 300; ++i) {
        test.world.step();
        lowest = std::min(lowest, test.at(bob).y);
    }
    EXPECT_LT(lowest, -0.9);
}

TEST(SlowMotion, ASlowCarrierKeepsItsLoad) {
    TestWorld test(in_small_steps());
    const BodyId platform =
        test.add(BoxShape{.size_m = {2, 0.2_r, 2}},
                 {0, -0.1_r, 0},
                 {.kind = BodyKind::Kinematic, .velocity_mps = {0.005_r, 0, 0}});
    const BodyId load = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(10.0);
    EXPECT_NEAR(test.at(load).x, test.at(platform).x, 1e-3);
    EXPECT_TRUE(test.world.state(load).awake);
    test.world.set_velocity(platform, {0, 0, 0}, {0, 0, 0});
    test.run(2.0);
    EXPECT_FALSE(test.world.state(load).awake);
}

TEST(SlowMotion, NothingSleepsInTheAir) {
    WorldDef def = in_small_steps();
    def.gravity_mps2 = {0, 0, 0};
    TestWorld test(def);
    const BodyId still = test.add(BoxShape{}, {0, 5, 0});
    const BodyId slow = test.add(
        SphereShape{}, {5, 5, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {0.001_r, 0, 0}});
    test.run(10.0);
    EXPECT_TRUE(test.world.state(still).awake);
    EXPECT_NEAR(test.at(slow).x, 5.01, 1e-6 + 10 * kRounding);
}

TEST(SlowMotion, WithoutGravityOnlyWhatRestsAgainstSomethingSleeps) {
    WorldDef def = in_small_steps();
    def.gravity_mps2 = {0, 0, 0};
    TestWorld test(def);
    test.ground();
    const BodyId still = test.add(BoxShape{}, {0, 0.5_r, 0});
    const BodyId sliding =
        test.add(BoxShape{},
                 {5, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {0.002_r, 0, 0}, .friction = 0});
    const BodyId pair_a = test.add(BoxShape{}, {0, 5, 0});
    const BodyId pair_b = test.add(BoxShape{}, {0, 6, 0});
    test.run(5.0);
    EXPECT_FALSE(test.world.state(still).awake);
    EXPECT_NEAR(test.at(sliding).x, 5.01, 1e-4);
    EXPECT_TRUE(test.world.state(pair_a).awake);
    EXPECT_TRUE(test.world.state(pair_b).awake);
}

// --- waking

TEST(Waking, WakesAllThatFellAsleepTogether) {
    Asleep asleep;
    asleep.test.world.wake(asleep.tower[2]);
    EXPECT_EQ(asleep.test.world.awake_count(), 3U);
    for (const BodyId id : asleep.tower) EXPECT_TRUE(asleep.test.world.state(id).awake);
}

TEST(Waking, ByForceImpulseVelocityPoseAndFreezing) {
    const std::vector<std::pair<const char*, void (*)(PhysicsWorld&, BodyId)>> calls{
        {"force",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_force(id, {0, 1, 0});
         }},
        {"torque",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_torque(id, {0, 1, 0});
         }},
        {"impulse",
         [](PhysicsWorld& world, BodyId id) {
             world.apply_impulse(id, {0, 1, 0});
         }},
        {"velocity",
         [](PhysicsWorld& world, BodyId id) {
             world.set_velocity(id, {0, 1, 0}, {0, 0, 0});
         }},
        {"pose",
         [](PhysicsWorld& world, BodyId id) {
             world.set_pose(id, {.position = {9, 9, 9}});
         }},
        {"freezing", [](PhysicsWorld& world, BodyId id) { world.set_frozen(id, true); }},
        {"destruction", [](PhysicsWorld& world, BodyId id) { world.destroy_body(id); }}};
    for (const auto& [name, call] : calls) {
        SCOPED_TRACE(name);
        Asleep asleep;
        call(asleep.test.world, asleep.tower[1]);
        asleep.test.world.step();
        EXPECT_TRUE(asleep.test.world.state(asleep.tower[0]).awake);
        EXPECT_TRUE(asleep.test.world.state(asleep.tower[2]).awake);
    }
}

TEST(Waking, ByTheLossOfTheGround) {
    Asleep asleep;
    asleep.test.world.destroy_body(asleep.ground);
    asleep.test.world.step();
    EXPECT_EQ(asleep.test.world.awake_count(), 3U);
    // g t^2 / 2 from the first step on: nobody hung in the air.
    const double start = asleep.test.at(asleep.tower[2]).y;
    asleep.test.run(1.0);
    EXPECT_NEAR(
        asleep.test.at(asleep.tower[2]).y, start - 0.5 * kG * (61.0 * 61.0 - 1) / 3600, 0.02);
}

TEST(Waking, ByAVisitorAndByAKinematicBodyButNotByOneThatStands) {
    Asleep asleep;
    const BodyId ram = asleep.test.add(BoxShape{}, {3, 0.5_r, 0}, {.kind = BodyKind::Kinematic});
    EXPECT_EQ(asleep.awake_after_a_step(), 0U);
    asleep.test.world.set_velocity(ram, {-1, 0, 0}, {0, 0, 0});
    asleep.test.run(1.5);
    EXPECT_EQ(asleep.test.world.awake_count(), 0U) << "half a metre off";
    asleep.test.run(1.0);
    EXPECT_EQ(asleep.test.world.awake_count(), 3U);
    EXPECT_LT(asleep.test.at(asleep.tower[0]).x, -0.3);

    Asleep visited;
    const BodyId ball =
        visited.test.add(SphereShape{.radius_m = 0.2_r},
                         {3, 0.5_r, 0},
                         {.kind = BodyKind::Dynamic, .velocity_mps = {-8, 1.6_r, 0}});
    static_cast<void>(ball);
    visited.test.run(0.5);
    EXPECT_EQ(visited.test.world.awake_count(), 4U);
}

TEST(Waking, ByAWallPutIntoIt) {
    Asleep asleep;
    asleep.test.add(BoxShape{.size_m = {1, 3, 1}}, {0.9_r, 1.5_r, 0}, {.kind = BodyKind::Static});
    EXPECT_EQ(asleep.awake_after_a_step(), 3U);
}

TEST(Waking, ByJoints) {
    Asleep asleep;
    const auto joint = asleep.test.world.create_joint({.kind = JointKind::BallAndSocket,
                                                       .a = asleep.tower[2],
                                                       .anchor_a_world = {0, 3, 0},
                                                       .anchor_b_world = {0, 3, 0}});
    ASSERT_TRUE(joint.ok());
    EXPECT_EQ(asleep.awake_after_a_step(), 3U);
}

TEST(Waking, DoesNotMakeAPileJump) {
    TestWorld test(in_small_steps());
    test.ground();
    std::vector<BodyId> pile;
    for (int i = 0; i < 27; ++i) {
        const Vec3 at{static_cast<Real>(i % 3),
                      0.5_r + static_cast<Real>(i / 9),
                      static_cast<Real>(i / 3 % 3)};
        pile.push_back(
            test.add(BoxShape{}, 1.02_r * at, {.kind = BodyKind::Dynamic, .mass_kg = 50}));
    }
    test.run(4.0);
    ASSERT_EQ(test.world.awake_count(), 0U);
    for (const BodyId id : pile) test.world.wake(id);
    double fastest = 0;
    for (int i = 0; i < 30; ++i) {
        test.world.step();
        for (const BodyId id : pile) fastest = std::max(fastest, glm::length(test.velocity(id)));
    }
    EXPECT_LT(fastest, 2e-3);
}

// --- events

TEST(SleepingContacts, StayListedAndDoNotBeginAnew) {
    Asleep asleep(2, {.kind = BodyKind::Dynamic, .mass_kg = 3, .contact_events = true});
    PhysicsWorld& world = asleep.test.world;
    ASSERT_EQ(world.contacts().size(), 2U);
    const double weight_Ns = 3 * kG / 60;
    for (const ContactEvent& event : world.contacts()) {
        EXPECT_FALSE(event.began);
        EXPECT_EQ(event.closing_speed_mps, Real{0});
    }
    EXPECT_NEAR(
        static_cast<double>(world.contacts()[0].impulse_Ns), 2 * weight_Ns, 0.05 * weight_Ns);
    EXPECT_NEAR(static_cast<double>(world.contacts()[1].impulse_Ns), weight_Ns, 0.05 * weight_Ns);
    world.wake(asleep.tower[0]);
    world.step();
    ASSERT_EQ(world.contacts().size(), 2U);
    for (const ContactEvent& event : world.contacts()) EXPECT_FALSE(event.began);
    EXPECT_EQ(world.all_contacts().size(), 2U);
}

TEST(SleepingContacts, EndWhenNoBodyAsksForThemOrOneIsGone) {
    Asleep asleep(1, {.kind = BodyKind::Dynamic, .contact_events = true});
    ASSERT_EQ(asleep.test.world.contacts().size(), 1U);
    asleep.test.world.set_contact_events(asleep.tower[0], false);
    asleep.test.world.step();
    EXPECT_TRUE(asleep.test.world.contacts().empty());

    Asleep other(1, {.kind = BodyKind::Dynamic, .contact_events = true});
    other.test.world.destroy_body(other.ground);
    other.test.world.step();
    EXPECT_TRUE(other.test.world.contacts().empty());
}

}  // namespace
}  // namespace plumbline::physics
