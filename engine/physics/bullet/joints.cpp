#include "engine/physics/bullet/joints.h"

#include "engine/physics/bullet/archive/bullet_fields.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/bullet/rigid_body.h"
#include "engine/physics/bullet/step_world.h"
#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/joint_record.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr btScalar kNearLimit = btScalar(3.1);  ///< rad: Bullet's angles end at pi

btRigidBody& rigid_of(BodyRecord* record) {
    return record != nullptr ? *record->rigid : btTypedConstraint::getFixedBody();
}

btTransform frame_of(const Quatd& frame, const Vec3d& anchor) {
    const Quat q{frame};
    return btTransform(to_bullet(q), bullet_from_double(anchor));
}

bool has_limits_of_both_sides(const std::optional<std::array<Real, 2>>& limits) {
    return limits && (*limits)[0] < (*limits)[1];
}

/// Hinge, slider and fixed. Bullet measures its second body against its first, so a comes second.
class SixAxes final : public btGeneric6DofSpring2Constraint {
public:
    explicit SixAxes(const JointRecord& joint)
        : btGeneric6DofSpring2Constraint(
              rigid_of(joint.b),
              rigid_of(joint.a),
              frame_of(joint.solver.frame_in_b, joint.solver.anchor_in_b),
              frame_of(joint.solver.frame_in_a, joint.solver.anchor_in_a)),
          joint_(joint.solver),
          frame_in_b_(m_frameInA.getBasis()),
          axis_(joint.solver.kind == JointKind::Hinge ? 3 : 0) {
        for (int axis = 3; axis < 6; ++axis) setLimit(axis, 0, 0);
        if (joint_.kind == JointKind::Fixed) return;
        setLimit(axis_, 1, -1);  // free
        // Makes Bullet read the two error reduction numbers that getInfo2() sets.
        setParam(BT_CONSTRAINT_STOP_ERP, 1, axis_);
        if (joint_.kind == JointKind::Slider && joint_.limits)
            setLimit(0, (*joint_.limits)[0], (*joint_.limits)[1]);
        follow(0);
        drive();
    }

    void drive() {
        if (joint_.kind == JointKind::Slider)
            m_frameInA = frame_of(joint_.frame_in_b, joint_.anchor_in_b);
        const bool driven = joint_.motor && joint_.motor->max > 0;
        enableMotor(axis_, driven);
        if (!driven) return;
        // Bullet's rows are of its first body against its second.
        setTargetVelocity(axis_, -joint_.motor->target);
        setMaxMotorForce(axis_, joint_.motor->max);
    }

    /// A hinge's limits near its present angle. Bullet's own angles end at half a turn; b's frame is
    /// turned along so that they start at the present one.
    void follow(double angle_rad) {
        if (joint_.kind != JointKind::Hinge || !joint_.limits) return;
        const auto angle = static_cast<btScalar>(angle_rad);
        m_frameInA.setBasis(frame_in_b_ * btMatrix3x3(btQuaternion({1, 0, 0}, angle)));
        const btScalar low = std::clamp((*joint_.limits)[0] - angle, -kNearLimit, kNearLimit);
        const btScalar high = std::clamp((*joint_.limits)[1] - angle, -kNearLimit, kNearLimit);
        setLimitReversed(3, low, high);  // Bullet's Euler angles run the other way
    }

    void getInfo1(btConstraintInfo1* info) override {
        btGeneric6DofSpring2Constraint::getInfo1(info);
        rows_ = info->m_numConstraintRows;
    }

    void getInfo2(btConstraintInfo2* info) override {
        const btScalar pace = is_within_limits() ? btScalar(1) : info->erp;
        if (axis_ == 3)
            m_angularLimits[0].m_stopERP = pace;
        else
            m_linearLimits.m_stopERP[0] = pace;
        btGeneric6DofSpring2Constraint::getInfo2(info);
        correct_levers(*info);
    }

private:
    /// A limit ahead lets the bodies come right up to it within the substep, and no further; one
    /// that was passed is taken back at Bullet's usual pace.
    bool is_within_limits() const {
        if (axis_ == 3) {
            const btRotationalLimitMotor2& x = m_angularLimits[0];
            return x.m_currentLimit == 4 && x.m_currentLimitError >= 0 &&
                   x.m_currentLimitErrorHi <= 0;
        }
        return m_linearLimits.m_currentLimit[0] == 4 &&
               m_linearLimits.m_currentLimitError[0] >= 0 &&
               m_linearLimits.m_currentLimitErrorHi[0] <= 0;
    }

