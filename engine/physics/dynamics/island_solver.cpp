// From our records to the small-step loop, and back.
#include "engine/core/time/trace_events.h"
#include "engine/physics/bullet/body.h"
#include "engine/physics/bullet/rotations.h"
#include "engine/physics/collision/shape/mass.h"
#include "engine/physics/dynamics/body_sweep.h"
#include "engine/physics/dynamics/contact/contact_bridge.h"
#include "engine/physics/dynamics/island.h"
#include "engine/physics/dynamics/island_loop.h"
#include "engine/physics/dynamics/substep_choice.h"
#include "engine/physics/world/body_record.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

namespace plumbline::physics {
namespace {

constexpr Real kContactPush_mps = 3;
constexpr int kHoldSteps = 30;  ///< after the last step that asked for as many sub-steps
constexpr double kFarFewer = 0.75;
/// Of fewer: the need changes a little with the number itself.
constexpr double kSurelyEnough = 0.95;
/// Of the step: what meets within it when an impact is solved takes part in that.
constexpr double kImpactShare = 0.01;

SolverBody posed_body(const BodyRecord& record) {
    SolverBody body;
    body.velocity_mps = record.motion->velocity_mps;
    body.spin_radps = record.motion->spin_radps;
    if (record.motion->ballistic.going) {
        body.start_position_m = record.motion->ballistic.position_m;
        body.start_orientation = record.motion->ballistic.orientation;
        return body;
    }
    const Transform at = record.motion->at;
    body.start_position_m = Vec3d(at.position_m);
    body.start_orientation = double_quat_of(at.rotation);
    return body;
}

Vec3 callers_force_N(const BodyRecord& record) {
    return record.applied.force_N - record.traits.weight_N;
}

SolverBody dynamic_body(const BodyRecord& record, const IslandStep& step, double h) {
    SolverBody body = posed_body(record);
    body.inverse_mass = record.motion->inverse_mass;
    body.inverse_inertia = inverse_inertia_of(*record.motion);
    body.inertia_kgm2 = record.traits.inertia_kgm2;
    body.isotropic_inertia = record.traits.isotropic_inertia;
    body.acceleration_mps2 = Vec3(step.gravity_mps2) * record.traits.gravity_factor;
    if (record.applied.by_caller) {
        body.acceleration_mps2 += callers_force_N(record) * record.motion->inverse_mass;
        body.angular_acceleration_radps2 = angular_gain(*record.motion, record.applied.torque_Nm);
    }
    if (record.traits.linear_damping_per_s > 0)
        body.linear_damping_factor =
            static_cast<Real>(portable_exp(-record.traits.linear_damping_per_s * h));
    if (record.traits.angular_damping_per_s > 0)
        body.angular_damping_factor =
            static_cast<Real>(portable_exp(-record.traits.angular_damping_per_s * h));
    return body;
}

/// What callers' forces press the bodies of a pair together with.
Real pressed_N(const Manifold& manifold) {
    if (manifold.points.empty()) return 0;
    const Vec3& normal = manifold.points.front().normal_world;
    const auto towards = [](const BodyRecord& record, const Vec3& direction) {
        if (!pushable(record) || !record.applied.by_caller) return Real{0};
        return glm::dot(callers_force_N(record), direction);
    };
    return std::max(towards(*manifold.a, -normal), towards(*manifold.b, normal));
}

/// The number of the belt that a body is (ContactConstraint::belt).
std::uint32_t belt_of(const BodyRecord& record, ContactSet& contacts) {
    if (!record.traits.is_belt()) return 0;
    contacts.belts.push_back(surface_motion(record));
    return static_cast<std::uint32_t>(contacts.belts.size());
}

void write_bodies(std::span<const SolverBody> bodies, std::span<BodyRecord* const> records) {
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        if (records[i] == nullptr) continue;
        BodyRecord& record = *records[i];
        const SolverBody& body = bodies[i];
        BallisticState& ballistic = record.motion->ballistic;
        ballistic.position_m = body.start_position_m + Vec3d(body.delta_position_m);
        ballistic.orientation = glm::normalize(Quatd(body.delta_rotation) * body.start_orientation);
        ballistic.velocity_mps = Vec3d(body.velocity_mps);
        ballistic.spin_radps = Vec3d(body.spin_radps);
        ballistic.going = true;
        record.motion->velocity_mps = body.velocity_mps;
        record.motion->spin_radps = body.spin_radps;
        record.motion->at = transform_of({Vec3(ballistic.position_m), Quat(ballistic.orientation)});
    }
}

void write_joints(std::span<const SolverJoint> joints,
                  std::span<JointRecord* const> records,
                  double step_s) {
    for (std::size_t i = 0; i < joints.size(); ++i) {
        JointRecord& joint = *records[i];
        joint.solver = joints[i];
        joint.state.error_m = joint.solver.error_m;
        joint.state.force_N =
            static_cast<Real>(glm::length(joint.solver.total_impulse_Ns) / step_s);
        joint.state.torque_Nm =
            static_cast<Real>(glm::length(joint.solver.total_angular_impulse_Nms) / step_s);
        joint.state.position = static_cast<Real>(joint.solver.position);
    }
}

int substeps_of_part(int substeps, double share) {
    constexpr double kRounding = 1e-9;
    return std::max(static_cast<int>(std::ceil(substeps * share - kRounding)), 1);
}

void count(const LoopReport& report, Interventions& done) {
    done.braked_J += report.braked_J;
    done.braked_islands += report.braked_J > 0 ? 1U : 0U;
    done.clamped_bodies += report.clamped_bodies;
    done.unresolved_islands += report.unresolved_joints ? 1U : 0U;
    done.impacts += report.impacts;
}

}  // namespace

