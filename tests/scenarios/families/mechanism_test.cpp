// Joints where they are hard: H26, H28, H30, H31, H36, H38 to H42, H44 to H46.
#include "tests/scenarios/families/case_run.h"

namespace plumbline::study {
namespace {

/// Links of 1 m hanging straight down from (0, 0, 0), the last of mass `end_kg`.
std::vector<JointId> hang_chain(ScenarioWorld& world, int links, double end_kg, JointKind kind) {
    std::vector<JointId> joints;
    BodyId above{};
    for (int i = 0; i < links; ++i) {
        const BodyId link =
            world.box({0, -0.5 - i, 0}, {0.1, 1, 0.1}, {.mass_kg = i + 1 == links ? end_kg : 1});
        const Vec3 anchor = vec(0, -i, 0);
        joints.push_back(world.join({.kind = kind,
                                     .a = link,
                                     .b = above,
                                     .anchor_a_world = anchor,
                                     .anchor_b_world = anchor,
                                     .axis_world = {0, 0, 1}}));
        above = link;
    }
    return joints;
}

double stretch(const ScenarioWorld& world, int links) {
    return (-world.at(world.movers.back()).y - (links - 0.5)) / links;
}

void expect_chain(const std::string& row, int links, double seconds) {
    ScenarioWorld world(balanced());
    const std::vector<JointId> joints = hang_chain(world, links, 100, JointKind::Ball);
    const Watch seen = watch(world, seconds, seconds / 2);
    EXPECT_TRUE(seen.finite);
    expect_at_most(row + " stretch", std::abs(stretch(world, links)), 1e-5);
    expect_at_most(row + " speed m/s", seen.speed_mps, 0.01);
    double off = 0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double weight_N = kG_mps2 * (100 + static_cast<double>(joints.size() - 1 - i));
        off = std::max(
            off,
            std::abs(static_cast<double>(world.physics.joint_state(joints[i]).force_N) / weight_N -
                     1));
    }
    expect_at_most(row + " force is the weight below", off, 0.01);
}
TEST(Mechanism, H26AChainOfTenHoldsAHundredfoldEnd) {
    expect_chain("H26 10 links", 10, 10);
}
TEST(Mechanism, H28AChainOfFiftyHoldsAHundredfoldEnd) {
    expect_chain("H28 50 links", 50, 10);
}

TEST(Mechanism, H26AChainSwungKeepsItsLength) {
    constexpr int kLinks = 10;
    ScenarioWorld world(balanced());
    BodyId before{};
    for (int i = 0; i < kLinks; ++i) {
        const BodyId link =
            world.box({0.5 + i, 0, 0}, {1, 0.1, 0.1}, {.mass_kg = i + 1 == kLinks ? 100.0 : 1.0});
        world.join({.kind = JointKind::Ball,
                    .a = link,
                    .b = before,
                    .anchor_a_world = vec(i, 0, 0),
                    .anchor_b_world = vec(i, 0, 0)});
        before = link;
    }
    const double start_J = world.energy_J();
    double gap_m = 0;
    double gain_J = 0;
    for (int i = 0; i < 600; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        gain_J = std::max(gain_J, world.energy_J() - start_J);
    }
    expect_at_most("H26 10 links swung, gap m", gap_m, 5e-3);
    // Of the fall by its length.
    expect_at_most("H26 10 links swung, energy gain", gain_J / (100 * kG_mps2 * kLinks), 0.01);
}

/// Planks of 1 m hinged into a shallow arc between two walls, and 500 kg that fall on its middle.
TEST(Mechanism, H30ABridgeCatchesAHeavyBox) {
    constexpr int kPlanks = 160;
    constexpr double kSpread_rad = 0.6;  // of the arc to either side: 6 % of slack
    const double radius_m = kPlanks / (2 * kSpread_rad);
    ScenarioWorld world(balanced());
    std::vector<JointId> joints;
    BodyId before{};
    const auto hinge = [&](BodyId a, BodyId b, double angle) {
        const Vec3 at = vec(radius_m * std::sin(angle), -radius_m * std::cos(angle), 0);
        return world.join({.kind = JointKind::Hinge,
                           .a = a,
                           .b = b,
                           .anchor_a_world = at,
                           .anchor_b_world = at,
                           .axis_world = {0, 0, 1}});
    };
    for (int i = 0; i < kPlanks; ++i) {
        const double angle = kSpread_rad * (2 * (i + 0.5) / kPlanks - 1);
        const BodyId plank =
            world.box({radius_m * std::sin(angle), -radius_m * std::cos(angle), 0},
                      {0.98, 0.25, 2},
                      {.mass_kg = 5, .turn = glm::angleAxis(angle, Vec3d{0, 0, 1})});
        joints.push_back(hinge(plank, before, kSpread_rad * (2.0 * i / kPlanks - 1)));
        before = plank;
    }
    joints.push_back(hinge(before, {}, kSpread_rad));
    world.run(2);
    const double middle_m = world.at(world.movers[kPlanks / 2]).y;
    const BodyId load = world.box({0, middle_m + 0.125 + 0.5 + 2, 0}, {1, 1, 1}, {.mass_kg = 500});
    double gap_m = 0;
    double steepest = 1;
    for (int i = 0; i < 360; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        for (int k = 0; k < kPlanks; ++k) {
            const Vec3d up = world.turn(world.movers[static_cast<std::size_t>(k)]) * Vec3d{0, 1, 0};
            steepest = std::min(steepest, up.y);
        }
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most("H30 bridge, hinge gap m", gap_m, 0.05);
    EXPECT_GT(steepest, 0) << "a plank turned over";
    EXPECT_LT(glm::distance(world.at(load), world.at(world.movers[kPlanks / 2])), 8)
        << "it fell through";
}

/// A net of balls held along one edge and let swing.
void expect_net(const std::string& row, int side, double seconds) {
    constexpr double kLink_m = 0.5;
    ScenarioWorld world(balanced());
    std::vector<std::vector<BodyId>> ball(static_cast<std::size_t>(side));
    const auto join = [&](BodyId a, BodyId b, const Vec3d& at_a, const Vec3d& at_b) {
        world.join({.kind = JointKind::Ball,
                    .a = a,
                    .b = b,
                    .anchor_a_world = Vec3((at_a + at_b) * 0.5),
                    .anchor_b_world = Vec3((at_a + at_b) * 0.5)});
    };
    for (int x = 0; x < side; ++x) {
        for (int z = 0; z < side; ++z) {
            const Vec3d at{kLink_m * x, 0, kLink_m * z};
            const auto column = static_cast<std::size_t>(x);
            ball[column].push_back(world.ball(at, 0.1));
            const BodyId here = ball[column].back();
            if (z > 0)
                join(here,
                     ball[column][static_cast<std::size_t>(z - 1)],
                     at,
                     at - Vec3d{0, 0, kLink_m});
            if (x > 0)
                join(here,
                     ball[column - 1][static_cast<std::size_t>(z)],
                     at,
                     at - Vec3d{kLink_m, 0, 0});
            if (x == 0) join(here, {}, at, at);
        }
    }
    double gap_m = 0;
    double top = 0;
    const int steps = steps_of(world, seconds);
    for (int i = 0; i < steps; ++i) {
        world.physics.step();
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
        top = std::max(top, top_speed_mps(world));
    }
    EXPECT_TRUE(all_finite(world));
    expect_at_most(row + " gap, share of a link", gap_m / kLink_m, 0.02);
    expect_at_most(row + " speed m/s", top, 100);
}
TEST(Mechanism, H31ANetSwingsAndHolds) {
    expect_net("H31 net 10 x 10", 10, 5);
}
TEST(Mechanism, H31ALargeNetSwingsAndHolds) {
    expect_net("H31 net 40 x 40", 40, 0.25);
}

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
            gap_m = std::max(gap_m, world.physics.max_joint_error_m());
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
                   std::abs(static_cast<double>(world.physics.joint_state(cone).position) - 0.7),
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
                    std::max(most, static_cast<double>(world.physics.joint_state(slider).position));
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
                    std::max(most, static_cast<double>(world.physics.joint_state(hinge).position));
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
    const double at = static_cast<double>(world.physics.joint_state(hinge).position);
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
        world.join({.kind = JointKind::Ball,
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
        expect_at_most(row + "gap after 2 s m", world.physics.max_joint_error_m(), 0.01);
        expect_at_most(row + "speed after 2 s m/s", top_speed_mps(world), 0.5);
    }
}

TEST(Mechanism, H42StiffSpringsStayBounded) {
    for (const int hz : {30, 60, 240}) {
        ScenarioWorld world(balanced(hz), kWeightless);
        const BodyId body = world.ball({1.1, 0, 0}, 0.2);
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
    const BodyId body = world.ball({0, -1, 0}, 0.2);
    world.join({.kind = JointKind::Spring,
                .a = body,
                .anchor_a_world = vec(0, -1, 0),
                .stiffness_Npm = 100,
                .damping_Nspm = 1e5_r});
    world.run(10);
    // m g / c for as long as the spring is slack, and it creeps towards m g / k.
    const double expected = kG_mps2 / 100 * (1 - std::exp(-100.0 / 1e5 * 10));
    expect_at_most(
        "H42 damper of 1e5 N s/m, way", std::abs((-1 - world.at(body).y) / expected - 1), 0.02);
}

TEST(Mechanism, H44ASnappedChainRecovers) {
    ScenarioWorld world(balanced());
    hang_chain(world, 10, 1, JointKind::Ball);
    world.run(1);
    world.physics.set_pose(world.movers[5], {vec(100, 0, 0), kNoRotation});
    double top = 0;
    double gap_m = 0;
    for (int i = 0; i < 300; ++i) {
        world.physics.step();
        top = std::max(top, top_speed_mps(world));
        if (i == 0) gap_m = world.physics.max_joint_error_m();
    }
    EXPECT_TRUE(all_finite(world));
    note("H44 gap a frame after the snap m", gap_m);
    // A fall of the 100 m would give 44 m/s.
    expect_at_most("H44 top speed m/s", top, 30);
    expect_at_most("H44 gap after 5 s m", world.physics.max_joint_error_m(), 0.01);
}

TEST(Mechanism, H45ASlenderRodCarriesAWeight) {
    // Moments 1 : 10^4 about its length and across.
    constexpr double kThin_m = 2 / 141.4;
    ScenarioWorld world(balanced());
    const BodyId rod = world.box({1, 0, 0}, {2, kThin_m, kThin_m});
    const BodyId weight = world.box({2.1, 0, 0}, {0.2, 0.2, 0.2});
    world.join({.kind = JointKind::Ball, .a = rod});
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
        gap_m = std::max(gap_m, world.physics.max_joint_error_m());
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