    /// Bullet lets each body feel a row at its own anchor. On a slider these are apart, and the two
    /// forces would turn the pair as a whole: both act at the second body's anchor instead.
    void correct_levers(btConstraintInfo2& info) const {
        const btVector3& point = m_calculatedTransformB.getOrigin();
        const btVector3 arm_1 = point - m_rbA.getCenterOfMassPosition();
        const btVector3 arm_2 = point - m_rbB.getCenterOfMassPosition();
        for (int row = 0; row < rows_; ++row) {
            const int at = row * info.rowskip;
            const btScalar* linear = info.m_J1linearAxis + at;
            const btVector3 axis(linear[0], linear[1], linear[2]);
            if (axis.isZero()) continue;
            const btVector3 turn_1 = arm_1.cross(axis);
            const btVector3 turn_2 = arm_2.cross(-axis);
            for (int i = 0; i < 3; ++i) {
                info.m_J1angularAxis[at + i] = turn_1[i];
                info.m_J2angularAxis[at + i] = turn_2[i];
            }
        }
    }

    const SolverJoint& joint_;
    btMatrix3x3 frame_in_b_;
    int axis_;  ///< the free one: 0 slides, 3 turns
    int rows_{0};
};

/// Distance and spring: rows along the line between the anchors.
class LineRows final : public btTypedConstraint {
public:
    explicit LineRows(const JointRecord& joint)
        : btTypedConstraint(MAX_CONSTRAINT_TYPE, rigid_of(joint.a), rigid_of(joint.b)),
          joint_(joint.solver) {}

    void getInfo1(btConstraintInfo1* info) override {
        info->m_numConstraintRows = has_two_rows() ? 2 : 1;
        info->nub = 0;
    }

    void getInfo2(btConstraintInfo2* info) override {
        const Line line = present_line();
        write(*info, 0, line);
        if (joint_.kind == JointKind::Spring) return pull(*info, line);
        if (!has_range()) {
            const Real length = joint_.limits ? (*joint_.limits)[0] : joint_.rest_length_m;
            info->m_constraintError[0] = info->fps * info->erp * (length - line.length);
            return;
        }
        // As with the other limits: one that is ahead may be reached, not passed.
        const auto [low, high] = *joint_.limits;
        int at = 0;
        if (has_two_rows()) {
            info->m_constraintError[0] =
                (low - line.length) * info->fps * (line.length < low ? info->erp : btScalar(1));
            info->m_lowerLimit[0] = 0;
            at = info->rowskip;
            write(*info, at, line);
        }
        info->m_constraintError[at] =
            (high - line.length) * info->fps * (line.length > high ? info->erp : btScalar(1));
        info->m_upperLimit[at] = 0;
    }

    void setParam(int, btScalar, int) override {}
    btScalar getParam(int, int) const override { return 0; }

private:
    struct Line {
        btVector3 direction;  ///< from b's anchor to a's
        btVector3 arm_a;
        btVector3 arm_b;
        btScalar length;
    };

    /// The first row may be that of the lower limit; a rope, from 0 up, has only the upper one.
    bool has_range() const {
        return joint_.kind == JointKind::Distance && has_limits_of_both_sides(joint_.limits);
    }
    bool has_two_rows() const { return has_range() && (*joint_.limits)[0] > 0; }

    Line present_line() const {
        Line line;
        line.arm_a = m_rbA.getWorldTransform().getBasis() * bullet_from_double(joint_.anchor_in_a);
        line.arm_b = m_rbB.getWorldTransform().getBasis() * bullet_from_double(joint_.anchor_in_b);
        const btVector3 gap = (m_rbA.getCenterOfMassPosition() - m_rbB.getCenterOfMassPosition()) +
                              (line.arm_a - line.arm_b);
        line.length = gap.length();
        // Anchors on one spot: any direction will do.
        line.direction = line.length > SIMD_EPSILON ? gap / line.length : btVector3(0, 1, 0);
        return line;
    }

