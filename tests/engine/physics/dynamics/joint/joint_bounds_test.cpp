// Limits and motors.
#include "engine/physics/dynamics/joint/joint_bounds.h"

#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

class JointBoundsAtSubsteps : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Substeps, JointBoundsAtSubsteps, testing::Values(1, 2, 4));

/// A point mass on an arm of 1 m about z, lying along x.
struct Arm : JointRig {
    std::uint32_t body{0};

    explicit Arm(const JointDef& def, double moment = 0.01) {
        body = add_body(1, Vec3d(moment), {1, 0, 0});
        JointDef hinge = def;
        hinge.kind = JointKind::Hinge;
        hinge.axis_world = {0, 0, 1};
        add_joint(body, 0, hinge);
    }
    double angle() const { return joints[0].position; }
    double torque_Nm() const { return joints[0].total_angular_impulse_Nms.z / kFrame_s; }
};

TEST_P(JointBoundsAtSubsteps, SliderStopsAtItsLimitAt50MetresPerSecond) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t body = rig.add_body(1, Vec3d(0.1), {0, 0, 0});
    rig.add_joint(
        body,
        0,
        {.kind = JointKind::Slider, .axis_world = {1, 0, 0}, .limits = std::array<Real, 2>{-1, 1}});
    rig.bodies[body].velocity_mps = {50, 0, 0};
    double farthest_m = 0;
    for (int i = 0; i < 60; ++i) {
        rig.step(kFrame_s, GetParam());
        farthest_m = std::max(farthest_m, rig.position(body).x);
    }
    EXPECT_NEAR(farthest_m, 1, 1e-6);
    EXPECT_NEAR(rig.position(body).x, 1, 1e-6);
    EXPECT_NEAR(rig.velocity(body).x, 0, 1e-6);
}

TEST_P(JointBoundsAtSubsteps, HingeStopsAtItsLimitAt50RadiansPerSecond) {
    Arm arm({.limits = std::array<Real, 2>{-1, 1}});
    arm.gravity = {0, 0, 0};
    arm.bodies[arm.body].velocity_mps = {0, 50, 0};
    arm.bodies[arm.body].spin_radps = {0, 0, 50};
    double farthest = 0;
    for (int i = 0; i < 60; ++i) {
        arm.step(kFrame_s, GetParam());
        farthest = std::max(farthest, arm.angle());
    }
    EXPECT_NEAR(farthest, 1, 1e-3);
    EXPECT_NEAR(arm.angle(), 1, 1e-6);
    EXPECT_LT(arm.max_speed(), 1e-4);
}

TEST_P(JointBoundsAtSubsteps, ArmRestsOnItsLimitWithItsWeight) {
    Arm arm({.limits = std::array<Real, 2>{-1, 1}});
    double lowest = 0;
    for (int i = 0; i < 300; ++i) {
        arm.step(kFrame_s, GetParam());
        lowest = std::min(lowest, arm.angle());
    }
    EXPECT_NEAR(lowest, -1, 1e-6);
    EXPECT_LT(arm.max_speed(), 1e-5);
    EXPECT_NEAR(arm.torque_Nm(), kG * std::cos(1.0), 1e-4);
}

TEST_P(JointBoundsAtSubsteps, UnlimitedMotorHoldsAtItsLimitAndLetsGoGently) {
    for (const Real most : {Real{1e30F}, Real{50}}) {
        Arm arm({.limits = std::array<Real, 2>{-0.5_r, 0.5_r},
                 .motor = JointMotor{.target = 10, .max = most}});
        double farthest = 0;
        for (int i = 0; i < 120; ++i) {
            arm.step(kFrame_s, GetParam());
            farthest = std::max(farthest, arm.angle());
        }
        EXPECT_NEAR(farthest, 0.5, 1e-6);
        // Motor and limit together give what the weight asks for, not the sum of two efforts.
        EXPECT_NEAR(arm.torque_Nm(), kG * std::cos(0.5), 1e-4);
        arm.joints[0].motor.reset();
        arm.run(3 * kFrame_s, kFrame_s, GetParam());
        EXPECT_LT(arm.max_speed(), kG * 3 * kFrame_s);
    }
}

TEST_P(JointBoundsAtSubsteps, MotorAcceleratesByItsTorqueToItsSpeed) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t wheel = rig.add_body(1, Vec3d(0.5), {0, 0, 0});
    rig.add_joint(wheel,
                  0,
                  {.kind = JointKind::Hinge,
                   .axis_world = {0, 1, 0},
                   .motor = JointMotor{.target = 3, .max = 2}});
    while (rig.time_s < 3) {
        rig.step(kFrame_s, GetParam());
        EXPECT_NEAR(rig.spin(wheel).y, std::min(3.0, 2 * rig.time_s / 0.5), 1e-5);
    }
    EXPECT_NEAR(rig.joints[0].total_angular_impulse_Nms.y, 0, 1e-5);
}

