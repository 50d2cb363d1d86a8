// Bodies: made, moved, pushed, frozen and taken out.
#include "engine/physics/bullet/convert.h"
#include "engine/physics/world/small_step_world.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Slower than both for two seconds sleeps. Well below anything a person sees moving (a snail makes
/// 1 cm/s, but a thing that slides that slowly is about to stop); bodies in the air never sleep.
constexpr btScalar kSleepSpeed_mps = btScalar(0.05);
constexpr btScalar kSleepSpin_radps = btScalar(0.1);

bool nearly_equal(const Vec3d& inertia) {
    const double largest = std::max({inertia.x, inertia.y, inertia.z});
    const double smallest = std::min({inertia.x, inertia.y, inertia.z});
    return largest - smallest <= 1e-5 * largest;
}

/// Mass, inertia and the mass frame the definition asks for.
void weigh(BodyRecord& record, const BodyDef& def, const ShapeRecord& shape) {
    record.body_from_mass = shape.body_from_mass;
    record.mass_frame_is_body = shape.mass_frame_is_body;
    record.mass_kg = static_cast<double>(def.mass_kg);
    record.inertia_kgm2 = record.mass_kg * shape.inertia_per_kg;
    if (shape.mesh) return;  // stands or is carried: no mass frame to choose
    if (def.inertia_kgm2) {
        record.inertia_kgm2 = Vec3d{*def.inertia_kgm2};
        record.body_from_mass.orientation = kNoRotation;
    }
    if (def.center_of_mass_m) record.body_from_mass.position = *def.center_of_mass_m;
    record.mass_frame_is_body = record.body_from_mass.position == Vec3{0, 0, 0} &&
                                record.body_from_mass.orientation == kNoRotation;
    record.round_inertia = nearly_equal(record.inertia_kgm2);
}

/// The shape as seen from the body's mass frame; a compound of one where the two differ.
btCollisionShape* fitted_shape(BodyRecord& record, const ShapeRecord& shape) {
    const bool same_frame = record.body_from_mass.position == shape.body_from_mass.position &&
                            record.body_from_mass.orientation == shape.body_from_mass.orientation;
    const Pose mass_from_shape =
        same_frame ? Pose{} : compose(invert(record.body_from_mass), shape.body_from_mass);
    record.cores = shape.cores;
    record.smallest_core_m = shape.cores.empty() ? 0 : shape.cores.front().radius_m;
    for (Core& core : record.cores) {
        core.center_m = transform_point(mass_from_shape, core.center_m);
        record.smallest_core_m = std::min(record.smallest_core_m, core.radius_m);
    }
    if (same_frame) return shape.collision;
    record.wrapper = std::make_unique<btCompoundShape>();
    record.wrapper->addChildShape(to_bullet(mass_from_shape), shape.collision);
    return record.wrapper.get();
}

std::unique_ptr<btRigidBody> make_rigid(const BodyRecord& record,
                                        const BodyDef& def,
                                        btCollisionShape* collision) {
    const bool dynamic = def.kind == BodyKind::Dynamic;
    btRigidBody::btRigidBodyConstructionInfo info(
        dynamic ? static_cast<btScalar>(record.mass_kg) : btScalar(0),
        nullptr,
        collision,
        dynamic ? bullet_from_double(record.inertia_kgm2) : btVector3(0, 0, 0));
    info.m_friction = def.friction;
    info.m_rollingFriction = def.rolling_friction;
    info.m_spinningFriction = def.spinning_friction;
    info.m_restitution = def.restitution;
    info.m_linearSleepingThreshold = kSleepSpeed_mps;
    info.m_angularSleepingThreshold = kSleepSpin_radps;
    auto rigid = std::make_unique<btRigidBody>(info);
    // Gyroscopic torque and gravity are the step's business (step_world.cpp), not Bullet's.
    rigid->setFlags(BT_DISABLE_WORLD_GRAVITY);
    if (def.kind == BodyKind::Kinematic) {
        rigid->setCollisionFlags(
            (rigid->getCollisionFlags() & ~btCollisionObject::CF_STATIC_OBJECT) |
            btCollisionObject::CF_KINEMATIC_OBJECT);
    }
    return rigid;
}

