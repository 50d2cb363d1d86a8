#include "engine/physics/dynamics/joint/joint_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumbline::physics {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;
/// Definitions are of Real; what is computed from them is double.
constexpr double kSlack = sizeof(Real) == sizeof(float) ? 2e-6 : 1e-12;

const MassPose kTurned{.position_m = {1, 2, 3},
                       .orientation = glm::angleAxis(0.7, glm::normalize(Vec3d{1, 2, -1}))};
const MassPose kOther{.position_m = {-4, 0, 1},
                      .orientation = glm::angleAxis(-1.9, glm::normalize(Vec3d{0, 1, 3}))};

/// Turned about an axis through a point of the world.
MassPose turned_about(const MassPose& pose, const Vec3d& point, const Vec3d& axis, double angle) {
    const Quatd turn = glm::angleAxis(angle, axis);
    return {.position_m = point + turn * (pose.position_m - point),
            .orientation = turn * pose.orientation};
}
MassPose shifted(const MassPose& pose, const Vec3d& by_m) {
    return {.position_m = pose.position_m + by_m, .orientation = pose.orientation};
}

JointDef def_of(JointKind kind) {
    return {.kind = kind,
            .anchor_a_world = {1, 1, 1},
            .anchor_b_world = {1, 1, 1},
            .axis_world = {0, 0, 1}};
}

TEST(JointGeometry, NothingIsWrongAtTheStart) {
    for (const JointKind kind : {JointKind::BallAndSocket,
                                 JointKind::Hinge,
                                 JointKind::Slider,
                                 JointKind::Fixed,
                                 JointKind::Cone,
                                 JointKind::Distance,
                                 JointKind::Spring}) {
        for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, -3, 4}}) {
            JointDef def = def_of(kind);
            def.axis_world = axis;
            def.anchor_b_world = {1, 4, 5};
            const SolverJoint joint = placed_joint(def, kTurned, kOther);
            const JointFit fit = joint_error(joint, kTurned, kOther);
            EXPECT_NEAR(fit.error_m, 0, kSlack);
            const bool has_length = kind == JointKind::Distance || kind == JointKind::Spring;
            EXPECT_NEAR(fit.position, has_length ? 5 : 0, kSlack);
            const JointSides sides = joint_sides(joint, kTurned, kOther);
            EXPECT_NEAR(glm::distance(sides.axis_a, glm::normalize(Vec3d{axis})), 0, kSlack);
            EXPECT_NEAR(glm::distance(sides.axis_b, glm::normalize(Vec3d{axis})), 0, kSlack);
        }
    }
}

TEST(JointGeometry, ABallSeesTheGapAlone) {
    const SolverJoint joint = placed_joint(def_of(JointKind::BallAndSocket), kTurned, kOther);
    const MassPose spun = turned_about(kTurned, {1, 1, 1}, glm::normalize(Vec3d{1, 1, 0}), 2);
    EXPECT_NEAR(joint_error(joint, spun, kOther).error_m, 0, kSlack);
    EXPECT_NEAR(joint_error(joint, shifted(spun, {0.3, 0, 0.4}), kOther).error_m, 0.5, kSlack);
}

TEST(JointGeometry, AHingeTurnsRightHandedAndGoesOn) {
    SolverJoint joint = placed_joint(def_of(JointKind::Hinge), kTurned, kOther);
    for (double angle = 0; angle < 15; angle += 0.5) {
        const JointFit fit =
            joint_error(joint, turned_about(kTurned, {1, 1, 1}, {0, 0, 1}, angle), kOther);
        EXPECT_NEAR(fit.position, angle, kSlack);
        EXPECT_NEAR(fit.error_m, 0, kSlack);
        joint.position = fit.position;
    }
    // b turned by as much brings it back to none, after two turns.
    const JointFit both = joint_error(joint,
                                      turned_about(kTurned, {1, 1, 1}, {0, 0, 1}, 1),
                                      turned_about(kOther, {1, 1, 1}, {0, 0, 1}, 1));
    EXPECT_NEAR(both.position, 4 * kHalfTurn_rad, kSlack);
}

TEST(JointGeometry, AHingeMindsTheTiltAndItsLimits) {
    JointDef def = def_of(JointKind::Hinge);
    def.limits = {{-1, 2}};
    const SolverJoint joint = placed_joint(def, kTurned, kOther);
    const auto error = [&](const Vec3d& axis, double angle) {
        return joint_error(joint, turned_about(kTurned, {1, 1, 1}, axis, angle), kOther).error_m;
    };
    EXPECT_NEAR(error({0, 0, 1}, 1.9), 0, kSlack);
    EXPECT_NEAR(error({0, 0, 1}, 2.1), 0.1, kSlack);
    EXPECT_NEAR(error({0, 0, 1}, -1.25), 0.25, kSlack);
    EXPECT_NEAR(error({1, 0, 0}, 0.03), 0.03, kSlack);
}

