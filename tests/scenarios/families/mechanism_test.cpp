// Single joints where they are hard: H36, H38 to H42, H45, H46.
#include "engine/physics/totals.h"
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

TEST(Mechanism, H36ADoorOnTwoMisalignedHingesIsQuiet) {
    for (const double push_radps : {0.0, 0.5}) {
        ScenarioWorld world(balanced());
        const BodyId door = world.box({0.5, 0, 0},
                                      {1, 2, 0.05},
                                      {.mass_kg = 20,
                                       .velocity_mps = {0, 0, -push_radps / 2},
                                       .spin_radps = {0, push_radps, 0}});
        world.join({.kind = JointKind::Hinge,
                    .a = door,
                    .anchor_a_world = vec(0, 0.8, 0),
                    .anchor_b_world = vec(0, 0.8, 0)});
        const double off = 0.5 * kPi_d / 180;
        world.join({.kind = JointKind::Hinge,
                    .a = door,
                    .anchor_a_world = vec(0.001, -0.8, 0),
                    .anchor_b_world = vec(0.001, -0.8, 0),
                    .axis_world = vec(std::sin(off), std::cos(off), 0)});
        const Watch seen = watch(world, 5, 3);
        EXPECT_TRUE(seen.finite);
        const std::string row = fmt::format("H36 door, pushed {} rad/s, ", push_radps);
        expect_at_most(row + "speed m/s", seen.speed_mps, 1e-3);
        expect_at_most(row + "sag m", std::abs(world.at(door).y), 5e-3);
    }
}

/// A rod on a cone joint that is turned right through the pose in which its axis points back.
TEST(Mechanism, H38JointsPassTheirSingularPoses) {
    const std::optional<std::array<Real, 2>> twists[] = {std::nullopt, {{-0.5_r, 0.5_r}}};
    for (const auto& twist : twists) {
        ScenarioWorld world(balanced(), kWeightless);
        const BodyId rod = world.box(
            {0.5, 0, 0}, {1, 0.1, 0.2}, {.velocity_mps = {0, 1, 0}, .spin_radps = {0, 0, 2}});
        world.join(
            {.kind = JointKind::Cone, .a = rod, .axis_world = {1, 0, 0}, .twist_limits = twist});
        const double start_J = world.energy_J();
        double gain = 0;
        double gap_m = 0;
        for (int i = 0; i < 600; ++i) {
            world.physics.step();
            gain = std::max(gain, world.energy_J() / start_J - 1);
            gap_m = std::max(gap_m, max_joint_error_m(world.physics));
        }
        const std::string row = twist ? "H38 cone, twist limits, " : "H38 cone, free twist, ";
        EXPECT_TRUE(all_finite(world));
        expect_at_most(row + "energy gain", gain, 0.01);
        expect_at_most(row + "gap m", gap_m, 0.01);
        // Limits that the swing through the singular pose crosses may stop it, not throw it.
        expect_at_most(row + "speed gain", top_speed_mps(world) - 1, 0.05);
    }
    // A hinge, round and round.
    ScenarioWorld world(balanced(), kWeightless);
    const BodyId leaf =
        world.box({0.5, 0, 0}, {1, 0.1, 0.2}, {.velocity_mps = {0, 1, 0}, .spin_radps = {0, 0, 2}});
    world.join({.kind = JointKind::Hinge, .a = leaf, .axis_world = {0, 0, 1}});
    world.run(10);
    expect_at_most("H38 hinge round and round, spin", std::abs(world.spin(leaf).z / 2 - 1), 1e-3);
}

/// A rod that leans on the limit of its cone stays there.
TEST(Mechanism, H38AConeHoldsAtItsLimit) {
    ScenarioWorld world(balanced());
    const BodyId rod = world.box({0.5, 0, 0}, {1, 0.1, 0.1});
    const JointId cone = world.join(
        {.kind = JointKind::Cone, .a = rod, .axis_world = {1, 0, 0}, .limits = {{0, 0.7_r}}});
    const Watch seen = watch(world, 6, 4);
    expect_at_most("H38 cone at its limit, speed m/s", seen.speed_mps, 0.01);
    expect_at_most("H38 cone at its limit, past it rad",
                   std::abs(static_cast<double>(world.physics.joint(cone).state.position) - 0.7),
                   0.01);
}