btVector3 arm_of_origin(const BodyRecord& record) {
    return record.rigid->getWorldTransform().getBasis() *
           to_bullet(invert(record.body_from_mass).position);
}

void set_velocity_of_origin(BodyRecord& record, const Vec3& velocity, const Vec3& spin) {
    btVector3 v = to_bullet(velocity);
    const btVector3 w = to_bullet(spin);
    if (!record.mass_frame_is_body) v -= w.cross(arm_of_origin(record));
    record.rigid->setLinearVelocity(v * to_bullet(record.linear_factor));
    record.rigid->setAngularVelocity(w);
    record.flight.going = false;
}

}  // namespace

btTransform PhysicsWorld::Impl::world_from_mass(const BodyRecord& record,
                                                const Pose& world_from_body) const {
    return to_bullet(record.mass_frame_is_body ? world_from_body
                                               : compose(world_from_body, record.body_from_mass));
}

void PhysicsWorld::Impl::place(BodyRecord& record, const btTransform& to) {
    record.rigid->setCenterOfMassTransform(to);
    record.before = to;
    record.target = to;
    record.flight.going = false;
    if (record.in_world) world->updateSingleAabb(record.rigid.get());
}

void PhysicsWorld::Impl::enter_world(BodyRecord& record) {
    // The pair filter reads the record; Bullet's own two masks must only not say no.
    record.in_world = true;
    world->addRigidBody(record.rigid.get(), -1, -1);
    record.rigid->setDeactivationTime(0);
    if (small) {
        small->enter(record);
    } else if (pushable(record)) {
        record.rigid->forceActivationState(record.can_sleep ? ACTIVE_TAG : DISABLE_DEACTIVATION);
    } else {
        record.rigid->forceActivationState(ISLAND_SLEEPING);
    }
}

void PhysicsWorld::Impl::leave_world(BodyRecord& record) {
    if (!record.in_world) return;
    wake_neighbours(record);
    if (small) small->leave(record);
    world->removeRigidBody(record.rigid.get());
    record.in_world = false;
}

BodyId PhysicsWorld::create_body(const BodyDef& def) {
    const ShapeRecord& shape = *impl_->shapes.get(def.shape);
    PL_ASSERT(def.kind != BodyKind::Dynamic || !shape.static_only,
              "planes and meshes only as static or kinematic bodies");
    PL_ASSERT(def.kind != BodyKind::Dynamic || def.mass_kg > 0, "a dynamic body that has mass");
    auto owned = std::make_unique<BodyRecord>();
    BodyRecord& record = *owned;
    record.shape = def.shape;
    record.kind = def.kind;
    record.user = def.user;
    record.group = def.group;
    record.collides_with = def.collides_with;
    record.ccd = def.ccd;
    record.can_sleep = def.can_sleep;
    record.linear_damping_per_s = static_cast<double>(def.linear_damping_per_s);
    record.angular_damping_per_s = static_cast<double>(def.angular_damping_per_s);
    record.linear_factor = def.linear_factor;
    weigh(record, def, shape);
    btCollisionShape* collision = fitted_shape(record, shape);
    record.rigid = make_rigid(record, def, collision);
    record.rigid->setUserPointer(&record);
    if (record.held_along_axes()) record.rigid->setLinearFactor(to_bullet(def.linear_factor));
    record.radius_m = collision->getAngularMotionDisc();
    record.touch_m = collision->getContactBreakingThreshold(gContactBreakingThreshold);
    impl_->suit_to_world(record);

    const BodyId id = impl_->bodies.insert(std::move(owned));
    record.id = id;
    const bool sound = is_finite(def.world_from_body) && is_finite(def.velocity_mps) &&
                       is_finite(def.angular_velocity_radps);
    if (is_finite(def.world_from_body)) {
        impl_->place(record, impl_->world_from_mass(record, def.world_from_body));
    }
    impl_->enter_world(record);
    if (sound && def.kind != BodyKind::Static) {
        set_velocity_of_origin(record, def.velocity_mps, def.angular_velocity_radps);
        if (impl_->small && def.kind == BodyKind::Kinematic) impl_->small->stir(record);
    }
    if (!sound) {
        record.poisoned = true;
        impl_->poisoned.push_back(id);
    }
    if (def.contact_events) set_contact_events(id, true);
    return id;
}

