#include "engine/physics/world/small_step_world.h"

#include "engine/physics/bullet/body.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/body_scope.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
SmallStepWorld::SmallStepWorld(const SmallStepParts& parts)
    : parts_(parts), sweep_(parts.joints), collider_(parts.engine) {
    take_rate();
}

void SmallStepWorld::take_rate() {
    gravity_mps2_ = static_cast<double>(glm::length(parts_.def.gravity_mps2));
    step_s_ = static_cast<Real>(parts_.def.step_s);
    // Boxes reach as far as a step takes a body.
    for (const auto* list : {&awake_, &fresh_}) {
        for (BodyRecord* record : *list) record->small.box_stale = true;
    }
    const auto fall_m = static_cast<Real>(gravity_mps2_) * step_s_ * step_s_;
    collider_.begin_step({.step_s = step_s_, .fall_m = fall_m});
}

// --- bookkeeping

void SmallStepWorld::enter(BodyRecord& record) {
    record.small.awake = false;
    record.small.sleeping_island = 0;
    record.sweep.group = 0;
    if (pushable(record)) {
        wake_one(record);
        return;
    }
    set_activity(record, Activity::Asleep);
    wake_overlapping(record);
}

void SmallStepWorld::leave(BodyRecord& record) {
    if (record.small.sleeping_island != 0) wake(record);
    record.small.awake = false;
    std::erase(awake_, &record);
    std::erase(fresh_, &record);
    std::erase(kinematic_, &record);
}

void SmallStepWorld::wake(BodyRecord& record) {
    if (!pushable(record)) return;
    record.small.box_stale = true;
    break_rest(record);
    if (record.small.awake) return;
    if (record.small.sleeping_island == 0) return wake_one(record);
    for (BodyRecord* sleeper : sleeping_islands_.end(record.small.sleeping_island))
        wake_one(*sleeper);
}

void SmallStepWorld::wake_one(BodyRecord& record) {
    record.small.awake = true;
    record.small.sleeping_island = 0;
    record.small.box_stale = true;
    break_rest(record);
    note_before(record);
    set_activity(record, Activity::Awake);
    fresh_.push_back(&record);
}

void SmallStepWorld::wake_touching(const BodyRecord& record) {
    for (const PairLink& link : record.small.pairs) {
        if (link.pair->touches) wake(partner(*link.pair, record));
    }
}

void SmallStepWorld::wake_overlapping(const BodyRecord& record) {
    for (const PairLink& link : record.small.pairs) {
        BodyRecord& other = partner(*link.pair, record);
        if (sleeps(other) && boxes_overlap(*link.pair)) wake(other);
    }
}

void SmallStepWorld::wake_kinematic(BodyRecord& record) {
    if (record.small.awake) return;
    record.small.awake = true;
    kinematic_.insert(std::upper_bound(kinematic_.begin(), kinematic_.end(), &record, by_id),
                      &record);
}

void SmallStepWorld::serialize(Archive& archive, const BodyScope& scope) {
    for (std::vector<BodyRecord*>* list : {&awake_, &fresh_, &kinematic_})
        physics::serialize(archive, *list, scope);
    sleeping_islands_.serialize(archive, scope);
    solver_.serialize(archive);
}

// --- the step

void SmallStepWorld::begin_step() {
    admit_fresh();
    touching_.clear();
    reports.clear();
}

void SmallStepWorld::admit_fresh() {
    if (fresh_.empty()) return;
    std::sort(fresh_.begin(), fresh_.end(), by_id);
    const auto old_count = static_cast<std::ptrdiff_t>(awake_.size());
    awake_.insert(awake_.end(), fresh_.begin(), fresh_.end());
    std::inplace_merge(awake_.begin(), awake_.begin() + old_count, awake_.end(), by_id);
    fresh_.clear();
}

void SmallStepWorld::step(const WorldFeatures& features, bool want_contacts) {
    features_ = features;
    laps_.start();
    drop_still_kinematic_bodies();
    wake_joined();
    admit_fresh();
    if (idle()) return;
    remember();
    cost.integrate_ms += laps_.lap_ms();

    refresh_stale_boxes();
    parts_.engine.find_pairs();
    cost.broad_ms += laps_.lap_ms();
    collide_pairs();
    cost.narrow_ms += laps_.lap_ms();

    list_joints();
    builder_.build(awake_, touching_, joined_);
    solve_islands();
    cost.solve_ms += laps_.lap_ms();
    if (want_contacts) {
        after_solve();
        use.events_ms += laps_.lap_ms();
    }

    move_free_bodies();
    move_kinematic_bodies();
    show_poses();
    stop_swept_bodies();
    put_to_sleep();
    cost.integrate_ms += laps_.lap_ms();
    for (BodyRecord* record : awake_) refresh_box(*record);
    for (BodyRecord* record : kinematic_) refresh_box(*record);
    cost.broad_ms += laps_.lap_ms();
}

void SmallStepWorld::drop_still_kinematic_bodies() {
    std::erase_if(kinematic_, [](BodyRecord* record) {
        record->small.awake = is_active(*record);
        if (!record->small.awake) note_before(*record);
        return !record->small.awake;
    });
}

/// A joint holds what sleeps and what does not only if it is new or its body was put back.
void SmallStepWorld::wake_joined() {
    for (BodyRecord* record : awake_) {
        for (const JointId id : record->joints) {
            const JointRecord& joint = *parts_.joints.get(id);
            if (joint.state.broken || joint.b == nullptr) continue;
            BodyRecord& other = joint.a == record ? *joint.b : *joint.a;
            if (sleeps(other)) wake(other);
        }
    }
}