TEST(Mechanism, H39LimitsHoldAtFiftyMetresPerSecond) {
    for (const int hz : {30, 60, 240}) {
        const std::string rate = fmt::format(" {} Hz", hz);
        {
            ScenarioWorld world(balanced(hz), kWeightless);
            const BodyId box = world.box({0, 0, 0}, {1, 1, 1}, {.velocity_mps = {50, 0, 0}});
            const JointId slider = world.join({.kind = JointKind::Slider,
                                               .a = box,
                                               .axis_world = {1, 0, 0},
                                               .limits = {{-1, 3.3_r}}});
            double most = 0;
            for (int i = 0; i < hz; ++i) {
                world.physics.step();
                most =
                    std::max(most, static_cast<double>(world.physics.joint(slider).state.position));
            }
            expect_at_most("H39 slider at 50 m/s, past its limit m" + rate, most - 3.3, 0.01);
        }
        {
            ScenarioWorld world(balanced(hz), kWeightless);
            const BodyId rod = world.box(
                {0.5, 0, 0}, {1, 0.1, 0.1}, {.velocity_mps = {0, 25, 0}, .spin_radps = {0, 0, 50}});
            const JointId hinge = world.join(
                {.kind = JointKind::Hinge, .a = rod, .axis_world = {0, 0, 1}, .limits = {{-1, 2}}});
            double most = 0;
            for (int i = 0; i < hz; ++i) {
                world.physics.step();
                most =
                    std::max(most, static_cast<double>(world.physics.joint(hinge).state.position));
            }
            expect_at_most("H39 hinge at 50 m/s, past its limit deg" + rate, degrees(most - 2), 1);
        }
    }
}

TEST(Mechanism, H40AMotorAgainstALimitWindsNothingUp) {
    ScenarioWorld world(balanced(), kWeightless);
    const BodyId leaf = world.box({0.5, 0, 0}, {1, 0.1, 0.5});
    const JointId hinge = world.join({.kind = JointKind::Hinge,
                                      .a = leaf,
                                      .axis_world = {0, 0, 1},
                                      .limits = {{-1, 1}},
                                      .motor = physics::JointMotor{.target = 10, .max = 1e6_r}});
    world.run(5);
    const double at = static_cast<double>(world.physics.joint(hinge).state.position);
    expect_at_most("H40 motor on its limit, past it deg", degrees(std::abs(at - 1)), 1);
    world.physics.set_joint_motor(hinge, std::nullopt);
    double top = 0;
    for (int i = 0; i < 60; ++i) {
        world.physics.step();
        top = std::max(top, glm::length(world.spin(leaf)));
    }
    expect_at_most("H40 let go, rad/s", top, 2);
}

TEST(Mechanism, H41AnchorsFiveMetresApartComeTogether) {
    for (const bool two : {false, true}) {
        ScenarioWorld world(balanced(), kWeightless);
        const BodyId a = world.box({0, 0, 0}, {1, 1, 1});
        const BodyId b = two ? world.box({2, 0, 0}, {1, 1, 1}) : BodyId{};
        world.join({.kind = JointKind::BallAndSocket,
                    .a = a,
                    .b = b,
                    .anchor_a_world = {1, 0, 0},
                    .anchor_b_world = {1, 0, 0}});
        world.physics.set_pose(a, {vec(0, 5, 0), kNoRotation});
        double top = 0;
        for (int i = 0; i < 120; ++i) {
            world.physics.step();
            top = std::max(top, top_speed_mps(world));
        }
        const std::string row = two ? "H41 two bodies, " : "H41 body and world, ";
        EXPECT_TRUE(all_finite(world));
        expect_at_most(row + "top speed m/s", top, 10);
        expect_at_most(row + "gap after 2 s m", max_joint_error_m(world.physics), 0.01);
        expect_at_most(row + "speed after 2 s m/s", top_speed_mps(world), 0.5);
    }
}

