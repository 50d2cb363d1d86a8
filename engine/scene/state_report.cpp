#include "engine/scene/state_report.h"

#include "engine/core/hash.h"
#include "engine/physics/sheet.h"
#include "engine/physics/soft_body.h"
#include "engine/physics/totals.h"
#include "engine/scene/build/fragments.h"
#include "engine/scene/formats/json_text.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {

namespace {

/// What displaced water has risen by, and waves.
double water_J(const Simulation& simulation) {
    double sum = simulation.force_fields.energy_J("buoyancy");
    for (const auto& waves : simulation.waves)
        sum += waves ? waves->energy_J() + waves->raised_J() : 0;
    return sum;
}

void add_totals(JsonText& json, const Simulation& simulation) {
    physics::Energy energy = physics::energy(simulation.physics);
    Vec3d momentum_kgmps = physics::momentum_kgmps(simulation.physics);
    Vec3d angular_momentum_kgm2ps = physics::angular_momentum_kgm2ps(simulation.physics);
    for (const auto& list : {simulation.cloths(), simulation.softs()}) {
        for (const SceneDeformable& each : list) {
            const physics::PointTotals sum = each.body->body().totals();
            energy.kinetic_J += sum.kinetic_J;
            energy.elastic_J += sum.elastic_J;
            energy.potential_J -=
                glm::dot(Vec3d(simulation.physics.def().gravity_mps2), sum.moment_kgm);
            momentum_kgmps += sum.momentum_kgmps;
            angular_momentum_kgm2ps += sum.angular_momentum_kgm2ps;
        }
    }
    json.key("energy_J").begin_object();
    json.key("kinetic").number(energy.kinetic_J);
    json.key("potential").number(energy.potential_J);
    json.key("elastic").number(energy.elastic_J);
    json.key("water").number(water_J(simulation));
    json.key("magnetic").number(simulation.force_fields.energy_J("magnets"));
    json.end_object();
    json.key("momentum_kgmps").vector(momentum_kgmps);
    json.key("angular_momentum_kgm2ps").vector(angular_momentum_kgm2ps);
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

void add_ropes(JsonText& json, const Simulation& simulation) {
    json.key("ropes").begin_array();
    for (const Rope& rope : simulation.ropes()) {
        const std::vector<Vec3d> points = simulation.points_of(rope);
        const auto tension_N = [&](std::size_t joint) {
            return joint < rope.joints.size() && simulation.physics.contains(rope.joints[joint])
                       ? static_cast<double>(
                             simulation.physics.joint(rope.joints[joint]).state.force_N)
                       : 0.0;
        };
        json.begin_object();
        json.key("name").text(rope.name);
        json.key("points_m").begin_array();
        for (const Vec3d& point : points) json.vector(point);
        json.end_array();
        json.key("length_m").number(length_of(points));
        json.key("tension_N").begin_object();
        json.key("a").number(tension_N(0));
        json.key("b").number(tension_N(rope.pieces.size()));
        json.end_object();
        json.key("broken").boolean(std::ranges::any_of(rope.joints, [&](physics::JointId joint) {
            return !simulation.physics.contains(joint) ||
                   simulation.physics.joint(joint).state.broken;
        }));
        json.end_object();
    }
    json.end_array();
}

/// What presses a wheel, along the chassis' up; and whether anything does.
double load_N(const Simulation& simulation,
              std::span<const physics::ContactEvent> contacts,
              physics::BodyId wheel,
              const Vec3& up,
              bool& on_ground) {
    double sum_Ns = 0;
    for (const physics::ContactEvent& contact : contacts) {
        if (contact.a != wheel && contact.b != wheel) continue;
        on_ground = true;
        const Real share = glm::dot(contact.normal_world, up);
        sum_Ns += static_cast<double>(contact.impulse_Ns * (contact.a == wheel ? share : -share));
    }
    return sum_Ns / simulation.step_s();
}

void add_vehicles(JsonText& json,
                  const Simulation& simulation,
                  std::span<const physics::ContactEvent> contacts) {
    json.key("vehicles").begin_array();
    for (const Vehicle& vehicle : simulation.vehicles()) {
        if (!simulation.physics.contains(vehicle.chassis)) continue;
        const physics::BodyState chassis = simulation.physics.state(vehicle.chassis);
        const Quat& turned = chassis.world_from_body.orientation;
        json.begin_object();
        json.key("name").text(vehicle.name);
        json.key("speed_mps").number(glm::dot(chassis.velocity_mps, turned * Vec3{0, 0, -1}));
        json.key("wheels").begin_array();
        for (const Wheel& wheel : vehicle.wheels) {
            if (!simulation.physics.contains(wheel.body)) continue;
            bool on_ground = false;
            const double pressed_N =
                load_N(simulation, contacts, wheel.body, turned * Vec3{0, 1, 0}, on_ground);
            json.begin_object();
            json.key("on_ground").boolean(on_ground);
            json.key("spin_radps").number(simulation.spin_radps(wheel));
            json.key("load_N").number(pressed_N);
            json.key("position_m")
                .vector(simulation.physics.state(wheel.body).world_from_body.position);
            json.end_object();
        }
        json.end_array();
        json.end_object();
    }
    json.end_array();
}

void add_points(JsonText& json, const physics::PointBody& body) {
    json.key("points_m").begin_array();
    for (const Vec3d& point : body.positions_m()) json.vector(point);
    json.end_array();
}

void add_cloths(JsonText& json, const Simulation& simulation) {
    json.key("cloths").begin_array();
    for (const SceneDeformable& each : simulation.cloths()) {
        const auto& sheet = dynamic_cast<const physics::Sheet&>(each.body->body());
        json.begin_object();
        json.key("name").text(each.name);
        json.key("columns").number(sheet.columns());
        json.key("rows").number(sheet.rows());
        add_points(json, sheet);
        json.key("area_m2").number(sheet.area_m2());
        json.key("torn").number(sheet.torn());
        json.end_object();
    }
    json.end_array();
}

void add_softs(JsonText& json, const Simulation& simulation) {
    json.key("softs").begin_array();
    for (const SceneDeformable& each : simulation.softs()) {
        const auto& soft = dynamic_cast<const physics::SoftBody&>(each.body->body());
        json.begin_object();
        json.key("name").text(each.name);
        add_points(json, soft);
        json.key("volume_m3").number(soft.volume_m3());
        json.key("rest_volume_m3").number(soft.rest_volume_m3());
        json.end_object();
    }
    json.end_array();
}

void add_waters(JsonText& json, const Simulation& simulation) {
    json.key("waters").begin_array();
    const std::vector<WaterDescription>& waters = simulation.description().forces.waters;
    for (std::size_t i = 0; i < waters.size(); ++i) {
        const WaterDescription& water = waters[i];
        const WaveField* waves = i < simulation.waves.size() ? simulation.waves[i].get() : nullptr;
        const auto level_m = static_cast<double>(water.max_m.y);
        const Vec3d size_m(water.max_m - water.min_m);
        const WaveField::Range range = waves != nullptr ? waves->range() : WaveField::Range{};
        json.begin_object();
        json.key("name").text(water.name);
        json.key("volume_m3").number(size_m.x * size_m.y * size_m.z);
        json.key("level_m").begin_object();
        json.key("min").number(level_m + range.min_m);
        json.key("mean").number(level_m + range.mean_m);
        json.key("max").number(level_m + range.max_m);
        json.end_object();
        json.key("energy_J").number(waves != nullptr ? waves->energy_J() : 0.0);
        json.key("probes_m").begin_array();
        for (const Vec2& probe : water.probes_m) {
            const glm::dvec2 at(probe);
            json.number(level_m + (waves != nullptr ? waves->height_m(at.x, at.y) : 0.0));
        }
        json.end_array();
        json.end_object();
    }
    json.end_array();
}

void add_breaks(JsonText& json, const Simulation& simulation) {
    std::vector<std::size_t> parts(simulation.wholes().size(), 0);
    for (auto [entity, fragile] : simulation.registry.view<const Fragile>()) ++parts[fragile.whole];
    json.key("breaks").begin_array();
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const FragileWhole& whole = *simulation.wholes()[i];
        if (!whole.broke_at_s) continue;
        json.begin_object();
        json.key("name").text(whole.name);
        json.key("at_s").number(*whole.broke_at_s);
        json.key("pieces").number(parts[i]);
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

void CostHistory::add(const physics::StepCost& cost) {
    step_ms.push_back(static_cast<float>(cost.total_ms));
    cpu_ms_total += cost.total_ms;
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
    add_ropes(json, simulation);
    add_vehicles(json, simulation, contacts);
    add_cloths(json, simulation);
    add_softs(json, simulation);
    add_waters(json, simulation);
    add_breaks(json, simulation);
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