TEST_P(JointBoundsAtSubsteps, MotorHoldsAnArmLevelInBothKindsOfKick) {
    for (const Kick kick : {Kick::Halves, Kick::Steady}) {
        Arm arm({.motor = JointMotor{.target = 0, .max = 20}});
        arm.kick = kick;
        arm.run(5, kFrame_s, GetParam());
        EXPECT_NEAR(arm.angle(), 0, 1e-6);
        EXPECT_NEAR(arm.torque_Nm(), kG, 1e-4);
    }
}

TEST_P(JointBoundsAtSubsteps, WeakMotorOnlySlowsAFallingArm) {
    // Torque 2 against gravity at the start: (2 - 9.81) / 1.01 rad/s2.
    Arm arm({.motor = JointMotor{.target = 0, .max = 2}});
    arm.run(6 * kFrame_s, kFrame_s, GetParam());
    const double expected = 0.5 * (2 - kG) / 1.01 * std::pow(6 * kFrame_s, 2);
    EXPECT_NEAR(arm.angle() / expected, 1, 0.12);
    EXPECT_NEAR(arm.torque_Nm(), 2, 1e-4);
}

TEST_P(JointBoundsAtSubsteps, SliderMotorMovesAtItsSpeedUpwards) {
    JointRig rig;
    rig.kick = Kick::Steady;
    const std::uint32_t body = rig.add_body(2, Vec3d(0.1), {0, 0, 0});
    rig.add_joint(body,
                  0,
                  {.kind = JointKind::Slider,
                   .axis_world = {0, 1, 0},
                   .motor = JointMotor{.target = 0.5_r, .max = 1000}});
    rig.run(2, kFrame_s, GetParam());
    EXPECT_NEAR(rig.position(body).y, 1, 1e-4);
    EXPECT_NEAR(rig.joints[0].total_impulse_Ns.y / kFrame_s, 2 * kG, 1e-3);
}

/// A body of 2 kg on an upright slider.
struct Lift : JointRig {
    std::uint32_t body{0};

    explicit Lift(const JointMotor& motor, JointDef slider = {}) {
        kick = Kick::Steady;
        body = add_body(2, Vec3d(0.1), {0, 0, 0});
        slider.kind = JointKind::Slider;
        slider.axis_world = {0, 1, 0};
        slider.motor = motor;
        add_joint(body, 0, slider);
    }
    double height() { return position(body).y; }
    double force_N() const { return joints[0].total_impulse_Ns.y / kFrame_s; }
};

TEST_P(JointBoundsAtSubsteps, MotorWithStiffnessIsASpringAtRest) {
    for (const Real stiffness : {Real{50}, Real{1e4}, Real{1e7}}) {
        Lift lift({.max = 1e6_r, .stiffness = stiffness, .damping = 20, .position = 1});
        lift.run(20, kFrame_s, GetParam());
        EXPECT_NEAR(lift.height(), 1 - 2 * kG / static_cast<double>(stiffness), 1e-4) << stiffness;
        EXPECT_NEAR(lift.force_N(), 2 * kG, 1e-2);
    }
}

TEST_P(JointBoundsAtSubsteps, MotorWithDampingComesToItsSpeedAsItsDampingSays) {
    Lift lift({.target = 3, .max = 1e6_r, .damping = 4});
    lift.gravity = {0, 0, 0};
    lift.run(0.5, kFrame_s, GetParam());
    // m v' = d (3 - v), by implicit Euler within a hundredth.
    EXPECT_NEAR(lift.velocity(lift.body).y, 3 * (1 - std::exp(-4 * 0.5 / 2)), 0.02);
}

TEST_P(JointBoundsAtSubsteps, SpringOfAMotorSwingsAtItsFrequency) {
    Lift lift({.max = 1e6_r, .stiffness = 8, .position = 1});
    lift.gravity = {0, 0, 0};
    double before = 0;
    double quarter_s = 0;
    while (lift.height() < 1 && lift.time_s < 2) {
        before = lift.height();
        lift.step(kFrame_s, GetParam());
        quarter_s = lift.time_s - kFrame_s * (lift.height() - 1) / (lift.height() - before);
    }
    EXPECT_NEAR(quarter_s, std::acos(-1) / 4, 0.01) << "of a period of pi s: w = 2 rad/s";
}

