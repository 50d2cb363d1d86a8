#include "engine/scene/state_report.h"

#include "engine/core/hash.h"
#include "engine/physics/totals.h"
#include "engine/scene/formats/json_text.h"
#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/simulation/wholes_report.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {

namespace {

/// What water displaced by rigid bodies has risen by, and waves.
double water_J(const Simulation& simulation) {
    double sum = simulation.force_fields.energy_J("buoyancy");
    for (const SceneWater& water : simulation.waters)
        sum += water.waves ? water.waves->energy_J() + water.waves->raised_J() : 0;
    return sum;
}

void add_totals(JsonText& json, const Simulation& simulation) {
    const Totals totals = totals_of(simulation);
    json.key("energy_J").begin_object();
    json.key("kinetic").number(totals.energy.kinetic_J);
    json.key("potential").number(totals.energy.potential_J);
    json.key("elastic").number(totals.energy.elastic_J);
    json.key("water").number(totals.water_J);
    json.key("magnetic").number(totals.magnetic_J);
    json.end_object();
    json.key("momentum_kgmps").vector(totals.momentum_kgmps);
    json.key("angular_momentum_kgm2ps").vector(totals.angular_momentum_kgm2ps);
    json.key("max_penetration_m").number(max_penetration_m(simulation.physics));
    json.key("max_joint_error_m").number(max_joint_error_m(simulation.physics));
}

void add_bodies(JsonText& json, const Simulation& simulation) {
    json.key("bodies").begin_array();
    for (const MovingBody& moving : simulation.moving_bodies()) {
        if (!simulation.physics.contains(moving.body)) continue;
        if (simulation.registry.has<PartOf>(moving.entity)) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        const Quat& q = state.world_from_body.orientation;
        json.begin_object();
        json.key("name").text(name_of_mark(simulation, simulation.physics.state(moving.body).user));
        json.key("position_m").vector(state.world_from_body.position);
        json.key("orientation").begin_array();
        json.number(q.w).number(q.x).number(q.y).number(q.z);
        json.end_array();
        json.key("mass_kg").number(state.mass.mass_kg);
        json.key("velocity_mps").vector(state.velocity_mps);
        json.key("angular_velocity_radps").vector(state.angular_velocity_radps);
        json.key("awake").boolean(state.awake);
        json.end_object();
    }
    json.end_array();
}

void add_contacts(JsonText& json,
                  const Simulation& simulation,
                  std::span<const physics::ContactEvent> contacts) {
    json.key("contacts").begin_array();
    for (const physics::ContactEvent& contact : contacts) {
        json.begin_object();
        json.key("a").text(name_of_mark(simulation, contact.user_a));
        json.key("b").text(name_of_mark(simulation, contact.user_b));
        json.key("impulse_Ns").number(contact.impulse_Ns);
        json.end_object();
    }
    json.end_array();
}

void add_joints(JsonText& json, const Simulation& simulation) {
    json.key("joints").begin_array();
    for (const SceneJoint& joint : simulation.joints()) {
        if (!simulation.physics.contains(joint.joint)) continue;
        const physics::JointState& state = simulation.physics.joint(joint.joint).state;
        json.begin_object();
        json.key("name").text(joint.name);
        json.key("error_m").number(state.error_m);
        json.key("force_N").number(state.force_N);
        json.key("torque_Nm").number(state.torque_Nm);
        json.key("position").number(state.position);
        json.key("broken").boolean(state.broken);
        json.end_object();
    }
    json.end_array();
}

/// Who got how many sub-steps in the latest step, and why. small_step only.
void add_islands(JsonText& json, const Simulation& simulation) {
    json.key("islands").begin_array();
    for (const physics::IslandReport& island : simulation.physics.report().islands) {
        json.begin_object();
        json.key("first").text(name_of_mark(simulation, island.user));
        json.key("bodies").number(island.bodies);
        json.key("contacts").number(island.contacts);
        json.key("joints").number(island.joints);
        json.key("substeps").number(island.substeps);
        json.key("why").text(island.reason);
        json.end_object();
    }
    json.end_array();
}

void add_cost(JsonText& json, const CostHistory& costs) {
    const Percentiles step_ms = percentiles_of(costs.step_ms);
    const double phases_ms = costs.broad_ms + costs.narrow_ms + costs.solve_ms + costs.integrate_ms;
    json.begin_object();
    json.key("cpu_ms_total").number(costs.cpu_ms_total);
    json.key("wall_ms_total").number(costs.wall_ms_total);
    json.key("step_ms").begin_object();
    json.key("median").number(step_ms.median);
    json.key("p95").number(step_ms.p95);
    json.key("p99").number(step_ms.p99);
    json.key("max").number(step_ms.max);
    json.end_object();
    json.key("phases_ms").begin_object();
    json.key("broad").number(costs.broad_ms);
    json.key("narrow").number(costs.narrow_ms);
    json.key("solve").number(costs.solve_ms);
    json.key("integrate").number(costs.integrate_ms);
    json.key("other").number(std::max(0.0, costs.cpu_ms_total - phases_ms));
    json.end_object();
    json.key("row_solves").number(costs.row_solves);
    json.key("contacts_max").number(costs.contacts_max);
    json.key("interventions").raw(interventions_json(costs.interventions));
    json.end_object();
}

}  // namespace