bool PhysicsWorld::reserve_body(BodyId id) {
    return impl_->bodies.reserve(id);
}

void PhysicsWorld::destroy_body(BodyId id) {
    if (!impl_->bodies.contains(id)) return;
    BodyRecord& record = impl_->body(id);
    set_contact_events(id, false);
    impl_->remove_joints_of(record);
    impl_->leave_world(record);
    impl_->bodies.erase(id);
}

bool PhysicsWorld::contains(BodyId id) const {
    return impl_->bodies.contains(id);
}

BodyState PhysicsWorld::state(BodyId id) const {
    const BodyRecord& record = impl_->body(id);
    const btRigidBody& rigid = *record.rigid;
    BodyState state{.world_from_body = from_bullet(rigid.getWorldTransform()),
                    .velocity_mps = from_bullet(rigid.getLinearVelocity()),
                    .angular_velocity_radps = from_bullet(rigid.getAngularVelocity()),
                    .awake = record.in_world && rigid.isActive()};
    if (!record.mass_frame_is_body) {
        state.world_from_body = compose(state.world_from_body, invert(record.body_from_mass));
        state.velocity_mps += from_bullet(rigid.getAngularVelocity().cross(arm_of_origin(record)));
    }
    return state;
}

BodyKind PhysicsWorld::kind(BodyId id) const {
    return impl_->body(id).kind;
}

MassProperties PhysicsWorld::mass_properties(BodyId id) const {
    const BodyRecord& record = impl_->body(id);
    if (record.kind != BodyKind::Dynamic) return {};
    return {.mass_kg = static_cast<Real>(record.mass_kg),
            .inertia_kgm2 = Vec3{record.inertia_kgm2},
            .center_of_mass_m = record.body_from_mass.position};
}

std::uint64_t PhysicsWorld::user(BodyId id) const {
    return impl_->body(id).user;
}

bool PhysicsWorld::groups_touch(BodyId a, BodyId b) const {
    const BodyRecord& record_a = impl_->body(a);
    const BodyRecord& record_b = impl_->body(b);
    return (record_a.group & record_b.collides_with) != 0 &&
           (record_b.group & record_a.collides_with) != 0;
}

void PhysicsWorld::bounds(BodyId id, Vec3& min_world, Vec3& max_world) const {
    const btRigidBody& rigid = *impl_->body(id).rigid;
    btVector3 low;
    btVector3 high;
    rigid.getCollisionShape()->getAabb(rigid.getWorldTransform(), low, high);
    min_world = from_bullet(low);
    max_world = from_bullet(high);
}

void PhysicsWorld::set_pose(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = impl_->body(id);
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return impl_->poison(record);
    impl_->wake_neighbours(record);
    impl_->place(record, impl_->world_from_mass(record, world_from_body));
    record.has_target = false;
    if (impl_->small) impl_->small->wake_overlapping(record);
    wake(id);
}

void PhysicsWorld::move_kinematic(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = impl_->body(id);
    PL_ASSERT(record.kind == BodyKind::Kinematic, "a kinematic body");
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return impl_->poison(record);
    record.target = impl_->world_from_mass(record, world_from_body);
    record.has_target = true;
    if (impl_->small) impl_->small->stir(record);
}

