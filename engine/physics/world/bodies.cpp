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

BodyId WorldBodies::create_body(const BodyDef& def) {
    PL_ASSERT(def.kind != BodyKind::Dynamic || def.mass_kg > 0, "a dynamic body that has mass");
    const BodyId id = world_.bodies.insert(std::make_unique<BodyRecord>());
    BodyRecord& record = world_.body(id);
    record.id = id;
    record.motion = &world_.motions.make(id.index);
    record.kind = def.kind;
    record.user = def.user;
    record.filter = def.filter;
    record.sweep.ccd = def.ccd;
    record.can_sleep = def.can_sleep;
    record.traits.linear_damping_per_s = static_cast<double>(def.linear_damping_per_s);
    record.traits.angular_damping_per_s = static_cast<double>(def.angular_damping_per_s);
    record.traits.linear_factor = def.linear_factor;
    give_rigid_body(record, def, world_.shapes.get(def.shape));
    suit_to_world(world_.def, record);

    const bool sound = is_finite(def.world_from_body) && is_finite(def.velocity_mps) &&
                       is_finite(def.angular_velocity_radps);
    if (is_finite(def.world_from_body)) {
        world_.place(record, world_from_mass(record, def.world_from_body));
    }
    world_.enter_world(record);
    if (sound && def.kind != BodyKind::Static) {
        set_velocity_of_origin(record, def.velocity_mps, def.angular_velocity_radps);
        if (world_.small && def.kind == BodyKind::Kinematic)
            world_.small->bodies.wake_kinematic(record);
    }
    if (!sound) {
        record.poisoned = true;
        world_.poisoned.push_back(id);
    }
    if (def.contact_events) set_contact_events(id, true);
    return id;
}

bool WorldBodies::reserve_body(BodyId id) {
    return world_.bodies.reserve(id);
}

void WorldBodies::destroy_body(BodyId id) {
    if (!world_.bodies.contains(id)) return;
    BodyRecord& record = world_.body(id);
    set_contact_events(id, false);
    world_.remove_joints_of(record);
    world_.leave_world(record);
    world_.bodies.erase(id);
}

bool WorldBodies::contains(BodyId id) const {
    return world_.bodies.contains(id);
}

BodyState WorldBodies::state(BodyId id) const {
    const BodyRecord& record = world_.body(id);
    BodyState state{.world_from_body = pose_of(record.motion->at),
                    .velocity_mps = record.motion->velocity_mps,
                    .angular_velocity_radps = record.motion->spin_radps,
                    .awake = record.in_world && is_active(record)};
    if (!record.traits.mass_frame_is_body) {
        state.world_from_body =
            compose(state.world_from_body, invert(record.traits.body_from_mass));
        state.velocity_mps += glm::cross(state.angular_velocity_radps, arm_of_origin(record));
    }
    return state;
}

BodyKind WorldBodies::kind(BodyId id) const {
    return world_.body(id).kind;
}

MassProperties WorldBodies::mass_properties(BodyId id) const {
    const BodyRecord& record = world_.body(id);
    if (record.kind != BodyKind::Dynamic) return {};
    return {.mass_kg = static_cast<Real>(record.traits.mass_kg),
            .inertia_kgm2 = Vec3{record.traits.inertia_kgm2},
            .center_of_mass_m = record.traits.body_from_mass.position};
}

std::uint64_t WorldBodies::user(BodyId id) const {
    return world_.body(id).user;
}

bool WorldBodies::groups_touch(BodyId a, BodyId b) const {
    return may_touch(world_.body(a).filter, world_.body(b).filter);
}

void WorldBodies::bounds(BodyId id, Vec3& min_world, Vec3& max_world) const {
    const Box box = box_of(world_.body(id));
    min_world = box.low;
    max_world = box.high;
}

void WorldBodies::set_pose(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = world_.body(id);
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return world_.poison(record);
    world_.wake_neighbours(record);
    world_.place(record, world_from_mass(record, world_from_body));
    record.drive.has_target = false;
    if (world_.small) world_.small->bodies.wake_overlapping(record);
    wake(id);
}

