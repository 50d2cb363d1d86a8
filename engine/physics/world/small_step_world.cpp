#include "engine/physics/world/small_step_world.h"

#include "engine/core/time/trace_events.h"
#include "engine/physics/bullet/body.h"
#include "engine/physics/dynamics/body_motion.h"
#include "engine/physics/dynamics/body_sweep.h"
#include "engine/physics/dynamics/field_forces.h"
#include "engine/physics/world/body_record.h"
#include "engine/physics/world/body_scope.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Fewer are moved before helpers are awake.
constexpr std::size_t kManyBodies = 64;

/// Joints that hold the bodies and are not broken, by their ids.
void list_joints(std::span<BodyRecord* const> bodies,
                 const JointTable& joints,
                 std::vector<JointRecord*>& list) {
    list.clear();
    for (const BodyRecord* record : bodies) {
        for (const JointId id : record->joints) {
            JointRecord& joint = *joints.get(id);
            const BodyRecord* first = joint.a;
            if (!pushable(*first)) first = joint.b;
            if (first == record && !joint.state.broken) list.push_back(&joint);
        }
    }
    std::sort(list.begin(), list.end(), [](const JointRecord* a, const JointRecord* b) {
        return a->id < b->id;
    });
}

}  // namespace

SmallStepWorld::SmallStepWorld(const SmallStepParts& parts)
    : parts_(parts),
      report_(parts.report),
      pairs_(parts.engine),
      sweep_(parts.joints),
      islands_(pairs_) {
    if (parts.def.threads > 1) team_ = std::make_unique<Team>(parts.def.threads);
    take_rate();
}

void SmallStepWorld::take_rate() {
    gravity_mps2_ = static_cast<double>(glm::length(parts_.def.gravity_mps2));
    step_s_ = static_cast<Real>(parts_.def.step_s);
    drop_m_ = static_cast<Real>(gravity_mps2_) * step_s_ * step_s_;
    bodies.make_boxes_stale();  // they reach as far as a step takes a body
    const CollideStep step{.step_s = step_s_, .drop_m = drop_m_, .rules = parts_.def.pair_rules};
    pairs_.set_step(step);
    islands_.set_step(step);
}

void SmallStepWorld::serialize(Archive& archive, const BodyScope& scope) {
    bodies.serialize(archive, scope);
    islands_.serialize(archive);
}

// --- the step

void SmallStepWorld::begin_step() {
    bodies.admit_woken();
    touching_.clear();
}

void SmallStepWorld::step(const WorldFeatures& wanted,
                          std::span<ForceField* const> fields,
                          bool want_contacts) {
    laps_.start();
    bodies.begin_step(parts_.joints);
    if (bodies.idle()) return;
    // A caller's rules are no code of ours.
    if (team_ == nullptr || bodies.dynamic().size() < kManyBodies || parts_.def.pair_rules)
        return move(wanted, fields, want_contacts, nullptr);
    const double before_ms = team_->helpers_cpu_ms();
    {
        const AwakeTeam awake(team_.get());
        move(wanted, fields, want_contacts, team_.get());
    }
    report_.cost.helpers_ms = team_->helpers_cpu_ms() - before_ms;
}

void SmallStepWorld::move(const WorldFeatures& wanted,
                          std::span<ForceField* const> fields,
                          bool want_contacts,
                          Team* team) {
    WorldFeatures features = wanted;
    features.gyroscopic_torque = find_turning(wanted);
    report_.cost.integrate_ms += laps_.lap_ms();

    find_pairs();
    report_.cost.broad_ms += laps_.lap_ms();
    find_points(team);
    report_.cost.narrow_ms += laps_.lap_ms();

    list_islands(features, fields);
    solve_islands(features, fields, pairs_.crowded() ? nullptr : team);
    report_.cost.solve_ms += laps_.lap_ms();
    if (want_contacts) {
        after_solve();
        report_.use.events_ms += laps_.lap_ms();
    }

    move_free_bodies(features);
    for (BodyRecord* record : bodies.kinematic())
        integrate_kinematic(*record, record->drive.has_target, step_s_);
    // Bullet's copies, for casts and for the next step's contacts.
    for (const BodyRecord* record : bodies.dynamic()) write_rigid_pose(*record);
    for (const BodyRecord* record : bodies.kinematic()) write_rigid_pose(*record);
    if (features.continuous_collision) stop_swept_bodies(bodies.dynamic());
    put_to_sleep(builder_.islands());
    report_.cost.integrate_ms += laps_.lap_ms();
    refresh_boxes();
    report_.cost.broad_ms += laps_.lap_ms();
}