void PhysicsWorld::set_velocity(BodyId id,
                                const Vec3& velocity_mps,
                                const Vec3& angular_velocity_radps) {
    BodyRecord& record = impl_->body(id);
    if (!is_finite(velocity_mps) || !is_finite(angular_velocity_radps))
        return impl_->poison(record);
    if (record.kind == BodyKind::Static || !record.in_world || record.frozen) return;
    set_velocity_of_origin(record, velocity_mps, angular_velocity_radps);
    record.driven = false;
    if (impl_->small && record.kind == BodyKind::Kinematic) impl_->small->stir(record);
    wake(id);
}

void PhysicsWorld::apply_force(BodyId id, const Vec3& force_N) {
    BodyRecord& record = impl_->body(id);
    if (!is_finite(force_N)) return impl_->poison(record);
    if (!pushable(record)) return;
    record.rigid->applyCentralForce(to_bullet(force_N));
    record.forced = true;
    wake(id);
}

void PhysicsWorld::apply_force_at(BodyId id, const Vec3& force_N, const Vec3& point_world) {
    BodyRecord& record = impl_->body(id);
    const Vec3 arm = point_world - from_bullet(record.rigid->getWorldTransform().getOrigin());
    apply_force(id, force_N);
    apply_torque(id, glm::cross(arm, force_N));
}

void PhysicsWorld::apply_torque(BodyId id, const Vec3& torque_Nm) {
    BodyRecord& record = impl_->body(id);
    if (!is_finite(torque_Nm)) return impl_->poison(record);
    if (!pushable(record)) return;
    record.rigid->applyTorque(to_bullet(torque_Nm));
    record.forced = true;
    wake(id);
}

void PhysicsWorld::apply_impulse(BodyId id, const Vec3& impulse_Ns) {
    apply_impulse_at(
        id, impulse_Ns, from_bullet(impl_->body(id).rigid->getWorldTransform().getOrigin()));
}

void PhysicsWorld::apply_impulse_at(BodyId id, const Vec3& impulse_Ns, const Vec3& point_world) {
    BodyRecord& record = impl_->body(id);
    if (!is_finite(impulse_Ns) || !is_finite(point_world)) return impl_->poison(record);
    if (!pushable(record)) return;
    record.rigid->applyImpulse(
        to_bullet(impulse_Ns),
        to_bullet(point_world) - record.rigid->getWorldTransform().getOrigin());
    record.flight.going = false;
    wake(id);
}

void PhysicsWorld::set_frozen(BodyId id, bool frozen) {
    BodyRecord& record = impl_->body(id);
    if (record.kind != BodyKind::Dynamic || record.frozen == frozen || !record.in_world) return;
    impl_->leave_world(record);
    record.frozen = frozen;
    record.flight.going = false;
    impl_->weigh(record);
    btRigidBody& rigid = *record.rigid;
    rigid.clearForces();
    rigid.setLinearVelocity({0, 0, 0});
    rigid.setAngularVelocity({0, 0, 0});
    impl_->enter_world(record);
}

void PhysicsWorld::Impl::weigh(BodyRecord& record) {
    const bool frozen = record.frozen;
    record.rigid->setMassProps(
        frozen ? btScalar(0) : static_cast<btScalar>(record.mass_kg),
        frozen ? btVector3(0, 0, 0) : bullet_from_double(record.inertia_kgm2));
    record.rigid->updateInertiaTensor();
}

bool PhysicsWorld::frozen(BodyId id) const {
    return impl_->body(id).frozen;
}

void PhysicsWorld::set_contact_events(BodyId id, bool listed) {
    BodyRecord& record = impl_->body(id);
    if (record.contact_events == listed) return;
    record.contact_events = listed;
    listed ? ++impl_->event_bodies : --impl_->event_bodies;
    impl_->events_asleep = false;
}

}  // namespace plumbline::physics