TEST(JointGeometry, ASliderGoesAlongAndNoOtherWay) {
    JointDef def = def_of(JointKind::Slider);
    def.limits = {{-1, 2}};
    const SolverJoint joint = placed_joint(def, kTurned, kOther);
    const JointFit along = joint_error(joint, shifted(kTurned, {0, 0, 1.5}), kOther);
    EXPECT_NEAR(along.position, 1.5, kSlack);
    EXPECT_NEAR(along.error_m, 0, kSlack);
    EXPECT_NEAR(joint_error(joint, shifted(kTurned, {0, 0, 2.5}), kOther).error_m, 0.5, kSlack);
    EXPECT_NEAR(joint_error(joint, shifted(kTurned, {0.3, 0.4, 1}), kOther).error_m, 0.5, kSlack);
    EXPECT_NEAR(
        joint_error(joint, turned_about(kTurned, {1, 1, 1}, {0, 0, 1}, 0.2), kOther).error_m,
        0.2,
        kSlack);
    // The axis is b's: turned with b, a's way along the old axis is a way across.
    const MassPose b = turned_about(kOther, {1, 1, 1}, {1, 0, 0}, kHalfTurn_rad / 2);
    const MassPose a = turned_about(kTurned, {1, 1, 1}, {1, 0, 0}, kHalfTurn_rad / 2);
    EXPECT_NEAR(joint_error(joint, shifted(a, {0, -1, 0}), b).position, 1, kSlack);
}

TEST(JointGeometry, AConeHasSwingAndTwist) {
    JointDef def = def_of(JointKind::Cone);
    def.limits = {{-0.4_r, 0.3_r}};  // the larger magnitude counts
    def.twist_limits = {{-0.2_r, 0.9_r}};
    const SolverJoint joint = placed_joint(def, kTurned, kOther);
    const auto fit = [&](const Vec3d& axis, double angle) {
        return joint_error(joint, turned_about(kTurned, {1, 1, 1}, axis, angle), kOther);
    };
    EXPECT_NEAR(fit({0, 1, 0}, 0.35).position, 0.35, kSlack);
    EXPECT_NEAR(fit({0, 1, 0}, 0.35).error_m, 0, kSlack);
    EXPECT_NEAR(fit({0, 1, 0}, 0.6).error_m, 0.2, kSlack);
    EXPECT_NEAR(fit({0, 0, 1}, 0.8).error_m, 0, kSlack);
    EXPECT_NEAR(fit({0, 0, 1}, 1.0).error_m, 0.1, kSlack);
    EXPECT_NEAR(fit({0, 0, 1}, -0.5).error_m, 0.3, kSlack);
}

TEST(JointGeometry, FixedSeesEveryTurnADistanceNone) {
    const SolverJoint fixed = placed_joint(def_of(JointKind::Fixed), kTurned, kOther);
    const MassPose spun = turned_about(kTurned, {1, 1, 1}, glm::normalize(Vec3d{2, 1, 2}), -0.4);
    EXPECT_NEAR(joint_error(fixed, spun, kOther).error_m, 0.4, kSlack);

    JointDef def = def_of(JointKind::Distance);
    def.anchor_b_world = {1, 1, 3};
    const SolverJoint rod = placed_joint(def, kTurned, kOther);
    EXPECT_NEAR(static_cast<double>(rod.rest_length_m), 2, kSlack);
    EXPECT_NEAR(joint_error(rod, spun, kOther).error_m, 0, kSlack);
    EXPECT_NEAR(joint_error(rod, shifted(spun, {0, 0, -1}), kOther).error_m, 1, kSlack);
    def.limits = {{0, 2.5_r}};
    const SolverJoint rope = placed_joint(def, kTurned, kOther);
    EXPECT_NEAR(joint_error(rope, shifted(spun, {0, 0, 1}), kOther).error_m, 0, kSlack);
    EXPECT_NEAR(joint_error(rope, shifted(spun, {0, 0, -1}), kOther).error_m, 0.5, kSlack);
}

TEST(JointGeometry, FarFromTheOriginTheGapKeepsItsDigits) {
    const Vec3d far_m{1e6, -2e6, 3e6};
    const SolverJoint joint = placed_joint(def_of(JointKind::BallAndSocket), kTurned, kOther);
    const MassPose a = shifted(kTurned, far_m + Vec3d{1e-6, 0, 0});
    EXPECT_NEAR(joint_error(joint, a, shifted(kOther, far_m)).error_m, 1e-6, 2e-9);
}

TEST(JointGeometry, UnwrapsToTheNearestTurn) {
    EXPECT_NEAR(unwrapped(-3, 3), 2 * kHalfTurn_rad - 3, 1e-12);
    EXPECT_NEAR(unwrapped(3, -3), 3 - 2 * kHalfTurn_rad, 1e-12);
    EXPECT_NEAR(unwrapped(0.5, 100), 0.5 + 32 * kHalfTurn_rad, 1e-12);
    EXPECT_NEAR(twist_about_x(Quatd{-std::cos(0.3), -std::sin(0.3), 0, 0}), 0.6, 1e-12);
}

}  // namespace
}  // namespace plumbline::physics