void SmallStepWorld::find_pairs() {
    const TraceSpan span("broad phase");
    for (BodyRecord* record : bodies.dynamic()) {
        if (record->small.box_stale) refresh_box(*record);
    }
    for (BodyRecord* record : bodies.kinematic()) refresh_box(*record);
    parts_.engine.find_pairs();
}

void SmallStepWorld::find_points(Team* team) {
    TraceSpan span("narrow phase");
    report_.cost.pairs += pairs_.collide(bodies, touching_, team);
    report_.cost.interventions.left_out_pairs = pairs_.left_out();
    span.note("pairs", report_.cost.pairs);
}

void SmallStepWorld::list_islands(const WorldFeatures& features,
                                  std::span<ForceField* const> fields) {
    const TraceSpan span("list islands");
    ahead_.clear();
    if (features.continuous_collision) look_ahead(features);
    list_joints(bodies.dynamic(), parts_.joints, joined_);
    builder_.build(bodies.dynamic(), touching_, joined_, ahead_, ties_of(fields));
}

/// Whether gyroscopic torque acts in this step.
bool SmallStepWorld::find_turning(const WorldFeatures& features) {
    for (const BodyRecord* record : bodies.dynamic()) {
        if (!feels_gyro(*record, features)) continue;
        if (report_.use.gyro_bodies++ == 0) report_.use.turned = record->id;
    }
    return features.gyro_waits_for_spin ? report_.use.gyro_bodies > 0 : features.gyroscopic_torque;
}

/// A box round the body now and wherever it can be at the end of a step that nothing disturbs.
void SmallStepWorld::refresh_box(BodyRecord& record) {
    record.small.box_stale = false;
    auto [low, high] = box_of(record);
    Vec3 displacement = record.motion->velocity_mps * step_s_;
    if (record.applied.by_caller)
        displacement += record.applied.force_N * (record.motion->inverse_mass * step_s_ * step_s_);
    const Real turn_rad = glm::length(record.motion->spin_radps) * step_s_;
    const Real margin_m = record.traits.contact_margin_m + drop_m_ +
                          std::min(turn_rad, Real{2}) * record.traits.radius_m;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] += std::min(displacement[axis], Real{0}) - margin_m;
        high[axis] += std::max(displacement[axis], Real{0}) + margin_m;
    }
    // As Bullet does: what is out of all bounds, or not a number, is taken out after the step.
    const Vec3 size = high - low;
    if (!(glm::dot(size, size) < Real(1e12))) return;
    parts_.engine.set_box(record, {low, high});
}

void SmallStepWorld::refresh_boxes() {
    const TraceSpan span("boxes");
    for (BodyRecord* record : bodies.dynamic()) refresh_box(*record);
    for (BodyRecord* record : bodies.kinematic()) refresh_box(*record);
}

/// Notes which fields act on whom.
FieldTies SmallStepWorld::ties_of(std::span<ForceField* const> fields) {
    tied_.clear();
    for (BodyRecord* record : bodies.dynamic())
        record->small.fields = field_mask(fields, record->id);
    FieldTies ties;
    for (std::size_t i = 0; i < std::min(fields.size(), kMostFields); ++i) {
        if (fields[i]->carries()) ties.carrying |= 1U << i;
        field_pairs_.clear();
        fields[i]->list_pairs(field_pairs_);
        for (const auto& [a, b] : field_pairs_)
            tied_.emplace_back(parts_.bodies.get(a).get(), parts_.bodies.get(b).get());
    }
    ties.pairs = tied_;
    return ties;
}