TEST(Mechanism, H42StiffSpringsStayBounded) {
    for (const int hz : {30, 60, 240}) {
        ScenarioWorld world(balanced(hz), kWeightless);
        const BodyId body = world.sphere({1.1, 0, 0}, 0.2);
        world.join({.kind = JointKind::Spring,
                    .a = body,
                    .anchor_a_world = vec(1.1, 0, 0),
                    .stiffness_Npm = 1e7_r,
                    .rest_length_m = 1});
        double most = 0;
        double last = 0;
        for (int i = 0; i < 10 * hz; ++i) {
            world.physics.step();
            const double out = std::abs(glm::length(world.at(body)) - 1);
            most = std::max(most, out);
            if (i >= 9 * hz) last = std::max(last, out);
        }
        EXPECT_TRUE(all_finite(world));
        expect_at_most(fmt::format("H42 spring of 1e7 N/m, swing over the first, {} Hz", hz),
                       most / 0.1,
                       1.01);
        note(fmt::format("H42 spring of 1e7 N/m, swing left after 10 s, {} Hz", hz), last / 0.1);
    }
    ScenarioWorld world(balanced());
    const BodyId body = world.sphere({0, -1, 0}, 0.2);
    world.join({.kind = JointKind::Spring,
                .a = body,
                .anchor_a_world = vec(0, -1, 0),
                .stiffness_Npm = 100,
                .damping_Nspm = 1e5_r});
    world.run(10);
    // m g / c for as long as the spring is slack, and it creeps towards m g / k.
    const double expected = kG_mps2 / 100 * (1 - std::exp(-100.0 / 1e5 * 10));
    expect_at_most(
        "H42 damper of 1e5 N s/m, path", std::abs((-1 - world.at(body).y) / expected - 1), 0.02);
}

TEST(Mechanism, H45ASlenderRodCarriesAWeight) {
    // Moments 1 : 10^4 about its length and across.
    constexpr double kThin_m = 2 / 141.4;
    ScenarioWorld world(balanced());
    const BodyId rod = world.box({1, 0, 0}, {2, kThin_m, kThin_m});
    const BodyId weight = world.box({2.1, 0, 0}, {0.2, 0.2, 0.2});
    world.join({.kind = JointKind::BallAndSocket, .a = rod});
    world.join({.kind = JointKind::Hinge,
                .a = weight,
                .b = rod,
                .anchor_a_world = {2, 0, 0},
                .anchor_b_world = {2, 0, 0},
                .axis_world = {0, 0, 1}});
    const double start_J = world.energy_J();
    double gap_m = 0;
    double gain_J = 0;
    double top = 0;
    for (int i = 0; i < 600; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, max_joint_error_m(world.physics));
        gain_J = std::max(gain_J, world.energy_J() - start_J);
        top = std::max(top, top_speed_mps(world));
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("H45 slender rod, gap m", gap_m, 0.01);
    expect_at_most("H45 slender rod, energy gain", gain_J / (3.1 * kG_mps2), 0.01);
    // All of the fall in the weight alone.
    expect_at_most("H45 slender rod, speed m/s", top, std::sqrt(2 * 3.1 * kG_mps2));
}

TEST(Mechanism, H46AFastWheelStaysOnItsAxle) {
    ScenarioWorld world(balanced());
    world.floor();
    const BodyId block = world.box({0, 0.5, 0}, {1, 1, 1}, {.mass_kg = 10});
    const Quatd lying = glm::angleAxis(kPi_d / 2, Vec3d{1, 0, 0});
    const BodyId wheel = world.add(BodyKind::Dynamic,
                                   physics::CylinderShape{.radius_m = 0.4_r, .height_m = 0.1_r},
                                   {0, 0.7, 0.6},
                                   {.mass_kg = 2, .turn = lying});
    world.join({.kind = JointKind::Hinge,
                .a = wheel,
                .b = block,
                .anchor_a_world = vec(0, 0.7, 0.6),
                .anchor_b_world = vec(0, 0.7, 0.6),
                .axis_world = {0, 0, 1},
                .motor = physics::JointMotor{.target = 300, .max = 5}});
    world.run(20);
    const Vec3d start = world.at(block);
    double tilt = 0;
    for (int i = 0; i < 300; ++i) {
        world.physics.step();
        const Vec3d axis = world.turn(wheel) * Vec3d{0, 1, 0};
        const Vec3d held = world.turn(block) * Vec3d{0, 0, 1};
        tilt = std::max(tilt, std::acos(std::min(1.0, std::abs(glm::dot(axis, held)))));
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("H46 wheel at 300 rad/s, spin", std::abs(world.spin(wheel).z / 300 - 1), 0.01);
    expect_at_most("H46 wheel, tilt of the axle deg", degrees(tilt), 1);
    expect_at_most("H46 wheel, walk m/s", drift_m(world.at(block), start) / 5, 0.01);
}

}  // namespace
}  // namespace plumbline::study
