// One fixed step: who is taken out, what is stepped, which events are left.
#include "engine/core/stopwatch.h"
#include "engine/physics/bullet_convert_impl.h"
#include "engine/physics/physics_world_impl.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// v shortened to `limit`. Divides by the largest part first: the square of 1e30 is infinite.
btVector3 limited(const btVector3& v, btScalar limit) {
    const btScalar largest = v.absolute()[v.absolute().maxAxis()];
    if (largest * btScalar(2) < limit) return v;
    const btVector3 direction = v / largest;
    const btScalar length = direction.length();
    return largest > limit / length ? direction * (limit / length) : v;
}

/// Keeps a caller's force from driving the body past the speed limit within this step: Bullet
/// would turn 1e9 N on a pebble into infinities that reach its neighbours.
void limit_force(BodyRecord& record, btScalar step_s) {
    btRigidBody& rigid = *record.rigid;
    const btScalar gain = rigid.getInvMass() * step_s;
    const btVector3 force = limited(rigid.getTotalForce(), kMaxSpeed_mps / gain);
    // The smallest moment gives the most spin for a torque.
    const btVector3& inverse_inertia = rigid.getInvInertiaDiagLocal();
    const btScalar turn_gain = inverse_inertia[inverse_inertia.maxAxis()] * step_s;
    const btVector3 torque = limited(rigid.getTotalTorque(), kMaxSpin_radps / turn_gain);
    rigid.clearForces();
    rigid.applyCentralForce(force);
    rigid.applyTorque(torque);
}

bool is_sound(const btRigidBody& rigid) {
    const btVector3& x = rigid.getWorldTransform().getOrigin();
    const btVector3& v = rigid.getLinearVelocity();
    const btVector3& w = rigid.getAngularVelocity();
    // One comparison catches NaN, infinity and distance: a NaN makes it false.
    return x.length2() <= kMaxDistance_m * kMaxDistance_m && std::isfinite(v.length2()) &&
           std::isfinite(w.length2());
}

}  // namespace

void PhysicsWorld::Impl::poison(BodyRecord& record) {
    // What does not move by itself stays sound: the call that would spoil it is just not obeyed.
    if (record.poisoned || !record.in_world || record.kind != BodyKind::Dynamic) return;
    record.poisoned = true;
    poisoned.push_back(record.id);
}

void PhysicsWorld::Impl::quarantine(BodyRecord& record) {
    if (!record.in_world) return;
    remove_joints_of(record);
    leave_world(record);
    record.rigid->clearForces();
    record.rigid->setLinearVelocity({0, 0, 0});
    record.rigid->setAngularVelocity({0, 0, 0});
    record.flight.going = false;
    quarantined.push_back(record.id);
}

void PhysicsWorld::step() {
    Impl& impl = *impl_;
    StepWorld& world = *impl.world;
    const double started_s = thread_cpu_s();
    for (const BodyId id : impl.poisoned) {
        if (impl.bodies.contains(id)) impl.quarantine(impl.body(id));
    }
    impl.poisoned.clear();

    impl.cost = {};
    impl.use = {};
    world.cost = {};
    world.use = {};
    world.features = impl.features;
    world.want_contacts = impl.features.contact_events && impl.event_bodies > 0;
    impl.gathered.clear();
    impl.events.clear();
    const auto step_s = static_cast<btScalar>(impl.def.step_s);
    const auto substep_s = static_cast<btScalar>(impl.def.step_s / impl.def.substeps);

    impl.prepare_bodies(step_s);
    impl.prepare_joints();
    for (int i = 0; i < impl.def.substeps; ++i) {
        world.last_substep = i + 1 == impl.def.substeps;
        world.advance(substep_s);
        impl.gather_joint_loads(impl.def.step_s / impl.def.substeps);
    }
    impl.settle_bodies();
    impl.settle_joints();
    if (world.want_contacts)
        impl.finish_events();
    else
        impl.touching.clear();

    const StepCost counted = impl.cost;
    impl.cost = world.cost;
    impl.cost.row_solves = counted.row_solves;
    impl.cost.contacts = counted.contacts;
    impl.use = world.use;
    impl.use.events = static_cast<std::uint32_t>(impl.events.size());
    impl.cost.total_ms = (thread_cpu_s() - started_s) * 1e3;
}

/// Gravity, the callers' forces and the way of kinematic bodies, before the first substep.
void PhysicsWorld::Impl::prepare_bodies(Real step_s) {
    const auto& moving = world->getNonStaticRigidBodies();
    for (int i = 0; i < moving.size(); ++i) {
        btRigidBody& rigid = *moving[i];
        BodyRecord& record = record_of(rigid);
        if (record.kind == BodyKind::Kinematic) {
            if (record.has_target) {
                btVector3 velocity;
                btVector3 spin;
                btTransformUtil::calculateVelocity(
                    rigid.getWorldTransform(), record.target, step_s, velocity, spin);
                rigid.setLinearVelocity(velocity);
                rigid.setAngularVelocity(spin);
            } else if (record.driven) {
                rigid.setLinearVelocity({0, 0, 0});
                rigid.setAngularVelocity({0, 0, 0});
            }
            record.driven = record.has_target;
            const bool still =
                rigid.getLinearVelocity().isZero() && rigid.getAngularVelocity().isZero();
            // An awake kinematic body keeps all it touches awake.
            rigid.forceActivationState(still ? ISLAND_SLEEPING : ACTIVE_TAG);
            continue;
        }
        if (!rigid.isActive()) continue;
        rigid.applyCentralForce(record.weight_N);
        if (record.forced) limit_force(record, step_s);
        const btVector3 velocity = limited(rigid.getLinearVelocity(), kMaxSpeed_mps);
        if (velocity != rigid.getLinearVelocity()) {
            rigid.setLinearVelocity(velocity);
            record.flight.going = false;
        }
    }
}

/// Clears forces and takes out what the step made non-finite.
void PhysicsWorld::Impl::settle_bodies() {
    std::vector<BodyRecord*> broken;
    const auto& moving = world->getNonStaticRigidBodies();
    for (int i = 0; i < moving.size(); ++i) {
        btRigidBody& rigid = *moving[i];
        BodyRecord& record = record_of(rigid);
        rigid.clearForces();
        record.forced = false;
        record.has_target = false;
        if (!is_sound(rigid)) broken.push_back(&record);
    }
    for (BodyRecord* record : broken) {
        const btTransform last = record->before;
        quarantine(*record);
        record->rigid->setCenterOfMassTransform(last);
    }
}

}  // namespace plumbline::physics