    static void write(btConstraintInfo2& info, int at, const Line& line) {
        const btVector3 turn_a = line.arm_a.cross(line.direction);
        const btVector3 turn_b = line.arm_b.cross(line.direction);
        for (int i = 0; i < 3; ++i) {
            info.m_J1linearAxis[at + i] = line.direction[i];
            info.m_J1angularAxis[at + i] = turn_a[i];
            info.m_J2linearAxis[at + i] = -line.direction[i];
            info.m_J2angularAxis[at + i] = -turn_b[i];
        }
    }

    /// What the body takes part in a push along the line, and how fast its anchor will move along it
    /// once the substep's forces have acted.
    struct Share {
        btScalar inverse_mass;
        btScalar speed;
    };
    static Share share_of(const btRigidBody& rigid,
                          const btVector3& arm,
                          const btVector3& direction,
                          btScalar substep_s) {
        const btVector3 turn = arm.cross(direction);
        const btVector3 turned = rigid.getInvInertiaTensorWorld() * turn;
        return {.inverse_mass = rigid.getInvMass() + turn.dot(turned),
                .speed = rigid.getVelocityInLocalPoint(arm).dot(direction) +
                         substep_s * (rigid.getInvMass() * rigid.getTotalForce().dot(direction) +
                                      rigid.getTotalTorque().dot(turned))};
    }

    /// The spring's impulse is known beforehand, so the row is one that always reaches its bound.
    /// The force is that of the present stretch (symplectic Euler: the energy stays bounded), the
    /// damping that of the speed after it. A spring too stiff for the substep, with its frequency
    /// above 1 rad per substep, is softened to that.
    void pull(btConstraintInfo2& info, const Line& line) const {
        const btScalar h = 1 / info.fps;
        const Share a = share_of(m_rbA, line.arm_a, line.direction, h);
        const Share b = share_of(m_rbB, line.arm_b, line.direction, h);
        const btScalar inverse_mass = a.inverse_mass + b.inverse_mass;
        btScalar impulse = 0;
        if (inverse_mass > 0) {
            const btScalar mass = 1 / inverse_mass;
            const btScalar speed = a.speed - b.speed;
            const btScalar stiffness = std::min(joint_.stiffness_Npm, mass / (h * h));
            const btScalar pulled =
                speed - h * stiffness * inverse_mass * (line.length - joint_.rest_length_m);
            const btScalar after = pulled / (1 + joint_.damping_Nspm * h * inverse_mass);
            impulse = (after - speed) * mass;
        }
        info.m_lowerLimit[0] = std::min(impulse, btScalar(0));
        info.m_upperLimit[0] = std::max(impulse, btScalar(0));
        info.m_constraintError[0] = impulse < 0 ? -2 * kMaxSpeed_mps : 2 * kMaxSpeed_mps;
    }

    const SolverJoint& joint_;
};

std::unique_ptr<btTypedConstraint> make_ball(const JointRecord& joint) {
    return std::make_unique<btPoint2PointConstraint>(rigid_of(joint.a),
                                                     rigid_of(joint.b),
                                                     bullet_from_double(joint.solver.anchor_in_a),
                                                     bullet_from_double(joint.solver.anchor_in_b));
}

std::unique_ptr<btTypedConstraint> make_cone(const JointRecord& joint) {
    constexpr btScalar kFree = BT_LARGE_FLOAT;
    const SolverJoint& solver = joint.solver;
    btTransform frame_in_b = frame_of(solver.frame_in_b, solver.anchor_in_b);
    btScalar twist = kFree;
    if (solver.twist_limits) {
        // Bullet's twist reaches as far to either side: b's frame is turned to the middle.
        const auto [low, high] = *solver.twist_limits;
        twist = (high - low) / 2;
        frame_in_b.getBasis() *= btMatrix3x3(btQuaternion({1, 0, 0}, (low + high) / 2));
    }
    btScalar swing = kFree;
    if (solver.limits) {
        const auto [low, high] = *solver.limits;
        const btScalar widest = std::max(std::abs(low), std::abs(high));
        if (widest < kPi) swing = widest;
    }
    auto cone =
        std::make_unique<btConeTwistConstraint>(rigid_of(joint.a),
                                                rigid_of(joint.b),
                                                frame_of(solver.frame_in_a, solver.anchor_in_a),
                                                frame_in_b);
    cone->setLimit(swing, swing, twist);
    cone->setFixThresh(btScalar(1e-3));
    return cone;
}

