#include "engine/bullet_world/mirrored_joints.h"

#include "engine/physics/totals.h"

namespace plumbline::bullet_world {
namespace {

using physics::BodyId;
using physics::PhysicsWorld;

bool same_pose(const Pose& a, const Pose& b) {
    return a.position == b.position && a.orientation == b.orientation;
}

bool same_but_for_motor(const ForeignJoint& a, const ForeignJoint& b) {
    return a.kind == b.kind && a.a == b.a && a.b == b.b &&
           same_pose(a.a_from_joint, b.a_from_joint) && same_pose(a.b_from_joint, b.b_from_joint) &&
           a.limits == b.limits && a.twist_limits == b.twist_limits && a.break_N == b.break_N;
}

bool same_motor(const std::optional<physics::JointMotor>& a,
                const std::optional<physics::JointMotor>& b) {
    if (!a || !b) return !a && !b;
    return a->target == b->target && a->max == b->max;
}

/// Of the body that stands for it, or where none does of the object itself.
Pose pose_in(const PhysicsWorld& world, BodyId body, const btRigidBody& rigid) {
    if (body == BodyId{}) return pose_of(rigid.getWorldTransform());
    return world.state(body).world_from_body;
}

void fill(btJointFeedback& feedback, const physics::JointLoad& load) {
    const auto real = [](const Vec3d& v) { return bullet_of(Vec3(v)); };
    feedback.m_appliedForceBodyA = real(load.force_on_a_N);
    feedback.m_appliedTorqueBodyA = real(load.torque_on_a_Nm);
    feedback.m_appliedForceBodyB = real(-load.force_on_a_N);
    feedback.m_appliedTorqueBodyB = real(load.torque_on_b_Nm);
}

bool can_move(const PhysicsWorld& world, BodyId body) {
    return body != BodyId{} && world.state(body).kind == physics::BodyKind::Dynamic;
}

/// Joints hold bodies as they are when made. Bullet's frames may be apart then: they are led together for
/// that moment.
class Aligned {
public:
    Aligned(PhysicsWorld& world, BodyId a, BodyId b, const ForeignJoint& joint)
        : world_from_joint(can_move(world, b)
                               ? compose(pose_in(world, a, *joint.a), joint.a_from_joint)
                               : compose(pose_in(world, b, *joint.b), joint.b_from_joint)),
          world_(world),
          moved_(can_move(world, b) ? b : a),
          before_(world.state(moved_).world_from_body) {
        const Pose& body_from_joint = moved_ == b ? joint.b_from_joint : joint.a_from_joint;
        world.set_pose(moved_, compose(world_from_joint, invert(body_from_joint)));
    }
    ~Aligned() { world_.set_pose(moved_, before_); }
    Aligned(const Aligned&) = delete;
    Aligned& operator=(const Aligned&) = delete;

    Pose world_from_joint{};

private:
    PhysicsWorld& world_;
    BodyId moved_{};
    Pose before_{};
};

}  // namespace

BodyId MirroredJoints::body_of(const btRigidBody& rigid) const {
    const Mirror* mirror = bodies_.find(rigid);
    return mirror != nullptr ? mirror->body : BodyId{};
}

void MirroredJoints::read(PhysicsWorld& world,
                          const btDiscreteDynamicsWorld& constraints,
                          std::vector<btTypedConstraint*>& left) {
    const auto step_s = static_cast<Real>(world.def().step_s);
    left.clear();
    for (int i = 0; i < constraints.getNumConstraints(); ++i) {
        auto* constraint = const_cast<btTypedConstraint*>(constraints.getConstraint(i));
        if (!constraint->isEnabled()) {
            remove(world, *constraint);
            continue;
        }
        auto wanted = foreign_joint(*constraint, step_s);
        if (!wanted) {
            remove(world, *constraint);
            left.push_back(constraint);
            continue;
        }
        if (body_of(*wanted->a) == BodyId{}) exchange(*wanted);
        Entry& entry = entries_[constraint];
        if (!stands(world, entry, *wanted)) {
            if (world.contains(entry.joint)) physics::destroy_joint(world, entry.joint);
            make(world, entry, *wanted);
        } else if (!same_motor(entry.made_from.motor, wanted->motor)) {
            world.set_joint_motor(entry.joint, wanted->motor);
        }
        entry.made_from = *wanted;
    }
}

bool MirroredJoints::stands(const PhysicsWorld& world,
                            const Entry& entry,
                            const ForeignJoint& wanted) const {
    if (entry.made_from.a == nullptr || !same_but_for_motor(entry.made_from, wanted)) return false;
    if (entry.a != body_of(*wanted.a) || entry.b != body_of(*wanted.b)) return false;
    return world.contains(entry.joint) || !(can_move(world, entry.a) || can_move(world, entry.b));
}

void MirroredJoints::make(PhysicsWorld& world, Entry& entry, const ForeignJoint& wanted) {
    entry.a = body_of(*wanted.a);
    entry.b = body_of(*wanted.b);
    entry.joint = {};
    if (!can_move(world, entry.a) && !can_move(world, entry.b)) return;
    const Aligned aligned(world, entry.a, entry.b, wanted);
    const Pose& at = aligned.world_from_joint;
    const auto made = world.create_joint({.kind = wanted.kind,
                                          .a = entry.a,
                                          .b = entry.b,
                                          .anchor_a_world = at.position,
                                          .anchor_b_world = at.position,
                                          .axis_world = at.orientation * Vec3{0, 0, 1},
                                          .limits = wanted.limits,
                                          .twist_limits = wanted.twist_limits,
                                          .motor = wanted.motor,
                                          .collide = true,  // PairRules say what may touch
                                          .break_N = wanted.break_N});
    if (made)
        entry.joint = *made;
    else
        notes_.add("a constraint is left out: " + made.error().message);
}

void MirroredJoints::write(const PhysicsWorld& world) {
    for (auto& [constraint, entry] : entries_) {
        if (!world.contains(entry.joint)) continue;
        const physics::JointState& state = world.joint(entry.joint).state;
        constraint->internalSetAppliedImpulse(state.force_N *
                                              static_cast<Real>(world.def().step_s));
        if (btJointFeedback* feedback = constraint->getJointFeedback())
            fill(*feedback, joint_load(world, entry.joint));
        if (state.broken) constraint->setEnabled(false);
    }
}

void MirroredJoints::remove(PhysicsWorld& world, btTypedConstraint& constraint) {
    const auto entry = entries_.find(&constraint);
    if (entry == entries_.end()) return;
    if (world.contains(entry->second.joint)) physics::destroy_joint(world, entry->second.joint);
    entries_.erase(entry);
}

}  // namespace plumbline::bullet_world