struct IslandSolver::Impl {
    IslandLoop loop;
    ContactBridge bridge;
    SubstepChooser chooser;
    SubstepChoice chosen;  ///< for the island at work
    std::vector<ManifoldLoad> kept_loads;
    std::vector<BodyRecord*> records;  ///< of loop.bodies; null: what the island does not move
    /// Where bodies that bound the island stand in loop.bodies; other islands may have them too.
    std::unordered_map<const BodyRecord*, std::uint32_t> bounds;

    SubstepChoice choose(const Island& island, const IslandStep& step);
    void hold(const Island& island, const IslandStep& step, SubstepChoice& choice) const;
    /// After bridge.begin_island(). `at_impact`: with the distances at which the bodies touch.
    void gather(Island& island, const IslandStep& step, double h, bool at_impact = false);

    std::uint32_t index_of(const BodyRecord& record);
    std::uint32_t posed_index_of(const BodyRecord& record);
    std::uint32_t add_body(BodyRecord* record, const SolverBody& body);
    void add_joint(const JointRecord& joint);
    void add_to_fields(const BodyRecord& record, std::span<ForceField* const> fields);
};

IslandSolver::IslandSolver() : impl_(std::make_unique<Impl>()) {}
IslandSolver::~IslandSolver() = default;

std::uint32_t IslandSolver::Impl::add_body(BodyRecord* record, const SolverBody& body) {
    const auto index = static_cast<std::uint32_t>(loop.bodies.size());
    records.push_back(record);
    loop.bodies.push_back(body);
    return index;
}

/// Kinematic bodies that move join the island when something of it touches them.
std::uint32_t IslandSolver::Impl::index_of(const BodyRecord& record) {
    if (pushable(record)) return record.small.row;
    const bool moves = record.kind == BodyKind::Kinematic && !stands_still(record);
    // One that stands still has a place only where a joint holds it.
    const auto place = bounds.find(&record);
    if (place != bounds.end()) return place->second;
    return moves ? posed_index_of(record) : kWorldBody;
}

/// A joint's anchor is in its body's frame: bodies that stand still have a place of their own too.
std::uint32_t IslandSolver::Impl::posed_index_of(const BodyRecord& record) {
    if (pushable(record)) return record.small.row;
    const auto [place, added] = bounds.try_emplace(&record, 0);
    if (added) place->second = add_body(nullptr, posed_body(record));
    return place->second;
}

void IslandSolver::Impl::add_joint(const JointRecord& joint) {
    SolverJoint entry = joint.solver;
    entry.a = posed_index_of(*joint.a);
    entry.b = joint.b != nullptr ? posed_index_of(*joint.b) : kWorldBody;
    loop.joints.push_back(entry);
}

/// What moves along with the body makes it heavier, not its weight.
void IslandSolver::Impl::add_to_fields(const BodyRecord& record,
                                       std::span<ForceField* const> fields) {
    double added_kg = 0;
    for (std::uint32_t mask = record.small.fields; mask != 0; mask &= mask - 1)
        added_kg +=
            fields[static_cast<std::size_t>(std::countr_zero(mask))]->added_mass_kg(record.id);
    if (added_kg > 0) {
        SolverBody& body = loop.bodies[record.small.row];
        const auto share =
            static_cast<Real>(record.traits.mass_kg / (record.traits.mass_kg + added_kg));
        body.inverse_mass *= share;
        body.acceleration_mps2 *= share;
    }
    loop.fields.add(record.small.row, record.id, record.small.fields);
}