void SmallStepWorld::solve_islands(const WorldFeatures& features,
                                   std::span<ForceField* const> fields,
                                   Team* team) {
    const TraceSpan span("solve islands");
    const IslandStep step{.step_s = parts_.def.step_s,
                          .gravity_mps2 = Vec3d{parts_.def.gravity_mps2},
                          .substeps_least = parts_.def.substeps,
                          .substeps_most = std::max(parts_.def.substeps, parts_.def.substeps_max),
                          .iterations = parts_.def.iterations,
                          .joints = parts_.def.joints,
                          .features = features,
                          .team = team,
                          .fields = fields};
    bool found_again = false;
    for (const IslandResult& result : islands_.solve(builder_.islands(), step)) {
        found_again = found_again || result.found_again;
        report_.islands.push_back(result.report);
        StepCost& cost = report_.cost;
        cost.row_solves += result.cost.row_solves;
        cost.contacts += result.cost.contacts;
        cost.belts += result.cost.belts;
        cost.interventions.add(result.cost.interventions);
    }
    if (found_again) pairs_.list_again(bodies, touching_);
}

/// Which bodies may pass something unseen in this step, and what each meets first; that wakes.
void SmallStepWorld::look_ahead(const WorldFeatures& features) {
    const Outlook outlook{0, parts_.def.step_s, features.gyroscopic_torque};
    const TraceSpan span("look ahead");
    Forecast forecast;
    forecast.begin(outlook);
    const auto wake = [&](BodyRecord& record) {
        if (!sleeps(record)) return;
        bodies.wake(record);
        forecast.begin(outlook);
    };
    for (BodyRecord* record : bodies.dynamic()) {
        if (!record->joints.empty() || !outruns_points(*record, outlook)) continue;
        const PredictedImpact impact = forecast.first_impact(*record);
        const bool unknown = impact.other == nullptr && impact.share < 1;
        ahead_.push_back({record, unknown ? record : impact.other});
        if (impact.other == nullptr) continue;
        wake(*impact.other);
        for (BodyRecord* next : reached_after(*record, impact, outlook)) {
            wake(*next);
            ahead_.push_back({record, next, true});
        }
    }
    pairs_.collide_woken(bodies, touching_);
    // Else all that flies side by side would be one island.
    bool dropped = false;
    for (const SweptPath& path : ahead_) {
        if (path.after_impact) continue;  // its body has come before
        dropped = drop_points_ahead(*path.body, outlook) || dropped;
    }
    if (dropped) pairs_.list_again(bodies, touching_);
}

void SmallStepWorld::move_free_bodies(const WorldFeatures& features) {
    const Vec3d gravity{parts_.def.gravity_mps2};
    const TraceSpan span("free bodies");
    turning_.clear();
    for (BodyRecord* record : builder_.free_bodies()) {
        if (record->traits.angular_damping_factor != 1)
            record->motion->spin_radps *= record->traits.angular_damping_factor;
        if (record->applied.torque_Nm != Vec3{0, 0, 0}) {
            const Vec3 gain = angular_gain(*record->motion, record->applied.torque_Nm);
            record->motion->spin_radps += gain * step_s_;
        }
        integrate_ballistic(*record, gravity, features, parts_.def.step_s);
        if (feels_gyro(*record, features)) turning_.push_back(record);
    }
    if (turning_.empty()) return;
    report_.cost.integrate_ms += laps_.lap_ms();
    for (BodyRecord* record : turning_) turn_freely(*record, parts_.def.step_s);
    report_.use.gyro_ms += laps_.lap_ms();
}

void SmallStepWorld::stop_swept_bodies(std::span<BodyRecord* const> moved) {
    sweep_.begin_step();
    std::uint32_t swept = 0;
    for (BodyRecord* record : moved) {
        if (!moves_past_itself(*record)) continue;
        if (swept++ == 0) {
            report_.cost.integrate_ms += laps_.lap_ms();
            report_.use.swept = record->id;
        }
        sweep_.stop_at_hit(parts_.engine.world(), *record, step_s_);
    }
    if (swept == 0) return;
    report_.use.swept_bodies += swept;
    report_.use.sweep_ms += laps_.lap_ms();
}

void SmallStepWorld::put_to_sleep(std::span<const Island> islands) {
    const TraceSpan span("put to sleep");
    for (BodyRecord* record : builder_.free_bodies()) break_rest(*record);
    resting_.clear();
    for (const Island& island : islands) {
        for (BodyRecord* record : island.bodies)
            watch_rest(*record, gravity_mps2_, parts_.def.step_s);
        if (is_at_rest(island)) resting_.push_back(&island);
    }
    bodies.put_to_sleep(resting_);
    for (const Island* island : resting_) {
        for (BodyRecord* record : island->bodies) refresh_box(*record);
    }
}

}  // namespace plumbline::physics