Totals totals_of(const Simulation& simulation) {
    Totals totals{.energy = physics::energy(simulation.physics),
                  .water_J = water_J(simulation),
                  .magnetic_J = simulation.force_fields.energy_J("magnets"),
                  .momentum_kgmps = physics::momentum_kgmps(simulation.physics),
                  .angular_momentum_kgm2ps = physics::angular_momentum_kgm2ps(simulation.physics)};
    for (const auto& list : {simulation.cloths(), simulation.softs()}) {
        for (const SceneDeformable& each : list) {
            const physics::PointTotals sum = each.body->body().totals();
            totals.energy.kinetic_J += sum.kinetic_J;
            totals.energy.elastic_J += sum.elastic_J;
            totals.water_J += sum.water_J;
            totals.energy.potential_J -=
                glm::dot(Vec3d(simulation.physics.def().gravity_mps2), sum.moment_kgm);
            totals.momentum_kgmps += sum.momentum_kgmps;
            totals.angular_momentum_kgm2ps += sum.angular_momentum_kgm2ps;
        }
    }
    return totals;
}

void CostHistory::add(const physics::StepCost& cost) {
    using Cost = physics::StepCost;
    const double share = step_ms.empty() ? 1.0 : kShareOfNewest;
    for (double Cost::*phase : {&Cost::broad_ms,
                                &Cost::narrow_ms,
                                &Cost::solve_ms,
                                &Cost::integrate_ms,
                                &Cost::total_ms,
                                &Cost::helpers_ms})
        recent.*phase += share * (cost.*phase - recent.*phase);
    step_ms.push_back(static_cast<float>(cost.total_ms));
    cpu_ms_total += cost.total_ms;
    wall_ms_total += cost.wall_ms;
    broad_ms += cost.broad_ms;
    narrow_ms += cost.narrow_ms;
    solve_ms += cost.solve_ms;
    integrate_ms += cost.integrate_ms;
    row_solves += cost.row_solves;
    contacts_max = std::max(contacts_max, cost.contacts);
    interventions.add(cost.interventions);
}

std::string interventions_text(const physics::Interventions& done) {
    std::vector<std::string> parts;
    if (done.braked_islands > 0)
        parts.push_back(
            fmt::format("{:.3g} J braked in {} islands", done.braked_J, done.braked_islands));
    const auto add = [&](std::uint64_t count, const char* what) {
        if (count > 0) parts.push_back(fmt::format("{} {}", count, what));
    };
    add(done.clamped_bodies, "bodies clamped");
    add(done.limited_bodies, "at the speed limit");
    add(done.unresolved_islands, "islands with joints too fast");
    add(done.restored_islands, "islands rolled back");
    add(done.oversized_islands, "islands too large for a matrix");
    add(done.left_out_pairs, "pairs of crowds left out");
    return fmt::format("{}", fmt::join(parts, ", "));
}

Percentiles percentiles_of(std::vector<float> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    // The smallest value that at least this share of all values does not exceed.
    const auto at = [&](double share) {
        const double rank = std::ceil(share * static_cast<double>(values.size()));
        const auto index = static_cast<std::size_t>(std::max(1.0, rank)) - 1;
        return static_cast<double>(values[std::min(index, values.size() - 1)]);
    };
    return {.median = at(0.5), .p95 = at(0.95), .p99 = at(0.99), .max = at(1.0)};
}

std::string state_json(const Simulation& simulation,
                       const CostHistory& costs,
                       const std::string& effects_json,
                       double lost_time_s,
                       bool one_line) {
    const physics::WorldDef& world = simulation.physics.def();
    JsonText json(one_line ? JsonLayout::OneLine : JsonLayout::Readable);
    json.begin_object();
    json.key("scene").text(simulation.description().file.generic_string());
    json.key("time_s").number(simulation.time_s());
    json.key("steps").number(simulation.steps());
    json.key("step_s").number(simulation.step_s());
    json.key("substeps").number(most_substeps(simulation.physics));
    json.key("iterations").number(world.iterations);
    json.key("solver").text(physics::solver_name(world.solver));
    json.key("precision").text(kPrecisionName);
    json.key("hash").text(hex_of(simulation.state_hash()));
    add_totals(json, simulation);
    json.key("lost_time_s").number(lost_time_s);
    json.key("removed").number(simulation.tally().removed);
    json.key("non_finite").number(simulation.physics.report().isolated.size());
    json.key("warnings").begin_array();
    for (const std::string& warning : simulation.warnings) json.text(warning);
    json.end_array();
    add_bodies(json, simulation);
    const std::vector<physics::ContactEvent> contacts = all_contacts(simulation.physics);
    add_contacts(json, simulation, contacts);
    add_joints(json, simulation);
    add_islands(json, simulation);
    add_wholes(json, simulation, contacts);
    json.key("cost");
    add_cost(json, costs);
    json.key("effects").raw(effects_json);
    json.end_object();
    return json.str();
}

std::string interventions_json(const physics::Interventions& done) {
    JsonText json(JsonLayout::OneLine);
    json.begin_object();
    json.key("braked_J").number(done.braked_J);
    json.key("braked_islands").number(done.braked_islands);
    json.key("clamped_bodies").number(done.clamped_bodies);
    json.key("unresolved_islands").number(done.unresolved_islands);
    json.key("restored_islands").number(done.restored_islands);
    json.key("limited_bodies").number(done.limited_bodies);
    json.key("impacts").number(done.impacts);
    json.key("oversized_islands").number(done.oversized_islands);
    json.key("left_out_pairs").number(done.left_out_pairs);
    return json.end_object().str();
}

std::string cost_json(const CostHistory& costs) {
    JsonText json(JsonLayout::OneLine);
    add_cost(json, costs);
    return json.str();
}

}  // namespace plumbline::scene
