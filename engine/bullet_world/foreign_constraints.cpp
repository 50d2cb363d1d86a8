#include "engine/bullet_world/foreign_constraints.h"

#include "engine/bullet_world/mirror.h"

#include <cmath>
#include <utility>

namespace plumbline::bullet_world {
namespace {

using physics::JointKind;
using physics::JointMotor;
using Limits = std::optional<std::array<Real, 2>>;

/// A limit nearer to another than this is the same, and a freedom smaller than this is none.
constexpr Real kSame = 1e-4_r;
/// Bullet holds a swing narrower than this as if it were locked.
constexpr Real kLockedSwing_rad = 0.05_r;

/// The frame with its z axis along that axis of it.
Pose along(const btTransform& frame, int axis) {
    const Real half = 0.5_r;
    // Cyclic turns of the axes: x to z, and y to z.
    const Quat turn = axis == 0   ? Quat{half, half, half, half}
                      : axis == 1 ? Quat{half, -half, -half, -half}
                                  : kNoRotation;
    const Pose pose = pose_of(frame);
    return {.position = pose.position, .orientation = pose.orientation * turn};
}

ForeignJoint between(btTypedConstraint& constraint,
                     JointKind kind,
                     const btTransform& a_frame,
                     const btTransform& b_frame,
                     int axis) {
    return {.kind = kind,
            .a = &constraint.getRigidBodyA(),
            .b = &constraint.getRigidBodyB(),
            .a_from_joint = along(a_frame, axis),
            .b_from_joint = along(b_frame, axis)};
}

Limits reversed(const Limits& limits) {
    if (!limits) return limits;
    return {{-(*limits)[1], -(*limits)[0]}};
}

/// The same joint with displacements of b against a.
void swap_bodies(ForeignJoint& joint) {
    std::swap(joint.a, joint.b);
    std::swap(joint.a_from_joint, joint.b_from_joint);
}

std::optional<ForeignJoint> ball(btPoint2PointConstraint& point) {
    // A clamped one gives way, as a hand that drags a body does.
    if (point.m_setting.m_impulseClamp > 0) return std::nullopt;
    const auto frame = [](const btVector3& at) {
        return btTransform(btQuaternion::getIdentity(), at);
    };
    return between(
        point, JointKind::BallAndSocket, frame(point.getPivotInA()), frame(point.getPivotInB()), 2);
}

std::optional<ForeignJoint> hinge(btHingeConstraint& hinge, Real step_s) {
    if (hinge.getAngularOnly()) return std::nullopt;
    ForeignJoint joint = between(hinge, JointKind::Hinge, hinge.getAFrame(), hinge.getBFrame(), 2);
    const Real sign = hinge.getUseReferenceFrameA() ? -1 : 1;
    if (hinge.hasLimit()) {
        joint.limits = {{hinge.getLowerLimit(), hinge.getUpperLimit()}};
        if (sign < 0) joint.limits = reversed(joint.limits);
    }
    if (hinge.getEnableAngularMotor())
        joint.motor = JointMotor{.target = sign * hinge.getMotorTargetVelocity(),
                                 .max = hinge.getMaxMotorImpulse() / step_s};
    return joint;
}

std::optional<ForeignJoint> slider(btSliderConstraint& slider) {
    const bool turns = slider.getLowerAngLimit() != 0 || slider.getUpperAngLimit() != 0;
    if (turns || slider.getPoweredAngMotor()) return std::nullopt;
    ForeignJoint joint =
        between(slider, JointKind::Slider, slider.getFrameOffsetA(), slider.getFrameOffsetB(), 0);
    if (slider.getLowerLinLimit() <= slider.getUpperLinLimit())
        joint.limits = {{slider.getLowerLinLimit(), slider.getUpperLinLimit()}};
    if (slider.getPoweredLinMotor())
        joint.motor = JointMotor{.target = slider.getTargetLinMotorVelocity(),
                                 .max = slider.getMaxLinMotorForce()};
    // The axis is A's: where B takes A's place, so do its frame and its axis, which coincide.
    if (slider.getUseLinearReferenceFrameA()) swap_bodies(joint);
    return joint;
}

std::optional<ForeignJoint> cone_twist(btConeTwistConstraint& cone) {
    if (cone.isMotorEnabled() || cone.getAngularOnly()) return std::nullopt;
    const Real swing1 = cone.getLimit(5);
    const Real swing2 = cone.getLimit(4);
    const Real twist = cone.getLimit(3);
    const bool locked = swing1 < kLockedSwing_rad && swing2 < kLockedSwing_rad;
    if (!locked && std::abs(swing1 - swing2) > kSame * swing1) return std::nullopt;
    const Real turn = SIMD_PI;
    ForeignJoint joint =
        between(cone, JointKind::Cone, cone.getFrameOffsetA(), cone.getFrameOffsetB(), 0);
    if (locked) {
        joint.kind = JointKind::Hinge;
        if (twist < turn) joint.limits = {{-twist, twist}};
        if (twist < kSame) joint.kind = JointKind::Fixed;
        return joint;
    }
    if (swing1 >= turn && twist >= turn) joint.kind = JointKind::BallAndSocket;
    if (swing1 < turn) joint.limits = {{0, swing1}};
    if (twist < turn) joint.twist_limits = {{-twist, twist}};
    return joint;
}

/// What the six freedoms of a constraint are: 0 to 2 along its axes, 3 to 5 about them.
struct Freedoms {
    std::array<btScalar, 6> low{};
    std::array<btScalar, 6> high{};
    bool driven{false};  ///< by motors or springs