TEST_P(JointBoundsAtSubsteps, SpringOfAMotorGivesNoMoreThanItsMost) {
    Lift lift({.max = 15, .stiffness = 1000, .damping = 10, .position = 1});
    lift.run(0.5, kFrame_s, GetParam());
    EXPECT_NEAR(lift.force_N(), 15, 1e-3);
    EXPECT_NEAR(lift.velocity(lift.body).y, (15 / 2.0 - kG) * 0.5, 1e-3);
}

TEST_P(JointBoundsAtSubsteps, SpringOfAMotorPressesOnALimitAndComesOff) {
    Lift lift({.max = 1e4_r, .stiffness = 1000, .damping = 50, .position = 2},
              {.limits = std::array<Real, 2>{-1, 1}});
    lift.run(3, kFrame_s, GetParam());
    EXPECT_NEAR(lift.height(), 1, 1e-5);
    EXPECT_NEAR(lift.force_N(), 2 * kG, 1e-2) << "limit and spring together";
    lift.joints[0].motor->position = 0;
    lift.run(10, kFrame_s, GetParam());
    EXPECT_NEAR(lift.height(), -2 * kG / 1000, 1e-4);
}

TEST_P(JointBoundsAtSubsteps, MotorByMassIsTheSameForEveryMass) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    for (const double moment : {0.5, 50.0}) {
        const std::uint32_t wheel = rig.add_body(1, Vec3d(moment), {moment, 0, 0});
        rig.add_joint(
            wheel,
            0,
            {.kind = JointKind::Hinge,
             .axis_world = {0, 1, 0},
             .motor = JointMotor{.target = 2, .max = 1e6_r, .damping = 1, .by_mass = true}});
        rig.run(1, kFrame_s, GetParam());
        EXPECT_NEAR(rig.spin(wheel).y, 2 * (1 - std::exp(-1.0)), 0.01) << moment;
    }
}

TEST_P(JointBoundsAtSubsteps, ConeAndTwistAreKept) {
    JointRig rig;
    const std::uint32_t body = rig.add_body(1, {0.01, 0.02, 0.02}, {1, 0, 0});
    rig.add_joint(body,
                  0,
                  {.kind = JointKind::Cone,
                   .axis_world = {1, 0, 0},
                   .limits = std::array<Real, 2>{0, 0.6_r},
                   .twist_limits = std::array<Real, 2>{-0.3_r, 0.3_r}});
    rig.bodies[body].velocity_mps = {0, 0, 1};
    rig.bodies[body].spin_radps = {5, -1, 0};
    double widest = 0;
    double worst = 0;
    for (int i = 0; i < 600; ++i) {
        rig.step(kFrame_s, GetParam());
        widest = std::max(widest, rig.joints[0].position);
        worst = std::max(worst, rig.max_error());
    }
    EXPECT_NEAR(widest, 0.6, 1e-5);
    EXPECT_LT(worst, 1e-5);
    EXPECT_LT(rig.max_speed(), 3);
}

TEST_P(JointBoundsAtSubsteps, RopeHoldsAtItsLengthAndIsSlackBefore) {
    JointRig rig;
    const std::uint32_t ball = rig.add_ball_body(1, 0.1, {0.3, 0, 0});
    rig.add_joint(ball,
                  0,
                  {.kind = JointKind::Distance,
                   .anchor_a_world = {0.3_r, 0, 0},
                   .limits = std::array<Real, 2>{0, 1}});
    rig.run(0.3, kFrame_s, GetParam());
    EXPECT_NEAR(rig.position(ball).y, -0.5 * kG * 0.09, 1e-6);
    double longest_m = 0;
    for (int i = 0; i < 600; ++i) {
        rig.step(kFrame_s, GetParam());
        longest_m = std::max(longest_m, rig.joints[0].position);
    }
    EXPECT_NEAR(longest_m, 1, 1e-6);
}

TEST_P(JointBoundsAtSubsteps, LimitsPassedAtTheStartAreComeBackToSlowly) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t body = rig.add_body(1, Vec3d(0.1), {0, 0, 0});
    rig.add_joint(
        body,
        0,
        {.kind = JointKind::Slider, .axis_world = {1, 0, 0}, .limits = std::array<Real, 2>{2, 3}});
    Vec3d last = rig.position(body);
    for (int i = 0; i < 60; ++i) {
        rig.step(kFrame_s, GetParam());
        EXPECT_LT(glm::length(rig.position(body) - last) / kFrame_s, 3.01);
        last = rig.position(body);
    }
    EXPECT_NEAR(rig.position(body).x, 2, 1e-6);
    EXPECT_LT(rig.max_speed(), 1e-4);
}

