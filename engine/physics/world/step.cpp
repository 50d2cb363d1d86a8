// One fixed step: who is taken out, what is stepped, which events are left.
#include "engine/core/time/stopwatch.h"
#include "engine/core/time/trace_events.h"
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/dynamics/field_forces.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace plumbline::physics {
namespace {

/// Keeps a caller's force from driving the body past the speed limit within this step: Bullet
/// would turn 1e9 N on a pebble into infinities that reach its neighbours.
void limit_force(BodyRecord& record, Real step_s) {
    const Real gain = record.motion->inverse_mass * step_s;
    const Vec3 force = limited(record.applied.force_N, kMaxSpeed_mps / gain);
    // The smallest moment gives the most spin for a torque.
    const Vec3 inverse_moments = record.motion->inverse_moments;
    const Real turn_gain =
        std::max({inverse_moments.x, inverse_moments.y, inverse_moments.z}) * step_s;
    const Vec3 torque = limited(record.applied.torque_Nm, kMaxSpin_radps / turn_gain);
    record.applied.force_N = force;
    record.applied.torque_Nm = torque;
}

bool is_sound(const BodyRecord& record) {
    const Vec3 x = record.motion->at.position_m;
    const Vec3 v = record.motion->velocity_mps;
    const Vec3 w = record.motion->spin_radps;
    // One comparison catches NaN, infinity and distance: a NaN makes it false.
    return glm::dot(x, x) <= kMaxDistance_m * kMaxDistance_m && std::isfinite(glm::dot(v, v)) &&
           std::isfinite(glm::dot(w, w));
}

void prepare_kinematic(BodyRecord& record, Real step_s) {
    if (record.drive.has_target) {
        const SteadyMotion motion = motion_between(record.motion->at, record.drive.target, step_s);
        record.motion->velocity_mps = motion.velocity_mps;
        record.motion->spin_radps = motion.spin_radps;
    } else if (record.drive.driven) {
        record.motion->velocity_mps = {0, 0, 0};
        record.motion->spin_radps = {0, 0, 0};
    }
    record.drive.driven = record.drive.has_target;
    // An awake kinematic body keeps all it touches awake.
    set_activity(record, stands_still(record) ? Activity::Asleep : Activity::Awake);
}

/// Whether the speed limit cut its motion.
bool prepare_dynamic(BodyRecord& record, Real step_s) {
    add_force(record, record.traits.weight_N);
    if (record.applied.by_caller) limit_force(record, step_s);
    return limit_speed(record);
}

template <class Fn>
void each_moving(const WorldState& world, Fn&& fn) {
    if (!world.small) {
        for (BodyRecord* record : world.engine->moving()) fn(*record);
        return;
    }
    for (BodyRecord* record : world.small->bodies.dynamic()) fn(*record);
    for (BodyRecord* record : world.small->bodies.kinematic()) fn(*record);
}

/// Gravity, the callers' forces and the way of kinematic bodies, before the first substep.
void prepare_bodies(WorldState& world) {
    const auto step_s = static_cast<Real>(world.def.step_s);
    each_moving(world, [&world, step_s](BodyRecord& record) {
        if (record.kind == BodyKind::Kinematic)
            prepare_kinematic(record, step_s);
        else if (is_active(record) && prepare_dynamic(record, step_s))
            ++world.report.cost.interventions.limited_bodies;
    });
}

/// Clears forces and takes out what the step made non-finite.
void settle_bodies(WorldState& world) {
    std::vector<BodyRecord*> broken;
    each_moving(world, [&broken](BodyRecord& record) {
        clear_forces(record);
        record.drive.has_target = false;
        if (!is_sound(record)) broken.push_back(&record);
    });
    for (BodyRecord* record : broken) {
        const Transform last = record->before.at;
        world.isolate(*record);
        record->motion->at = last;
        write_rigid_pose(*record);
    }
}

/// After the last substep.
void settle(WorldState& world) {
    settle_bodies(world);
    settle_joints(world);
}

/// What fields push by in the whole step, as forces: Bullet's sub-steps ask nobody.
void push_by_fields(WorldState& world, std::span<ForceField* const> fields) {
    const double step_s = world.def.step_s;
    std::vector<BodyRecord*> records;
    std::vector<BodyInField> states;
    std::vector<std::uint32_t> masks;
    for (BodyRecord* record : world.engine->moving()) {
        if (!pushable(*record) || !is_active(*record)) continue;
        const std::uint32_t mask = field_mask(fields, record->id);
        if (mask == 0) continue;
        const BodyMotion& motion = *record->motion;
        const Vec3d half_m = Vec3d(motion.velocity_mps) * (step_s / 2);
        records.push_back(record);
        masks.push_back(mask);
        states.push_back({.id = record->id,
                          .center_m = Vec3d(motion.at.position_m) + half_m,
                          .world_from_mass = double_quat_of(motion.at.rotation),
                          .velocity_mps = Vec3d(motion.velocity_mps),
                          .spin_radps = Vec3d(motion.spin_radps),
                          .mass_kg = record->traits.mass_kg,
                          .inertia_kgm2 = record->traits.inertia_kgm2});
    }
    std::vector<BodyInField*> bodies;
    for (BodyInField& state : states) bodies.push_back(&state);
    act_on_all(fields, bodies, masks, {step_s / 2, step_s});
    for (std::size_t i = 0; i < records.size(); ++i) {
        add_force(*records[i], Vec3(states[i].impulse_Ns / step_s));
        records[i]->applied.torque_Nm += Vec3(states[i].angular_impulse_Nms / step_s);
        records[i]->applied.by_caller = true;
    }
}

void advance_bullet(WorldState& world, std::span<ForceField* const> fields, bool want_contacts) {
    BulletEngine& engine = *world.engine;
    std::function<void()> after_solve;
    if (want_contacts) after_solve = [&world] { gather_events(world, false, world.gathered); };
    engine.list_moving();
    if (!fields.empty()) push_by_fields(world, fields);
    prepare_bodies(world);
    prepare_joints(world);
    engine.begin_step(world.features, std::move(after_solve));
    const double substep_s = world.def.step_s / world.def.substeps;
    for (int i = 0; i < world.def.substeps; ++i) {
        engine.advance(static_cast<Real>(substep_s), i + 1 == world.def.substeps);
        gather_joint_loads(world.joints, substep_s);
    }
    settle(world);
}

void advance_small(WorldState& world, std::span<ForceField* const> fields, bool want_contacts) {
    SmallStepWorld& small = *world.small;
    small.begin_step();
    world.slept_through = small.bodies.idle();
    if (world.slept_through) return;
    prepare_bodies(world);
    prepare_joints(world);
    small.step(world.features, fields, want_contacts);
    settle(world);
}

/// Phases are clocked on the wall, which is cheaper to read: what other programs took of it in between
/// is not this step's, and what helpers did is.
void count_own_share(StepReport& report) {
    StepCost& cost = report.cost;
    FeatureUse& use = report.use;
    if (cost.wall_ms <= cost.total_ms && cost.helpers_ms == 0) return;
    const double share = cost.total_ms / cost.wall_ms;
    for (double* phase_ms : {&cost.broad_ms,
                             &cost.narrow_ms,
                             &cost.solve_ms,
                             &cost.integrate_ms,
                             &use.sweep_ms,
                             &use.gyro_ms,
                             &use.events_ms})
        *phase_ms *= share;
}

}  // namespace

void WorldState::mark_invalid(BodyRecord& record) {
    // What does not move by itself stays sound: a call with such a number is ignored.
    if (record.invalid || !record.in_world || record.kind != BodyKind::Dynamic) return;
    record.invalid = true;
    invalid.push_back(record.id);
}

void WorldState::isolate(BodyRecord& record) {
    if (!record.in_world) return;
    while (!record.joints.empty()) remove_joint(record.joints.front());
    leave_world(record);
    clear_forces(record);
    record.motion->velocity_mps = {0, 0, 0};
    record.motion->spin_radps = {0, 0, 0};
    record.motion->ballistic = {};  // may be no numbers, and nobody asks any more
    record.small.rest = {};
    report.isolated.push_back(record.id);
}

void PhysicsWorld::step(std::span<ForceField* const> fields) {
    WorldState& world = *state_;
    const TraceSpan span("step");
    const CpuTimer own_time;
    LapTimer wall;
    wall.start();
    for (const BodyId id : world.invalid) {
        if (world.bodies.contains(id)) world.isolate(world.body(id));
    }
    world.invalid.clear();
    unload_broken_joints(world);

    StepReport& report = world.report;
    report.cost = {};
    report.use = {};
    report.islands.clear();
    world.gathered.clear();
    const bool want_contacts = world.features.contact_events && world.event_bodies > 0;
    if (world.small)
        advance_small(world, fields, want_contacts);
    else
        advance_bullet(world, fields, want_contacts);
    const bool nothing_changed = world.slept_through && world.events_asleep;
    if (!want_contacts) {
        report.contacts.clear();
    } else if (!nothing_changed) {
        world.events_asleep = world.slept_through;
        report.contacts =
            finished_events(world, std::move(world.gathered), std::move(report.contacts));
    }
    report.use.events = static_cast<std::uint32_t>(report.contacts.size());
    report.cost.wall_ms = wall.lap_ms();
    report.cost.total_ms = own_time.ms() + report.cost.helpers_ms;
    count_own_share(report);
}

}  // namespace plumbline::physics