void SmallStepWorld::remember() {
    for (BodyRecord* record : awake_) note_before(*record);
    for (BodyRecord* record : kinematic_) note_before(*record);
}

// --- boxes

void SmallStepWorld::refresh_stale_boxes() {
    for (BodyRecord* record : awake_) {
        if (record->small.box_stale) refresh_box(*record);
    }
    for (BodyRecord* record : kinematic_) refresh_box(*record);
}

/// A box round the body now and wherever it can be at the end of a step that nothing disturbs.
void SmallStepWorld::refresh_box(BodyRecord& record) {
    record.small.box_stale = false;
    auto [low, high] = box_of(record);
    Vec3 way = record.motion->velocity_mps * step_s_;
    if (record.applied.by_caller)
        way += record.applied.force_N * (record.motion->inverse_mass * step_s_ * step_s_);
    const Real turn_rad = glm::length(record.motion->spin_radps) * step_s_;
    const auto fall_m = static_cast<Real>(gravity_mps2_) * step_s_ * step_s_;
    const Real rim = record.traits.contact_margin_m + fall_m +
                     std::min(turn_rad, Real{2}) * record.traits.radius_m;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] += std::min(way[axis], Real{0}) - rim;
        high[axis] += std::max(way[axis], Real{0}) + rim;
    }
    // As Bullet does: what is out of all bounds, or not a number, is taken out after the step.
    const Vec3 size = high - low;
    if (!(glm::dot(size, size) < Real(1e12))) return;
    parts_.engine.set_box(record, {low, high});
}

// --- motion

void SmallStepWorld::solve_islands() {
    const IslandStep step{.step_s = parts_.def.step_s,
                          .gravity_mps2 = Vec3d{parts_.def.gravity_mps2},
                          .substeps_least = parts_.def.substeps,
                          .substeps_most = std::max(parts_.def.substeps, parts_.def.substeps_max),
                          .iterations = parts_.def.iterations,
                          .joints = parts_.def.joints,
                          .features = features_,
                          .cost = &cost,
                          .use = &use};
    solver_.begin_step();
    for (Island& island : builder_.islands()) {
        reports.push_back(solver_.solve(island, step));
        if (roll_back_if_invalid(island)) ++cost.interventions.restored_islands;
    }
}

void SmallStepWorld::move_free_bodies() {
    const Vec3d gravity{parts_.def.gravity_mps2};
    turning_.clear();
    for (BodyRecord* record : builder_.free_bodies()) {
        if (record->traits.angular_damping_factor != 1)
            record->motion->spin_radps *= record->traits.angular_damping_factor;
        if (record->applied.torque_Nm != Vec3{0, 0, 0}) {
            const Vec3 gain = angular_gain(*record->motion, record->applied.torque_Nm);
            record->motion->spin_radps += gain * step_s_;
        }
        integrate_ballistic(*record, gravity, features_, parts_.def.step_s);
        if (feels_gyro(*record, features_)) turning_.push_back(record);
    }
    if (turning_.empty()) return;
    cost.integrate_ms += laps_.lap_ms();
    for (BodyRecord* record : turning_) turn_freely(*record, parts_.def.step_s);
    use.gyro_bodies += static_cast<std::uint32_t>(turning_.size());
    use.gyro_ms += laps_.lap_ms();
}

void SmallStepWorld::move_kinematic_bodies() {
    for (BodyRecord* record : kinematic_)
        integrate_kinematic(*record, record->drive.has_target, step_s_);
}

/// Bullet's copies, for casts and for the next step's contacts.
void SmallStepWorld::show_poses() {
    for (const BodyRecord* record : awake_) write_rigid_pose(*record);
    for (const BodyRecord* record : kinematic_) write_rigid_pose(*record);
}

void SmallStepWorld::stop_swept_bodies() {
    if (!features_.continuous_collision) return;
    sweep_.begin_step();
    std::uint32_t swept = 0;
    for (BodyRecord* record : awake_) {
        if (!moves_past_itself(*record)) continue;
        if (swept++ == 0) cost.integrate_ms += laps_.lap_ms();
        sweep_.stop_at_hit(parts_.engine.world(), *record, step_s_);
    }
    if (swept == 0) return;
    use.swept_bodies += swept;
    use.sweep_ms += laps_.lap_ms();
}

// --- sleep

void SmallStepWorld::put_to_sleep() {
    for (BodyRecord* record : builder_.free_bodies()) break_rest(*record);
    bool slept = false;
    for (const Island& island : builder_.islands()) {
        for (BodyRecord* record : island.bodies) {
            watch_rest(*record, gravity_mps2_, parts_.def.step_s);
        }
        if (!is_at_rest(island)) continue;
        lay_down(island);
        slept = true;
    }
    if (slept) std::erase_if(awake_, [](const BodyRecord* record) { return !record->small.awake; });
}

/// Contact points keep their impulses: the pile wakes as it fell asleep.
void SmallStepWorld::lay_down(const Island& island) {
    const std::uint32_t sleeping_island = sleeping_islands_.add(island.bodies);
    for (BodyRecord* record : island.bodies) {
        stand_still(*record);
        clear_forces(*record);
        note_before(*record);
        record->small.awake = false;
        record->small.sleeping_island = sleeping_island;
        set_activity(*record, Activity::Asleep);
        refresh_box(*record);
    }
}

}  // namespace plumbline::physics