/// Whether the latest substep solved it: its island was awake.
bool was_solved(const JointRecord& joint) {
    const auto moves = [](const BodyRecord* record) {
        return record != nullptr && pushable(*record) && record->rigid->isActive();
    };
    return moves(joint.a) || moves(joint.b);
}

std::unique_ptr<btTypedConstraint> constraint_of(const JointRecord& joint) {
    switch (joint.solver.kind) {
        case JointKind::BallAndSocket:
        case JointKind::Elastic:  // which neither stretches nor resists bending there
            return make_ball(joint);
        case JointKind::Cone:
            return make_cone(joint);
        case JointKind::Hinge:
        case JointKind::Slider:
        case JointKind::Fixed:
            return std::make_unique<SixAxes>(joint);
        case JointKind::Distance:
        case JointKind::Spring:
            break;
    }
    return std::make_unique<LineRows>(joint);
}

}  // namespace

struct BulletJoint::Impl {
    Impl(JointRecord& of, StepWorld& in) : joint(of), world(in) {}

    JointRecord& joint;
    StepWorld& world;
    std::unique_ptr<btTypedConstraint> constraint{};
    btJointFeedback feedback{};  ///< what the latest substep carried
    Vec3d carried_Ns{0, 0, 0};   ///< on a, so far in the running step
    Vec3d carried_Nms{0, 0, 0};  ///< about a's anchor
    double solved_s{0};  ///< for how much of the running step; less where sleep cut it short
};

BulletJoint::BulletJoint(JointRecord& joint, StepWorld& world)
    : impl_(std::make_unique<Impl>(joint, world)) {
    impl_->constraint = constraint_of(joint);
    for (btVector3* load : {&impl_->feedback.m_appliedForceBodyA,
                            &impl_->feedback.m_appliedForceBodyB,
                            &impl_->feedback.m_appliedTorqueBodyA,
                            &impl_->feedback.m_appliedTorqueBodyB})
        load->setZero();
    impl_->constraint->setJointFeedback(&impl_->feedback);
    impl_->constraint->setUserConstraintPtr(&joint);
    world.addConstraint(impl_->constraint.get());
}

BulletJoint::~BulletJoint() {
    impl_->world.removeConstraint(impl_->constraint.get());
}

void BulletJoint::drive() {
    if (auto* axes = dynamic_cast<SixAxes*>(impl_->constraint.get())) axes->drive();
}

void BulletJoint::begin_step() {
    impl_->carried_Ns = {0, 0, 0};
    impl_->carried_Nms = {0, 0, 0};
    impl_->solved_s = 0;
    const SolverJoint& solver = impl_->joint.solver;
    if (solver.kind == JointKind::Hinge)
        static_cast<SixAxes&>(*impl_->constraint).follow(solver.position);
}

void BulletJoint::gather(double substep_s) {
    const JointRecord& joint = impl_->joint;
    if (!was_solved(joint)) return;
    impl_->solved_s += substep_s;
    const btRigidBody& a = *joint.a->rigid;
    const bool first = &impl_->constraint->getRigidBodyA() == &a;
    const btJointFeedback& load = impl_->feedback;
    const Vec3d force =
        double_from_bullet(first ? load.m_appliedForceBodyA : load.m_appliedForceBodyB);
    const Vec3d torque =
        double_from_bullet(first ? load.m_appliedTorqueBodyA : load.m_appliedTorqueBodyB);
    // Where a was when the rows were made; Bullet's torque is about its centre of mass.
    const Vec3d arm{joint.a->before.at.rotation * Vec3{joint.solver.anchor_in_a}};
    impl_->carried_Ns += force * substep_s;
    impl_->carried_Nms += (torque - glm::cross(arm, force)) * substep_s;
}

void BulletJoint::serialize(Archive& archive) {
    archive(impl_->feedback);
}

JointRecord& joint_of(btTypedConstraint& constraint) {
    return *static_cast<JointRecord*>(constraint.getUserConstraintPtr());
}

std::optional<JointMeanLoad> BulletJoint::mean_load() const {
    const double time_s = impl_->solved_s;
    if (!(time_s > 0)) return std::nullopt;
    return JointMeanLoad{.force_N = glm::length(impl_->carried_Ns) / time_s,
                         .torque_Nm = glm::length(impl_->carried_Nms) / time_s};
}

}  // namespace plumbline::physics
