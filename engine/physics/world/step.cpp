// One fixed step: who is taken out, what is stepped, which events are left.
#include "engine/core/stopwatch.h"
#include "engine/physics/bullet/convert.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

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

void prepare_kinematic(BodyRecord& record, btScalar step_s) {
    btRigidBody& rigid = *record.rigid;
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
    const bool still = rigid.getLinearVelocity().isZero() && rigid.getAngularVelocity().isZero();
    // An awake kinematic body keeps all it touches awake.
    rigid.forceActivationState(still ? ISLAND_SLEEPING : ACTIVE_TAG);
}

/// Whether the speed limit cut its motion.
bool prepare_dynamic(BodyRecord& record, btScalar step_s) {
    btRigidBody& rigid = *record.rigid;
    rigid.applyCentralForce(record.weight_N);
    if (record.forced) limit_force(record, step_s);
    bool was_limited = false;
    const btVector3 velocity = limited(rigid.getLinearVelocity(), kMaxSpeed_mps);
    if (velocity != rigid.getLinearVelocity()) {
        rigid.setLinearVelocity(velocity);
        record.flight.going = false;
        was_limited = true;
    }
    const btVector3 spin = limited(rigid.getAngularVelocity(), kMaxSpin_radps);
    if (spin != rigid.getAngularVelocity()) {
        rigid.setAngularVelocity(spin);
        record.flight.going = false;
        was_limited = true;
    }
    return was_limited;
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
    const double started_s = thread_cpu_s();
    for (const BodyId id : impl.poisoned) {
        if (impl.bodies.contains(id)) impl.quarantine(impl.body(id));
    }
    impl.poisoned.clear();

    impl.cost = {};
    impl.use = {};
    impl.gathered.clear();
    const bool want_contacts = impl.features.contact_events && impl.event_bodies > 0;
    if (impl.small)
        impl.advance_small(want_contacts);
    else
        impl.advance_bullet(want_contacts);
    if (want_contacts)
        impl.finish_events();
    else
        impl.events.clear();
    impl.use.events = static_cast<std::uint32_t>(impl.events.size());
    impl.cost.total_ms = (thread_cpu_s() - started_s) * 1e3;
}

void PhysicsWorld::Impl::advance_bullet(bool want_contacts) {
    world->cost = {};
    world->use = {};
    world->features = features;
    world->want_contacts = want_contacts;
    prepare_bodies(static_cast<btScalar>(def.step_s));
    prepare_joints();
    for (int i = 0; i < def.substeps; ++i) {
        world->last_substep = i + 1 == def.substeps;
        world->advance(static_cast<btScalar>(def.step_s / def.substeps));
        gather_joint_loads(def.step_s / def.substeps);
    }
    settle_bodies();
    settle_joints();
    const StepCost counted = cost;
    cost = world->cost;
    cost.row_solves = counted.row_solves;
    cost.contacts = counted.contacts;
    cost.interventions.limited_bodies = limited_bodies;
    use = world->use;
}

void PhysicsWorld::Impl::advance_small(bool want_contacts) {
    small->begin_step();
    broken_joints.clear();
    slept_through = small->idle();
    if (slept_through) return;
    prepare_bodies(static_cast<btScalar>(def.step_s));
    prepare_joints();
    small->cost = {};
    small->use = {};
    small->step(features, want_contacts);
    settle_bodies();
    settle_joints();
    cost = small->cost;
    cost.interventions.limited_bodies = limited_bodies;
    use = small->use;
}

template <class Fn>
void PhysicsWorld::Impl::each_moving(Fn&& fn) {
    if (small) {
        for (BodyRecord* record : small->awake()) fn(*record);
        for (BodyRecord* record : small->carriers()) fn(*record);
        return;
    }
    const auto& moving = world->getNonStaticRigidBodies();
    for (int i = 0; i < moving.size(); ++i) fn(record_of(*moving[i]));
}

/// Gravity, the callers' forces and the way of kinematic bodies, before the first substep.
void PhysicsWorld::Impl::prepare_bodies(Real step_s) {
    limited_bodies = 0;
    each_moving([this, step_s](BodyRecord& record) {
        if (record.kind == BodyKind::Kinematic)
            prepare_kinematic(record, step_s);
        else if (record.rigid->isActive() && prepare_dynamic(record, step_s))
            ++limited_bodies;
    });
}

/// Clears forces and takes out what the step made non-finite.
void PhysicsWorld::Impl::settle_bodies() {
    std::vector<BodyRecord*> broken;
    each_moving([&broken](BodyRecord& record) {
        record.rigid->clearForces();
        record.forced = false;
        record.has_target = false;
        if (!is_sound(*record.rigid)) broken.push_back(&record);
    });
    for (BodyRecord* record : broken) {
        const btTransform last = record->before;
        quarantine(*record);
        record->rigid->setCenterOfMassTransform(last);
    }
}

}  // namespace plumbline::physics