/// What the contacts carried lately, or what stands on them.
SubstepChoice IslandSolver::Impl::choose(const Island& island, const IslandStep& step) {
    chooser.begin(island.bodies.size(), step.step_s);
    if (step.substeps_most <= step.substeps_least)
        return chooser.choose(step.substeps_least, step.substeps_most);
    const auto number_of = [](const BodyRecord& record) {
        return pushable(record) ? static_cast<int>(record.small.row) : -1;
    };
    for (std::size_t i = 0; i < island.bodies.size(); ++i) {
        BodyRecord& record = *island.bodies[i];
        record.small.row = static_cast<std::uint32_t>(i);
        const Vec3 gravity = Vec3(step.gravity_mps2) * record.traits.gravity_factor;
        chooser.set_body(static_cast<int>(i),
                         glm::length(gravity) / record.motion->inverse_mass,
                         is_plate(record.traits.inertia_kgm2));
    }
    for (auto from = island.manifolds.begin(); from != island.manifolds.end();) {
        const Manifold* manifold = *from;
        SubstepChooser::Pair pair{
            .a = number_of(*manifold->a), .b = number_of(*manifold->b), .size_m = 1e6_r};
        // All that two bodies have between them carries as one contact does.
        for (; from != island.manifolds.end() && (*from)->a == manifold->a &&
               (*from)->b == manifold->b;
             ++from)
            pair.load_N += bridge.lasting_load_N(**from);
        pair.is_load_known = pair.load_N > 0;
        pair.load_N = std::max(pair.load_N, pressed_N(*manifold));
        Real inverse_mass = 0;
        for (const BodyRecord* end : {manifold->a, manifold->b}) {
            const Real inner_radius_m = end->sweep.inner_radius_m;
            if (!pushable(*end)) continue;
            inverse_mass += end->motion->inverse_mass;
            if (inner_radius_m > 0) pair.size_m = std::min(pair.size_m, 2 * inner_radius_m);
        }
        pair.reduced_mass_kg = 1 / inverse_mass;
        chooser.add_contact(pair);
    }
    for (const JointRecord* joint : island.joints) {
        Real spin_radps = glm::length(joint->a->motion->spin_radps);
        Real size_m = std::max(2 * joint->a->sweep.inner_radius_m, 1e-3_r);
        if (joint->b != nullptr) {
            spin_radps = std::max(spin_radps, glm::length(joint->b->motion->spin_radps));
            size_m = std::max(size_m, 2 * joint->b->sweep.inner_radius_m);
        }
        chooser.add_joint(
            spin_radps, static_cast<Real>(joint->state.error_m) / size_m, joint->def.substeps);
    }
    for (const BodyRecord* record : island.bodies) {
        for (std::uint32_t mask = record->small.fields; mask != 0; mask &= mask - 1)
            chooser.add_field(
                step.fields[static_cast<std::size_t>(std::countr_zero(mask))]->substeps());
    }
    SubstepChoice choice = chooser.choose(step.substeps_least, step.substeps_most);
    hold(island, step, choice);
    return choice;
}

/// Fewer sub-steps only after a while of asking for far fewer: contacts give way a little when the
/// number changes, and that must not make them ask for more again.
void IslandSolver::Impl::hold(const Island& island,
                              const IslandStep& step,
                              SubstepChoice& choice) const {
    // What most of the bodies had: a few that join from a harder island do not decide.
    std::array<int, kMostSubsteps + 1> bodies_with{};
    int had = 0;
    for (const BodyRecord* record : island.bodies) {
        const int substeps = std::min(record->small.substeps, kMostSubsteps);
        ++bodies_with[static_cast<std::size_t>(substeps)];
        had = std::max(had, substeps);
    }
    for (auto more = static_cast<std::size_t>(bodies_with[static_cast<std::size_t>(had)]);
         had > 0 && 2 * more < island.bodies.size();) {
        --had;
        more += static_cast<std::size_t>(bodies_with[static_cast<std::size_t>(had)]);
    }
    int for_steps = kHoldSteps;
    for (const BodyRecord* record : island.bodies) {
        if (record->small.substeps == had)
            for_steps = std::min(for_steps, record->small.substeps_held);
    }
    had = std::min(had, most_of_stacks(step.substeps_most));
    const bool far_fewer = kFarFewer * static_cast<double>(had) >= choice.substeps &&
                           choice.needed <= kSurelyEnough * choice.substeps;
    const bool held = choice.substeps < had && (!far_fewer || for_steps < kHoldSteps);
    if (held) choice = {had, SubstepReason::Held, choice.needed};
    for (BodyRecord* record : island.bodies) {
        record->small.substeps = choice.substeps;
        record->small.substeps_held = held ? for_steps + 1 : 0;
    }
}

