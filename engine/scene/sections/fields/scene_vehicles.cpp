// [[vehicle]]: read and checked.
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kVehicles = 64;
constexpr std::size_t kWheels = 32;

constexpr Range kWheelSize{1e-2, 100, "a length from 0.01 to 100 m"};

void read_wheel(TableReader& table, WheelDescription& wheel) {
    table.require("position_m", "where its hub is, [x, y, z] in m, in the frame of the body");
    table.read("position_m", wheel.position_m, kCoordinate_m);
    table.read("radius_m", wheel.radius_m, kWheelSize);
    table.read("width_m", wheel.width_m, kWheelSize);
    table.read("mass_kg", wheel.mass_kg, {1e-3, 1e6, "a mass from 0.001 to 1000000 kg"});
    table.read("steers", wheel.steers);
    table.read("drives", wheel.drives);
    table.read("brakes", wheel.brakes);
    table.read("travel_m", wheel.travel_m, {0, 100, "a length from 0 to 100 m"});
    table.read("stiffness_Npm", wheel.stiffness_Npm, {0, 1e9, "N/m from 0 to 1e9"});
    table.read("damping_Nspm", wheel.damping_Nspm, {0, 1e9, "N s/m from 0 to 1e9"});
}

void read_vehicle(TableReader& table, VehicleDescription& vehicle, const SceneNames& names) {
    vehicle.name = read_name(table);
    table.require("body", "the name of an entity with a dynamic body: the chassis");
    const NamedEnd body = read_named_end(table, "body", names, vehicle.body, false);
    if (body.good && body.entity != nullptr && body.entity->body &&
        body.entity->body->kind != physics::BodyKind::Dynamic)
        table.error("body", "\"{}\" does not move; expected a dynamic body", shown(vehicle.body));
    table.read("friction", vehicle.friction, kGain);
    table.require("wheels", "a list of 1 to 32 tables, { position_m = [x, y, z], ... }");
    table.read_tables("wheels", vehicle.wheels, read_wheel);
    if (vehicle.wheels.size() > kWheels)
        table.error("wheels", "{} of them; at most {}", vehicle.wheels.size(), kWheels);
    VehicleControls& controls = vehicle.controls;
    table.read("throttle", controls.throttle, {-1, 1, "a number from -1 to 1"});
    table.read("brake", controls.brake, {0, 1, "a number from 0 to 1"});
    table.read_degrees("steer_deg", controls.steer_rad, {-80, 80, "an angle from -80 to 80"});
    table.read("max_torque_Nm", vehicle.max_torque_Nm, {0, 1e9, "N m from 0 to 1e9"});
    table.read("material", vehicle.material);
}

}  // namespace

void read_vehicles(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("vehicle");
    if (nodes.empty()) return;
    if (nodes.size() > kVehicles)
        return root.error("vehicle", "{} of them; at most {} are built", nodes.size(), kVehicles);
    const SceneNames names(scene, context);
    ForceDescription& forces = scene.forces;
    root.read_tables("vehicle", forces.vehicles, read_vehicle, names);
    std::set<std::string> taken;
    for (const RopeDescription& rope : forces.ropes) taken.insert(rope.name);
    for (const ClothDescription& cloth : forces.cloths) taken.insert(cloth.name);
    for (const SoftDescription& soft : forces.softs) taken.insert(soft.name);
    name_each(root, "vehicle", forces.vehicles, names, taken, "another vehicle, rope or entity");
    std::set<std::string> bodies;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!bodies.insert(forces.vehicles[i].body).second)
            root.item("vehicle", nodes, i)
                .error("body", "\"{}\" has wheels already", shown(forces.vehicles[i].body));
    }
}

}  // namespace plumbline::scene