TEST(JointBounds, HingeCountsOnPastAHalfTurn) {
    Arm arm(
        {.limits = std::array<Real, 2>{-10, 10}, .motor = JointMotor{.target = 4, .max = 1e6_r}});
    arm.gravity = {0, 0, 0};
    arm.run(2, kFrame_s, 4);
    EXPECT_NEAR(arm.angle(), 8, 1e-3);
    arm.run(1, kFrame_s, 4);
    EXPECT_NEAR(arm.angle(), 10, 1e-5);
}

TEST(JointBounds, HingePressedAgainstAHalfTurnStays) {
    const Real half = static_cast<Real>(glm::pi<double>());
    Arm arm(
        {.limits = std::array<Real, 2>{-half, half}, .motor = JointMotor{.target = 4, .max = 100}});
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        arm.step(kFrame_s, 4);
        if (i > 120) worst = std::max(worst, arm.max_speed());
    }
    EXPECT_NEAR(arm.angle(), glm::pi<double>(), 1e-6);
    EXPECT_LT(worst, 1e-4);
}

TEST(JointBounds, LockedLimitsAreARow) {
    Arm arm({.limits = std::array<Real, 2>{0, 0}});
    arm.run(3, kFrame_s, 4);
    EXPECT_NEAR(arm.angle(), 0, 1e-7);
    EXPECT_NEAR(arm.torque_Nm(), kG, 1e-4);
}

/// Ten hinged links in a row whose angles are all limited: a heavy tail bends it until every limit
/// bears.
TEST(JointBounds, ChainOfLimitsBearsAsABentBeam) {
    JointRig rig;
    std::uint32_t last = 0;
    for (int i = 0; i < 10; ++i) {
        const std::uint32_t link = rig.add_body(1, {0.001, 0.01, 0.01}, {0.3 * i + 0.15, 0, 0});
        rig.add_joint(link,
                      last,
                      {.kind = JointKind::Hinge,
                       .anchor_a_world = Vec3(Vec3d{0.3 * i, 0, 0}),
                       .axis_world = {0, 0, 1},
                       .limits = std::array<Real, 2>{-0.1_r, 0.1_r}});
        last = link;
    }
    rig.run(10, kFrame_s, 4);
    EXPECT_LT(rig.max_speed(), 1e-4);
    EXPECT_LT(rig.max_error(), 1e-6);
    // The first hinge's torque is the moment of all weights about it.
    double moment = 0;
    for (std::uint32_t i = 1; i <= 10; ++i) moment += kG * rig.position(i).x;
    EXPECT_NEAR(rig.joints[0].total_angular_impulse_Nms.z / kFrame_s / moment, 1, 1e-5);
    for (const SolverJoint& joint : rig.joints) EXPECT_NEAR(joint.position, -0.1, 1e-6);
}

TEST(JointBounds, WheelOnAMotorAt300RadiansPerSecondRunsTrue) {
    // A wheel on a free axle block held by a slider: nothing wobbles, nothing walks.
    JointRig rig;
    const std::uint32_t block = rig.add_body(5, Vec3d(0.1), {0, 0, 0});
    rig.add_joint(block, 0, {.kind = JointKind::Slider, .axis_world = {1, 0, 0}});
    const std::uint32_t wheel = rig.add_body(2, {0.02, 0.02, 0.04}, {0, 0, 0.2});
    rig.add_joint(wheel,
                  block,
                  {.kind = JointKind::Hinge,
                   .anchor_a_world = {0, 0, 0.2_r},
                   .axis_world = {0, 0, 1},
                   .motor = JointMotor{.target = 300, .max = 100}});
    rig.run(5, kFrame_s, 4);
    EXPECT_NEAR(rig.spin(wheel).z, 300, 1e-3);
    EXPECT_LT(rig.max_error(), 1e-5);
    EXPECT_NEAR(rig.position(block).x, 0, 1e-4);
}

TEST(JointBound, AMotorFarFromItsSpeedBeginsWithAllItHas) {
    JointBound bound{.step = BoundStep::Driven, .motor_speed = 1e4, .motor_impulse = 2, .mass = 1};
    bound.start_motor(0);
    EXPECT_EQ(bound.step, BoundStep::Forward);
    bound.step = BoundStep::Driven;
    bound.start_motor(2e4);
    EXPECT_EQ(bound.step, BoundStep::Backward);
    bound.step = BoundStep::Driven;
    bound.start_motor(1e4 - 1);
    EXPECT_EQ(bound.step, BoundStep::Driven) << "in reach";
}

}  // namespace
}  // namespace plumbline::physics