void IslandSolver::Impl::gather(Island& island, const IslandStep& step, double h, bool at_impact) {
    const TraceSpan span("gather");
    loop.clear();
    records.assign(1, nullptr);
    bounds.clear();
    loop.fields.begin_island(step.fields);
    for (BodyRecord* record : island.bodies) {
        if (record->traits.held_along_axes()) {
            loop.held.push_back({.body = static_cast<std::uint32_t>(loop.bodies.size()),
                                 .linear_factor = record->traits.linear_factor});
        }
        record->small.row = add_body(record, dynamic_body(*record, step, h));
        if (record->small.fields != 0) add_to_fields(*record, step.fields);
    }
    for (Manifold* manifold : island.manifolds) {
        const BodyRecord& bound = pushable(*manifold->a) ? *manifold->b : *manifold->a;
        bridge.add(*manifold,
                   {.a = index_of(*manifold->a),
                    .b = index_of(*manifold->b),
                    .belt = step.features.belts ? belt_of(bound, loop.contacts) : 0,
                    .a_moves = pushable(*manifold->a)},
                   static_cast<Real>(h),
                   loop.contacts);
        if (!at_impact) continue;
        const auto near_m = static_cast<Real>(touching_m(*manifold->a, *manifold->b));
        loop.touching_m.resize(loop.contacts.constraints.size(),
                               std::isfinite(near_m) ? near_m : Real{0});
    }
    for (const JointRecord* joint : island.joints) add_joint(*joint);
}

void IslandSolver::solve_impacts(Island& island, const IslandStep& step, IslandResult& result) {
    Impl& impl = *impl_;
    std::vector<ManifoldLoad>& loads = impl.kept_loads;
    loads.clear();
    for (const Manifold* manifold : island.manifolds) loads.push_back(manifold->load);
    const double h = step.step_s * kImpactShare;
    impl.bridge.begin_island(step.number);
    impl.gather(island, step, h, true);
    const LoopReport report =
        impl.loop.run_impacts({.step_s = h,
                               .substeps = 1,
                               .gravity_mps2 = static_cast<Real>(glm::length(step.gravity_mps2)),
                               .push_mps = kContactPush_mps},
                              static_cast<Real>(step.step_s));
    write_bodies(impl.loop.bodies, impl.records);
    impl.bridge.count_impulses(impl.loop.contacts);
    for (std::size_t i = 0; i < loads.size(); ++i) island.manifolds[i]->load = loads[i];
    result.cost.row_solves += report.row_solves;
    count(report, result.cost.interventions);
}

void IslandSolver::solve(Island& island, const IslandStep& step, IslandResult& result) {
    Impl& impl = *impl_;
    impl.bridge.begin_island(step.number);
    if (step.first) impl.chosen = impl.choose(island, step);
    const SubstepChoice& choice = impl.chosen;
    const double part_s = step.part_s > 0 ? step.part_s : step.step_s;
    const int substeps = substeps_of_part(choice.substeps, part_s / step.step_s);
    const double h = part_s / substeps;
    const bool is_parted = island.swept || part_s < step.step_s;
    impl.gather(island, step, h);
    const LoopReport report =
        impl.loop.run({.step_s = part_s,
                       .start_s = step.start_s,
                       .substeps = substeps,
                       .spring_s = is_parted ? step.step_s / choice.substeps : 0,
                       .iterations = step.iterations,
                       .gravity_mps2 = static_cast<Real>(glm::length(step.gravity_mps2)),
                       .push_mps = kContactPush_mps,
                       .gyroscopic_torque = step.features.gyroscopic_torque,
                       .joint_method = step.joints,
                       .team = step.team});
    const TraceSpan span("write back");
    write_bodies(impl.loop.bodies, impl.records);
    impl.bridge.write_back(impl.loop.contacts, static_cast<Real>(h));
    if (is_parted) impl.bridge.ease_loads(static_cast<Real>(h * choice.substeps / step.step_s));
    write_joints(impl.loop.joints, island.joints, part_s);
    result.cost.row_solves += report.row_solves;
    result.cost.belts += static_cast<std::uint32_t>(impl.loop.contacts.belts.size());
    count(report, result.cost.interventions);
    if (step.last) result.cost.contacts += impl.bridge.point_count();
    result.report = {.user = island.bodies.empty() ? 0 : island.bodies.front()->user,
                     .bodies = static_cast<std::uint32_t>(island.bodies.size()),
                     .contacts = impl.bridge.point_count(),
                     .joints = static_cast<std::uint32_t>(island.joints.size()),
                     .substeps = result.report.substeps + substeps,
                     .reason = reason_name(choice.reason)};
}

}  // namespace plumbline::physics
