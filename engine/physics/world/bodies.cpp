// Bodies: made, moved, pushed, frozen and taken out.
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

Vec3 arm_of_origin(const BodyRecord& record) {
    return record.motion->at.rotation * invert(record.traits.body_from_mass).position;
}

void set_velocity_of_origin(BodyRecord& record, const Vec3& velocity, const Vec3& spin) {
    Vec3 v = velocity;
    if (!record.traits.mass_frame_is_body) v -= glm::cross(spin, arm_of_origin(record));
    record.motion->velocity_mps = v * record.traits.linear_factor;
    record.motion->spin_radps = spin;
    record.motion->ballistic.going = false;
}

MassProperties mass_of(const BodyRecord& record) {
    if (record.kind != BodyKind::Dynamic)
        return {.center_of_mass_m = record.traits.body_from_mass.position};
    return {.mass_kg = static_cast<Real>(record.traits.mass_kg),
            .inertia_kgm2 = Vec3{record.traits.inertia_kgm2},
            .center_of_mass_m = record.traits.body_from_mass.position};
}

}  // namespace

Transform world_from_mass(const BodyRecord& record, const Pose& world_from_body) {
    return transform_of(record.traits.mass_frame_is_body
                            ? world_from_body
                            : compose(world_from_body, record.traits.body_from_mass));
}

void WorldState::place(BodyRecord& record, const Transform& to) {
    record.motion->at = to;
    write_rigid_motion(record);
    record.before.at = to;
    record.drive.target = to;
    record.motion->ballistic.going = false;
    if (record.in_world) engine->refresh_box(record);
}

void WorldState::enter_world(BodyRecord& record) {
    record.in_world = true;
    engine->add(record);
    if (small)
        small->bodies.enter(record);
    else
        set_activity(record, pushable(record) ? Activity::Awake : Activity::Asleep);
}

void WorldState::leave_world(BodyRecord& record) {
    if (!record.in_world) return;
    wake_neighbours(record);
    if (small) small->bodies.leave(record);
    engine->remove(record);
    record.in_world = false;
}

BodyId PhysicsWorld::create_body(const BodyDef& def) {
    PL_ASSERT(def.kind != BodyKind::Dynamic || def.mass_kg > 0, "a dynamic body that has mass");
    const BodyId id = state_->bodies.insert(std::make_unique<BodyRecord>());
    BodyRecord& record = state_->body(id);
    record.id = id;
    record.motion = &state_->motions.make(id.index);
    record.kind = def.kind;
    record.user = def.user;
    record.filter = def.filter;
    record.sweep.ccd = def.ccd;
    record.can_sleep = def.can_sleep;
    record.traits.linear_damping_per_s = static_cast<double>(def.linear_damping_per_s);
    record.traits.angular_damping_per_s = static_cast<double>(def.angular_damping_per_s);
    record.traits.linear_factor = def.linear_factor;
    record.traits.gravity_factor = def.linear_factor * def.gravity_factor;
    if (def.kind != BodyKind::Dynamic) {
        record.traits.surface_velocity_mps = def.surface_velocity_mps;
        record.traits.surface_spin_radps = def.surface_spin_radps;
    }
    give_rigid_body(record, def, state_->shapes.get(def.shape));
    suit_to_world(state_->def, record);

    const bool sound = is_finite(def.world_from_body) && is_finite(def.velocity_mps) &&
                       is_finite(def.angular_velocity_radps);
    if (is_finite(def.world_from_body)) {
        state_->place(record, world_from_mass(record, def.world_from_body));
    }
    state_->enter_world(record);
    if (sound && def.kind != BodyKind::Static) {
        set_velocity_of_origin(record, def.velocity_mps, def.angular_velocity_radps);
        if (state_->small && def.kind == BodyKind::Kinematic)
            state_->small->bodies.wake_kinematic(record);
    }
    if (!sound) {
        record.invalid = true;
        state_->invalid.push_back(id);
    }
    if (def.contact_events) set_contact_events(id, true);
    return id;
}

bool PhysicsWorld::reserve_body(BodyId id) {
    return state_->bodies.reserve(id);
}

void PhysicsWorld::destroy_body(BodyId id) {
    if (!state_->bodies.contains(id)) return;
    BodyRecord& record = state_->body(id);
    set_contact_events(id, false);
    while (!record.joints.empty()) state_->remove_joint(record.joints.front());
    state_->leave_world(record);
    state_->bodies.erase(id);
}

bool PhysicsWorld::contains(BodyId id) const {
    return state_->bodies.contains(id);
}