void WorldBodies::move_kinematic(BodyId id, const Pose& world_from_body) {
    BodyRecord& record = world_.body(id);
    PL_ASSERT(record.kind == BodyKind::Kinematic, "a kinematic body");
    if (!record.in_world) return;
    if (!is_finite(world_from_body)) return world_.poison(record);
    record.drive.target = world_from_mass(record, world_from_body);
    record.drive.has_target = true;
    if (world_.small) world_.small->bodies.wake_kinematic(record);
}

void WorldBodies::set_velocity(BodyId id,
                               const Vec3& velocity_mps,
                               const Vec3& angular_velocity_radps) {
    BodyRecord& record = world_.body(id);
    if (!is_finite(velocity_mps) || !is_finite(angular_velocity_radps))
        return world_.poison(record);
    if (record.kind == BodyKind::Static || !record.in_world || record.frozen) return;
    set_velocity_of_origin(record, velocity_mps, angular_velocity_radps);
    record.drive.driven = false;
    if (world_.small && record.kind == BodyKind::Kinematic)
        world_.small->bodies.wake_kinematic(record);
    wake(id);
}

void WorldBodies::apply_force(BodyId id, const Vec3& force_N) {
    BodyRecord& record = world_.body(id);
    if (!is_finite(force_N)) return world_.poison(record);
    if (!pushable(record)) return;
    add_force(record, force_N);
    record.applied.by_caller = true;
    wake(id);
}

void WorldBodies::apply_force_at(BodyId id, const Vec3& force_N, const Vec3& point_world) {
    BodyRecord& record = world_.body(id);
    const Vec3 arm = point_world - record.motion->at.position_m;
    apply_force(id, force_N);
    apply_torque(id, glm::cross(arm, force_N));
}

void WorldBodies::apply_torque(BodyId id, const Vec3& torque_Nm) {
    BodyRecord& record = world_.body(id);
    if (!is_finite(torque_Nm)) return world_.poison(record);
    if (!pushable(record)) return;
    record.applied.torque_Nm += torque_Nm;
    record.applied.by_caller = true;
    wake(id);
}

void WorldBodies::apply_impulse(BodyId id, const Vec3& impulse_Ns) {
    apply_impulse_at(id, impulse_Ns, world_.body(id).motion->at.position_m);
}

void WorldBodies::apply_impulse_at(BodyId id, const Vec3& impulse_Ns, const Vec3& point_world) {
    BodyRecord& record = world_.body(id);
    if (!is_finite(impulse_Ns) || !is_finite(point_world)) return world_.poison(record);
    if (!pushable(record)) return;
    BodyMotion& motion = *record.motion;
    const Vec3 arm = point_world - motion.at.position_m;
    motion.velocity_mps += impulse_Ns * record.traits.linear_factor * motion.inverse_mass;
    // What holds a body along an axis acts at its centre of mass: the whole impulse turns it.
    motion.spin_radps += angular_gain(motion, glm::cross(arm, impulse_Ns));
    record.motion->ballistic.going = false;
    wake(id);
}

void WorldBodies::set_frozen(BodyId id, bool frozen) {
    BodyRecord& record = world_.body(id);
    if (record.kind != BodyKind::Dynamic || record.frozen == frozen || !record.in_world) return;
    world_.leave_world(record);
    record.frozen = frozen;
    record.motion->ballistic.going = false;
    set_rigid_mass(record, frozen);
    clear_forces(record);
    record.motion->velocity_mps = {0, 0, 0};
    record.motion->spin_radps = {0, 0, 0};
    world_.enter_world(record);
}

bool WorldBodies::frozen(BodyId id) const {
    return world_.body(id).frozen;
}

void WorldBodies::set_contact_events(BodyId id, bool listed) {
    BodyRecord& record = world_.body(id);
    if (record.contact_events == listed) return;
    record.contact_events = listed;
    listed ? ++world_.event_bodies : --world_.event_bodies;
    world_.events_asleep = false;
}

}  // namespace plumbline::physics