    bool locked(int i) const { return std::abs(high_of(i)) + std::abs(low_of(i)) < 2 * kSame; }
    bool open(int i) const { return low_of(i) > high_of(i); }
    btScalar low_of(int i) const { return low[static_cast<std::size_t>(i)]; }
    btScalar high_of(int i) const { return high[static_cast<std::size_t>(i)]; }
    /// Of three: how many are not locked, and the last of them.
    std::pair<int, int> free_of(int first) const {
        std::pair<int, int> found{0, 2};
        for (int i = 0; i < 3; ++i) {
            if (!locked(first + i)) found = {found.first + 1, i};
        }
        return found;
    }
    Limits limits(int i) const {
        if (open(i)) return std::nullopt;
        return {{low_of(i), high_of(i)}};
    }
};

template <class Linear, class Angular>
Freedoms freedoms(const Linear& linear, const std::array<const Angular*, 3>& angular) {
    Freedoms all;
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        all.low[i] = linear.m_lowerLimit[axis];
        all.high[i] = linear.m_upperLimit[axis];
        all.low[i + 3] = angular[i]->m_loLimit;
        all.high[i + 3] = angular[i]->m_hiLimit;
        all.driven = all.driven || linear.m_enableMotor[i] || angular[i]->m_enableMotor;
    }
    return all;
}

template <class Constraint>
auto angular_limits(Constraint& constraint) {
    using Limit = std::remove_pointer_t<decltype(constraint.getRotationalLimitMotor(0))>;
    return std::array<const Limit*, 3>{constraint.getRotationalLimitMotor(0),
                                       constraint.getRotationalLimitMotor(1),
                                       constraint.getRotationalLimitMotor(2)};
}

template <class Constraint>
std::optional<ForeignJoint> six_freedoms(Constraint& constraint, const Freedoms& free) {
    if (free.driven) return std::nullopt;
    const auto [sliding, slide_axis] = free.free_of(0);
    const auto [turning, turn_axis] = free.free_of(3);
    const auto joint = [&](JointKind kind, int axis) {
        return between(
            constraint, kind, constraint.getFrameOffsetA(), constraint.getFrameOffsetB(), axis);
    };
    if (sliding == 0 && turning == 0) return joint(JointKind::Fixed, 2);
    if (sliding == 0 && turning == 3 && free.open(3) && free.open(4) && free.open(5))
        return joint(JointKind::BallAndSocket, 2);
    if (sliding == 0 && turning == 1) {
        ForeignJoint hinge = joint(JointKind::Hinge, turn_axis);
        hinge.limits = free.limits(3 + turn_axis);
        return hinge;
    }
    if (sliding == 1 && turning == 0) {
        ForeignJoint slider = joint(JointKind::Slider, slide_axis);
        slider.limits = free.limits(slide_axis);
        swap_bodies(slider);
        return slider;
    }
    return std::nullopt;
}

std::optional<ForeignJoint> described(btTypedConstraint& constraint, Real step_s) {
    switch (constraint.getConstraintType()) {
        case POINT2POINT_CONSTRAINT_TYPE:
            return ball(static_cast<btPoint2PointConstraint&>(constraint));
        case HINGE_CONSTRAINT_TYPE:
            return hinge(static_cast<btHingeConstraint&>(constraint), step_s);
        case SLIDER_CONSTRAINT_TYPE:
            return slider(static_cast<btSliderConstraint&>(constraint));
        case CONETWIST_CONSTRAINT_TYPE:
            return cone_twist(static_cast<btConeTwistConstraint&>(constraint));
        case D6_CONSTRAINT_TYPE: {
            auto& six = static_cast<btGeneric6DofConstraint&>(constraint);
            return six_freedoms(six,
                                freedoms(*six.getTranslationalLimitMotor(), angular_limits(six)));
        }
        case D6_SPRING_2_CONSTRAINT_TYPE: {
            auto& six = static_cast<btGeneric6DofSpring2Constraint&>(constraint);
            const btTranslationalLimitMotor2& linear = *six.getTranslationalLimitMotor();
            Freedoms free = freedoms(linear, angular_limits(six));
            for (int i = 0; i < 3; ++i) {
                free.driven = free.driven || linear.m_enableSpring[i] ||
                              six.getRotationalLimitMotor(i)->m_enableSpring;
            }
            return six_freedoms(six, free);
        }
        default:
            return std::nullopt;
    }
}

}  // namespace

void exchange(ForeignJoint& joint) {
    swap_bodies(joint);
    if (joint.kind == JointKind::Cone) {
        joint.twist_limits = reversed(joint.twist_limits);
        return;
    }
    joint.limits = reversed(joint.limits);
    if (joint.motor) joint.motor->target = -joint.motor->target;
}

std::optional<ForeignJoint> foreign_joint(btTypedConstraint& constraint, Real step_s) {
    auto joint = described(constraint, step_s);
    if (!joint) return joint;
    const btScalar breaking_Ns = constraint.getBreakingImpulseThreshold();
    if (breaking_Ns < SIMD_INFINITY) joint->break_N = breaking_Ns / step_s;
    return joint;
}

}  // namespace plumbline::bullet_world
