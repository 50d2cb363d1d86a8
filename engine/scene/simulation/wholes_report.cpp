#include "engine/scene/simulation/wholes_report.h"

#include "engine/physics/sheet.h"
#include "engine/physics/soft_body.h"
#include "engine/scene/build/fragments.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

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
    for (std::size_t i = 0; i < simulation.waters.size(); ++i) {
        const WaterDescription& water = simulation.description().forces.waters[i];
        const SceneWater& there = simulation.waters[i];
        const WaveField* waves = there.waves.get();
        const double level_m = there.max_m.y;
        const Vec3d size_m = there.max_m - there.min_m;
        const WaveField::Range range = waves != nullptr ? waves->range() : WaveField::Range{};
        json.begin_object();
        json.key("name").text(water.name);
        json.key("volume_m3")
            .number(there.basin ? there.basin->volume_m3() : size_m.x * size_m.y * size_m.z);
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

}  // namespace

void add_wholes(JsonText& json,
                const Simulation& simulation,
                std::span<const physics::ContactEvent> contacts) {
    add_ropes(json, simulation);
    add_vehicles(json, simulation, contacts);
    add_cloths(json, simulation);
    add_softs(json, simulation);
    add_waters(json, simulation);
    add_breaks(json, simulation);
}

}  // namespace plumbline::scene
