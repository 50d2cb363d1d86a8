// Each kind of joint does what the formula says.
#include "engine/physics/totals.h"
#include "tests/engine/physics/joint_bench.h"

#include <algorithm>
#include <array>

namespace plumbline::physics {
namespace {

constexpr double kMass_kg = 2;
const BodyDef kBody{.kind = BodyKind::Dynamic, .mass_kg = 2, .can_sleep = false};
constexpr Vec3 kWeightless{0, 0, 0};

class Joints : public JointTest {};
INSTANTIATE_TEST_SUITE_P(Solvers, Joints, testing::ValuesIn(kJointBars), name_of);

/// A rod of 1 m that hangs from the origin, turned out of the vertical.
BodyId hang_rod(TestWorld& test, double angle_rad) {
    BodyDef body = kBody;
    const auto angle = static_cast<Real>(angle_rad);
    body.world_from_body.orientation = glm::angleAxis(angle, Vec3{0, 0, 1});
    return test.add(BoxShape{.size_m = {0.1_r, 1, 0.1_r}},
                    {0.5_r * std::sin(angle), -0.5_r * std::cos(angle), 0},
                    body);
}

TEST_P(Joints, APendulumKeepsTimeOnEveryPivot) {
    constexpr double kAngle_rad = 5 * kPiD / 180;
    // A rod about its end, and the first term of the amplitude series.
    const double inertia = kMass_kg * ((1 + 0.01) / 12 + 0.25);
    const double expected_s =
        2 * kPiD * std::sqrt(inertia / (kMass_kg * kG * 0.5)) * (1 + kAngle_rad * kAngle_rad / 16);
    const double swing_J = kMass_kg * kG * 0.5 * (1 - std::cos(kAngle_rad));
    for (const JointKind kind : {JointKind::BallAndSocket, JointKind::Hinge, JointKind::Cone}) {
        TestWorld test(bar().world());
        const BodyId rod = hang_rod(test, kAngle_rad);
        const JointId pivot = join(test, {.kind = kind, .a = rod, .axis_world = {0, 0, 1}});
        const double start_J = total_energy_J(test);
        double gap_m = 0;
        const auto times_s = upward_crossings_s(test, 10, [&] {
            gap_m = std::max(gap_m, test.world.joint(pivot).state.error_m);
            return test.at(rod).x;
        });
        EXPECT_NEAR(period_of(times_s), expected_s, expected_s * bar().period);
        EXPECT_NEAR(total_energy_J(test), start_J, swing_J * bar().energy);
        EXPECT_LE(gap_m, bar().swing_gap_m);
    }
}

TEST_P(Joints, AHingeEndsAtItsLimitsAndLeavesThem) {
    TestWorld test(bar().world(kWeightless));
    BodyDef door = kBody;
    door.angular_velocity_radps = {0, 3, 0};
    door.velocity_mps = {0, 0, -1.5_r};
    const BodyId leaf = test.add(BoxShape{.size_m = {1, 2, 0.05_r}}, {0.5_r, 0, 0}, door);
    const JointId hinge =
        join(test, {.kind = JointKind::Hinge, .a = leaf, .limits = {{-1, 1.5_r}}});
    double most = 0;
    for (int i = 0; i < 120; ++i) {
        test.world.step();
        most = std::max(most, position(test, hinge));
    }
    EXPECT_NEAR(most, 1.5, bar().limit_rad);
    // Driven against the other limit with all force, it stays there ...
    test.world.set_joint_motor(hinge, JointMotor{.target = -4, .max = 100});
    test.run(4);
    EXPECT_NEAR(position(test, hinge), -1, bar().limit_rad);
    EXPECT_NEAR(test.spin(leaf).y, 0, 1e-4);
    // ... and leaves it with the torque it is given: 1 N m for half a second.
    test.world.set_joint_motor(hinge, JointMotor{.target = 4, .max = 1});
    test.run(0.5);
    const double inertia = kMass_kg * ((1 + 0.0025) / 12 + 0.25);
    EXPECT_NEAR(test.spin(leaf).y, 1 * 0.5 / inertia, 2e-3);
}

TEST_P(Joints, AHingeCountsTurns) {
    TestWorld test(bar().world(kWeightless));
    const BodyId wheel = test.add(CylinderShape{}, {0, 0, 0}, kBody);
    const JointId hinge = join(test, {.kind = JointKind::Hinge, .a = wheel, .limits = {{-5, 8}}});
    test.world.set_velocity(wheel, {0, 0, 0}, {0, 3, 0});
    test.run(2);
    EXPECT_NEAR(position(test, hinge), 6, 1e-4) << "past half a turn and on";
    test.run(2);
    EXPECT_LE(position(test, hinge), 8 + bar().limit_rad) << "a limit beyond a whole turn";
    EXPECT_GE(position(test, hinge), 8 - 3.0 / 60 - 1e-4) << "no more than a step's way before it";
    test.world.set_velocity(wheel, {0, 0, 0}, {0, -3, 0});
    test.run(6);
    EXPECT_GE(position(test, hinge), -5 - bar().limit_rad);
    EXPECT_LE(position(test, hinge), -5 + 3.0 / 60 + 1e-4);
}

TEST_P(Joints, AMotorTurnsAWheelWithItsTorque) {
    TestWorld test(bar().world(kWeightless));
    const BodyId wheel =
        test.add(CylinderShape{.radius_m = 0.5_r, .height_m = 0.2_r}, {0, 0, 0}, kBody);
    const JointId hinge = join(
        test, {.kind = JointKind::Hinge, .a = wheel, .motor = JointMotor{.target = 10, .max = 2}});
    const double inertia = 0.5 * kMass_kg * 0.25;
    test.run(0.5);
    EXPECT_NEAR(test.spin(wheel).y, 2 * 0.5 / inertia, 4 * bar().drive);
    EXPECT_NEAR(torque_Nm(test, hinge), 2, 2 * bar().load);
    test.run(2);
    EXPECT_NEAR(test.spin(wheel).y, 10, 10 * bar().drive) << "no more than asked for";
    EXPECT_NEAR(torque_Nm(test, hinge), 0, 1e-4) << "and nothing to hold it there";
    test.world.set_joint_motor(hinge, std::nullopt);
    test.world.set_velocity(wheel, {0, 0, 0}, {0, 1, 0});
    test.run(1);
    EXPECT_NEAR(test.spin(wheel).y, 1, 1e-5) << "runs freely";
}

TEST_P(Joints, AMotorTurnsOneBodyAgainstTheOther) {
    TestWorld test(bar().world(kWeightless));
    const BodyId a = test.add(CylinderShape{}, {0, 0.5_r, 0}, kBody);
    const BodyId b = test.add(CylinderShape{}, {0, -0.5_r, 0}, kBody);
    join(test,
         {.kind = JointKind::Hinge, .a = a, .b = b, .motor = JointMotor{.target = 4, .max = 1}});
    test.run(3);
    EXPECT_NEAR(test.spin(a).y, 2, 1e-3) << "a turns the positive way";
    EXPECT_NEAR(test.spin(b).y, -2, 1e-3);
}

TEST_P(Joints, ALiftIsDrivenToItsLimitAndHeld) {
    TestWorld test(bar().world());
    const BodyId lift = test.add(BoxShape{}, {5, 0, 0}, kBody);
    const double weight_N = kMass_kg * kG;
    const JointId slider =
        join(test,
             {.kind = JointKind::Slider,
              .a = lift,
              .anchor_a_world = {5, 0, 0},
              .limits = {{-1, 2}},
              .motor = JointMotor{.target = 3, .max = static_cast<Real>(weight_N + 4)}});
    test.run(0.5);
    EXPECT_NEAR(test.velocity(lift).y, 4 * 0.5 / kMass_kg, 1e-4) << "what its weight leaves";
    EXPECT_NEAR(force_N(test, slider), weight_N + 4, weight_N * bar().load);
    test.run(4);
    EXPECT_NEAR(position(test, slider), 2, 1e-3);
    EXPECT_NEAR(test.at(lift).y, 2, 1e-3);
    EXPECT_NEAR(force_N(test, slider), weight_N, 1e-2) << "the limit takes what is too much";
    test.world.set_joint_motor(slider, std::nullopt);
    test.run(4);
    EXPECT_NEAR(position(test, slider), -1, 1e-3) << "and down it goes";
    EXPECT_NEAR(test.at(lift).x, 5, 1e-3);
}

TEST_P(Joints, ASlidingPairKeepsItsMomenta) {
    TestWorld test(bar().world(kWeightless));
    const BodyId a = test.add(BoxShape{}, {1, 0, 0}, kBody);
    const BodyId b = test.add(BoxShape{}, {-1, 0, 0}, kBody);
    const JointId slider =
        join(test, {.kind = JointKind::Slider, .a = a, .b = b, .axis_world = {1, 0, 0}});
    test.world.set_velocity(a, {1, 2, 0}, {0, 0, 0.5_r});
    const Vec3d spin = angular_momentum_kgm2ps(test.world);
    const Vec3d push = momentum_kgmps(test.world);
    double error_m = 0;
    for (int i = 0; i < 300; ++i) {
        test.world.step();
        error_m = std::max(error_m, test.world.joint(slider).state.error_m);
    }
    EXPECT_GT(position(test, slider), 5) << "far from where the anchors met";
    EXPECT_LE(error_m, 2e-3);
    // Rounding of two thousand solves in float32.
    const double slack = sizeof(Real) == sizeof(float) ? 3e-3 : 1e-12;
    EXPECT_LE(glm::distance(angular_momentum_kgm2ps(test.world), spin), slack * glm::length(spin));
    EXPECT_LE(glm::distance(momentum_kgmps(test.world), push), slack * glm::length(push));
}

TEST_P(Joints, ABeamFixedAtOneEndWeighsOnItsRoot) {
    TestWorld test(bar().world());
    const BodyId beam = test.add(BoxShape{.size_m = {2, 0.1_r, 0.1_r}}, {1, 0, 0}, kBody);
    const JointId root = join(test, {.kind = JointKind::Fixed, .a = beam});
    test.run(2);
    const double weight_N = kMass_kg * kG;
    EXPECT_NEAR(force_N(test, root), weight_N, weight_N * bar().load);
    EXPECT_NEAR(torque_Nm(test, root), weight_N * 1, weight_N * bar().load);
    EXPECT_LE(test.world.joint(root).state.error_m, bar().rest_m);
    EXPECT_EQ(max_joint_error_m(test.world), test.world.joint(root).state.error_m);
}

TEST_P(Joints, EveryLinkOfAChainCarriesWhatHangsBelow) {
    TestWorld test(bar().world());
    std::array<JointId, 5> links;
    BodyId above{};
    for (std::size_t i = 0; i < links.size(); ++i) {
        const Real y = -static_cast<Real>(i);
        const BodyId link =
            test.add(BoxShape{.size_m = {0.1_r, 0.9_r, 0.1_r}}, {0, y - 0.5_r, 0}, kBody);
        links[i] = join(test, {.a = link, .b = above, .anchor_a_world = {0, y, 0}});
        above = link;
    }
    test.run(5);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const double below_N = static_cast<double>(links.size() - i) * kMass_kg * kG;
        EXPECT_NEAR(force_N(test, links[i]), below_N, below_N * bar().load) << "link " << i;
    }
}

TEST_P(Joints, ARodKeepsItsLength) {
    TestWorld test(bar().world());
    const BodyId bob = test.add(SphereShape{.radius_m = 0.05_r}, {1, 0, 0}, kBody);
    const JointId rod =
        join(test, {.kind = JointKind::Distance, .a = bob, .anchor_a_world = {1, 0, 0}});
    double error_m = 0;
    double lowest_m = 0;
    for (int i = 0; i < 600; ++i) {
        test.world.step();
        error_m = std::max(error_m, test.world.joint(rod).state.error_m);
        lowest_m = std::min(lowest_m, test.at(bob).y);
        EXPECT_NEAR(position(test, rod), glm::length(test.at(bob)), 1e-6);
    }
    EXPECT_LE(error_m, bar().rod_m);
    EXPECT_NEAR(lowest_m, -1, 0.02) << "it did swing";
}

TEST_P(Joints, ARopeIsSlackUntilItEnds) {
    TestWorld test(bar().world());
    const BodyId load = test.add(SphereShape{.radius_m = 0.05_r}, {5, 0, 0}, kBody);
    const JointId rope = join(test,
                              {.kind = JointKind::Distance,
                               .a = load,
                               .anchor_a_world = {5, 0, 0},
                               .anchor_b_world = {5, 0, 0},
                               .limits = {{0, 1}}});
    test.run(0.4);
    EXPECT_NEAR(test.at(load).y, -0.5 * kG * 0.16, 1e-5) << "falls as if there were none";
    EXPECT_EQ(force_N(test, rope), 0);
    test.run(3);
    EXPECT_NEAR(test.at(load).y, -1, 1e-3);
    EXPECT_NEAR(force_N(test, rope), kMass_kg * kG, kMass_kg * kG * bar().load);
}

TEST_P(Joints, ADistanceStaysBetweenItsLimits) {
    TestWorld test(bar().world(kWeightless));
    const BodyId a = test.add(SphereShape{.radius_m = 0.1_r}, {0, 2, 0}, kBody);
    const JointId range = join(
        test,
        {.kind = JointKind::Distance, .a = a, .anchor_a_world = {0, 2, 0}, .limits = {{1, 3}}});
    test.world.set_velocity(a, {0, 4, 0}, {0, 0, 0});
    test.run(2);
    EXPECT_NEAR(position(test, range), 3, 1e-3);
    test.world.set_velocity(a, {0, -4, 0}, {0, 0, 0});
    test.run(2);
    EXPECT_NEAR(position(test, range), 1, 1e-3);
}

TEST_P(Joints, ASpringSwingsInItsPeriodAndKeepsItsEnergy) {
    constexpr double kStiffness_Npm = 100;
    TestWorld test(bar().world());
    const BodyId bob = test.add(SphereShape{.radius_m = 0.05_r}, {0, -1, 0}, kBody);
    join(test,
         {.kind = JointKind::Spring,
          .a = bob,
          .anchor_a_world = {0, -1, 0},
          .stiffness_Npm = static_cast<Real>(kStiffness_Npm)});
    const double sag_m = kMass_kg * kG / kStiffness_Npm;
    const double start_J = total_energy_J(test);
    double lowest_m = 0;
    const auto times_s = upward_crossings_s(test, 10, [&] {
        lowest_m = std::min(lowest_m, test.at(bob).y);
        return test.at(bob).y + 1 + sag_m;
    });
    const double expected_s = 2 * kPiD * std::sqrt(kMass_kg / kStiffness_Npm);
    EXPECT_NEAR(period_of(times_s), expected_s, expected_s * bar().spring_period);
    EXPECT_NEAR(lowest_m, -1 - 2 * sag_m, 0.01 * sag_m);
    // Half the stretch at rest holds what the swing trades.
    EXPECT_NEAR(total_energy_J(test), start_J, 0.1 * kStiffness_Npm * sag_m * sag_m);
}

TEST_P(Joints, ASpringBetweenTwoSwingsWithTheReducedMass) {
    TestWorld test(bar().world(kWeightless));
    BodyDef light = kBody;
    light.mass_kg = 1;
    const BodyId a = test.add(SphereShape{.radius_m = 0.1_r}, {0, 1.1_r, 0}, kBody);
    const BodyId b = test.add(SphereShape{.radius_m = 0.1_r}, {0, 0, 0}, light);
    const JointId spring = join(test,
                                {.kind = JointKind::Spring,
                                 .a = a,
                                 .b = b,
                                 .anchor_a_world = {0, 1.1_r, 0},
                                 .stiffness_Npm = 40,
                                 .rest_length_m = 1});
    EXPECT_NEAR(energy(test.world).elastic_J, 0.5 * 40 * 0.01, 1e-6);
    const auto times_s = upward_crossings_s(test, 10, [&] { return position(test, spring) - 1; });
    const double expected_s = 2 * kPiD * std::sqrt((2.0 / 3) / 40);
    EXPECT_NEAR(period_of(times_s), expected_s, expected_s * bar().spring_period);
    EXPECT_NEAR(momentum_kgmps(test.world).y, 0, 1e-4);
}

TEST_P(Joints, ADampedSpringDiesAway) {
    TestWorld test(bar().world(kWeightless));
    const BodyId bob = test.add(SphereShape{.radius_m = 0.05_r}, {0, -1.5_r, 0}, kBody);
    join(test,
         {.kind = JointKind::Spring,
          .a = bob,
          .anchor_a_world = {0, -1.5_r, 0},
          .stiffness_Npm = 50,
          .damping_Nspm = 2,
          .rest_length_m = 1});
    const double decay_per_s = 2.0 / (2 * kMass_kg);
    test.run(4);
    double largest_m = 0;
    for (int i = 0; i < 90; ++i) {  // one and a bit periods of 1.26 s
        test.world.step();
        largest_m = std::max(largest_m, std::abs(test.at(bob).y + 1));
    }
    const double envelope_m = 0.5 * std::exp(-decay_per_s * 4);
    EXPECT_LE(largest_m, envelope_m * 1.05);
    EXPECT_GE(largest_m, envelope_m * std::exp(-decay_per_s * 1.26) * 0.9);
}

TEST_P(Joints, ASpringTooStiffForTheStepStaysInBounds) {
    for (const Real stiffness_Npm : {1e5_r, 1e9_r}) {
        TestWorld test(bar().world());
        const BodyId bob = test.add(SphereShape{.radius_m = 0.05_r}, {0, -1, 0}, kBody);
        join(test,
             {.kind = JointKind::Spring,
              .a = bob,
              .anchor_a_world = {0, -1, 0},
              .stiffness_Npm = stiffness_Npm,
              .damping_Nspm = 10});
        for (int i = 0; i < 600; ++i) {
            test.world.step();
            EXPECT_NEAR(test.at(bob).y, -1, 0.01);
        }
    }
}

TEST_P(Joints, AConeBoundsTheSwing) {
    TestWorld test(bar().world(kWeightless));
    const BodyId arm = test.add(BoxShape{.size_m = {0.2_r, 1, 0.2_r}}, {0, -0.5_r, 0}, kBody);
    const JointId cone =
        join(test,
             {.kind = JointKind::Cone, .a = arm, .axis_world = {0, -1, 0}, .limits = {{0, 0.5_r}}});
    test.world.set_velocity(arm, {1, 0, 0}, {0, 0, 2});
    double widest = 0;
    for (int i = 0; i < 120; ++i) {
        test.world.step();
        widest = std::max(widest, position(test, cone));
    }
    EXPECT_GE(widest, 0.5 - 2.0 / 60 - 1e-3);
    EXPECT_LE(widest, 0.5 + bar().cone_rad);
}

TEST_P(Joints, ATwistEndsOnItsOwnSide) {
    for (const double spin_radps : {2.0, -2.0}) {
        TestWorld test(bar().world(kWeightless));
        const BodyId arm = test.add(BoxShape{.size_m = {0.2_r, 1, 0.2_r}}, {0, -0.5_r, 0}, kBody);
        const JointId cone = join(test,
                                  {.kind = JointKind::Cone,
                                   .a = arm,
                                   .axis_world = {0, 1, 0},
                                   .limits = {{0, 0.5_r}},
                                   .twist_limits = {{-0.2_r, 0.9_r}}});
        test.world.set_velocity(arm, {0, 0, 0}, {0, static_cast<Real>(spin_radps), 0});
        double most = 0;
        double least = 0;
        for (int i = 0; i < 30; ++i) {
            test.world.step();
            const Quat q = test.world.state(arm).world_from_body.orientation;
            const double twist = 2 * std::atan2(static_cast<double>(q.y), static_cast<double>(q.w));
            most = std::max(most, twist);
            least = std::min(least, twist);
        }
        EXPECT_LE(most, 0.9 + bar().cone_rad);
        EXPECT_GE(least, -0.2 - bar().cone_rad);
        EXPECT_LE(test.world.joint(cone).state.error_m, bar().cone_rad);
        // Free until then, and to the right side.
        EXPECT_GE(spin_radps > 0 ? most / 0.9 : least / -0.2, 0.75);
    }
}

}  // namespace
}  // namespace plumbline::physics