BodyState PhysicsWorld::state(BodyId id) const {
    const BodyRecord& record = state_->body(id);
    BodyState state{.world_from_body = pose_of(record.motion->at),
                    .velocity_mps = record.motion->velocity_mps,
                    .angular_velocity_radps = record.motion->spin_radps,
                    .awake = record.in_world && is_active(record),
                    .frozen = record.frozen,
                    .kind = record.kind,
                    .filter = record.filter,
                    .user = record.user,
                    .mass = mass_of(record)};
    if (!record.traits.mass_frame_is_body) {
        state.world_from_body =
            compose(state.world_from_body, invert(record.traits.body_from_mass));
        state.velocity_mps += glm::cross(state.angular_velocity_radps, arm_of_origin(record));
    }
    return state;
}

void PhysicsWorld::set_pose(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = state_->body(id);
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return state_->mark_invalid(record);
    state_->wake_neighbours(record);
    state_->place(record, world_from_mass(record, world_from_body));
    record.drive.has_target = false;
    if (state_->small) state_->small->bodies.wake_overlapping(record);
    wake(id);
}

void PhysicsWorld::move_kinematic(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = state_->body(id);
    PL_ASSERT(record.kind == BodyKind::Kinematic, "a kinematic body");
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return state_->mark_invalid(record);
    record.drive.target = world_from_mass(record, world_from_body);
    record.drive.has_target = true;
    if (state_->small) state_->small->bodies.wake_kinematic(record);
}

void PhysicsWorld::set_velocity(BodyId id,
                                const Vec3& velocity_mps,
                                const Vec3& angular_velocity_radps) {
    BodyRecord& record = state_->body(id);
    if (!is_finite(velocity_mps) || !is_finite(angular_velocity_radps))
        return state_->mark_invalid(record);
    if (record.kind == BodyKind::Static || !record.in_world || record.frozen) return;
    set_velocity_of_origin(record, velocity_mps, angular_velocity_radps);
    record.drive.driven = false;
    if (state_->small && record.kind == BodyKind::Kinematic)
        state_->small->bodies.wake_kinematic(record);
    wake(id);
}

void PhysicsWorld::apply_force(BodyId id,
                               const Vec3& force_N,
                               const std::optional<Vec3>& point_world) {
    BodyRecord& record = state_->body(id);
    Vec3 torque_Nm{0, 0, 0};
    if (point_world) torque_Nm = glm::cross(*point_world - record.motion->at.position_m, force_N);
    if (!is_finite(force_N) || !is_finite(torque_Nm)) return state_->mark_invalid(record);
    if (!pushable(record)) return;
    add_force(record, force_N);
    if (point_world) record.applied.torque_Nm += torque_Nm;
    record.applied.by_caller = true;
    wake(id);
}

void PhysicsWorld::apply_torque(BodyId id, const Vec3& torque_Nm) {
    BodyRecord& record = state_->body(id);
    if (!is_finite(torque_Nm)) return state_->mark_invalid(record);
    if (!pushable(record)) return;
    record.applied.torque_Nm += torque_Nm;
    record.applied.by_caller = true;
    wake(id);
}

void PhysicsWorld::apply_impulse(BodyId id,
                                 const Vec3& impulse_Ns,
                                 const std::optional<Vec3>& point_world) {
    BodyRecord& record = state_->body(id);
    BodyMotion& motion = *record.motion;
    const Vec3 point = point_world.value_or(motion.at.position_m);
    if (!is_finite(impulse_Ns) || !is_finite(point)) return state_->mark_invalid(record);
    if (!pushable(record)) return;
    motion.velocity_mps += impulse_Ns * record.traits.linear_factor * motion.inverse_mass;
    // What holds a body along an axis acts at its centre of mass: the whole impulse turns it.
    motion.spin_radps += angular_gain(motion, glm::cross(point - motion.at.position_m, impulse_Ns));
    motion.ballistic.going = false;
    wake(id);
}

void PhysicsWorld::set_frozen(BodyId id, bool frozen) {
    BodyRecord& record = state_->body(id);
    if (record.kind != BodyKind::Dynamic || record.frozen == frozen || !record.in_world) return;
    state_->leave_world(record);
    record.frozen = frozen;
    record.motion->ballistic.going = false;
    set_rigid_mass(record, frozen);
    clear_forces(record);
    record.motion->velocity_mps = {0, 0, 0};
    record.motion->spin_radps = {0, 0, 0};
    state_->enter_world(record);
}

void PhysicsWorld::set_contact_events(BodyId id, bool listed) {
    BodyRecord& record = state_->body(id);
    if (record.contact_events == listed) return;
    record.contact_events = listed;
    listed ? ++state_->event_bodies : --state_->event_bodies;
    state_->events_asleep = false;
}

}  // namespace plumbline::physics
