// Forces that bodies feel: keys of [entity.body], [world], [[wind_zone]], [[water]] and [[explosion]].
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

constexpr std::size_t kZones = 64;
constexpr std::size_t kWaters = 16;
constexpr std::size_t kExplosions = 256;
constexpr std::size_t kProbes = 64;
constexpr int kMostAskedPieces = 100'000;
constexpr int kMostPieces = 256;
constexpr Real kStiffnessByStrength = 1000;
constexpr int kLeastModes = 16;  // along a side, at draft

void read_drag(TableReader& table, Drag& drag) {
    table.read("coefficient", drag.coefficient, {0, 100, "a coefficient from 0 to 100"});
    table.read("area_m2", drag.area_m2, {1e-8, 1e6, "an area from 1e-8 to 1000000 m2"});
    table.read("spin_lift", drag.spin_lift, {-100, 100, "a coefficient from -100 to 100"});
    table.read("buoyant", drag.buoyant);
}

void read_magnet(TableReader& table, Magnet& magnet) {
    table.require("moment_Am2", "[x, y, z] in A m2");
    table.read("moment_Am2", magnet.moment_Am2, {-1e6, 1e6, "A m2 from -1000000 to 1000000"});
}

/// The box from min_m to max_m, both of which are needed.
template <class T>
void read_box(TableReader& table, T& box) {
    table.require("min_m", "[x, y, z] in m");
    table.require("max_m", "[x, y, z] in m");
    table.read("min_m", box.min_m, kCoordinate_m);
    table.read("max_m", box.max_m, kCoordinate_m);
    if (glm::any(glm::greaterThanEqual(box.min_m, box.max_m)))
        table.error("max_m", "is not above min_m along every axis");
}

void read_wind_zone(TableReader& table, WindZone& zone) {
    read_box(table, zone);
    if (!table.has("wind_share")) table.require("velocity_mps", "[x, y, z] in m/s; or wind_share");
    table.read("velocity_mps", zone.velocity_mps, kSpeed_mps);
    table.read("wind_share", zone.wind_share, {0, 1, "a share from 0 to 1"});
}

void read_probes(TableReader& table, std::vector<Vec2>& probes) {
    const TomlNode* node = table.find("probes_m");
    if (node == nullptr) return;
    const TomlArray* places = node->array();
    if (places == nullptr || places->size() > kProbes)
        return table.error("probes_m", "expected up to {} places [x, z] in m", kProbes);
    for (const TomlNode& place : *places) {
        const TomlArray* pair = place.array();
        if (pair == nullptr || pair->size() != 2)
            return table.error("probes_m", "expected [x, z] in m for each place");
        Vec2 at{0, 0};
        for (int axis = 0; axis < 2; ++axis) {
            const auto number = number_of((*pair)[static_cast<std::size_t>(axis)],
                                          table.path_of("probes_m"),
                                          kCoordinate_m,
                                          table.faults());
            at[axis] = static_cast<Real>(number.value_or(0));
        }
        probes.push_back(at);
    }
}

void read_basin(TableReader& table, WaterDescription& water) {
    table.read("basin", water.basin);
    for (const char* key : {"min_m", "max_m"}) {
        if (table.has(key)) table.error(key, "a basin's mesh says where its water is");
    }
    table.require("level_m", "the height of the surface in m, world");
    table.read("level_m", water.max_m.y, kCoordinate_m);
    if (water.surface == WaterSurface::Flat) return;
    table.warning("surface", "waves need a box of water; in a basin it lies flat");
    water.surface = WaterSurface::Flat;
}

void read_water(TableReader& table, WaterDescription& water) {
    table.read("name", water.name);
    table.read("density_kgpm3", water.density_kgpm3, {1e-3, 1e5, "kg/m3 from 0.001 to 100000"});
    table.read("drag", water.drag, {0, 1000, "a factor from 0 to 1000"});
    table.read("flow_mps", water.flow_mps, kSpeed_mps);
    table.read_choice("surface", water.surface, {"flat", "waves"});
    if (table.has("basin")) {
        read_basin(table, water);
    } else {
        read_box(table, water);
    }
    table.read("material", water.material);
    if (auto start = table.table("start")) {
        start->read("amplitude_m", water.start.amplitude_m, {-10, 10, "m from -10 to 10"});
        start->read("nx", water.start.nx, 0, kLeastModes - 1);
        start->read("nz", water.start.nz, 0, kLeastModes - 1);
        start->finish();
        if (water.surface == WaterSurface::Flat)
            table.warning("start", "a flat surface has no waves; set surface = \"waves\"");
    }
    read_probes(table, water.probes_m);
}

void read_explosion(TableReader& table, ExplosionDescription& explosion) {
    explosion.name = read_name(table);
    table.read("at_s", explosion.at_s, {0, 1e6, "a time from 0 to 1000000 s"});
    table.require("position_m", "[x, y, z] in m");
    table.read("position_m", explosion.position_m, kCoordinate_m);
    table.read("impulse_Ns", explosion.impulse_Ns, {0, 1e9, "N s from 0 to 1e9"});
    table.read("reach_m", explosion.reach_m, {1e-3, 1e4, "a length from 0.001 to 10000 m"});
}

void read_fracture(TableReader& table, FractureDescription& fracture) {
    constexpr Range kPressure_Pa{1, 1e15, "a pressure from 1 to 1e15 Pa"};
    int pieces = static_cast<int>(fracture.pieces);
    table.read("pieces", pieces, 2, kMostAskedPieces);
    if (pieces > kMostPieces) {
        table.warning(
            "pieces", "{} are more than {}: cut into {}", pieces, kMostPieces, kMostPieces);
        pieces = kMostPieces;
    }
    fracture.pieces = static_cast<std::uint32_t>(pieces);
    table.read("strength_Pa", fracture.strength_Pa, kPressure_Pa);
    fracture.stiffness_Pa = kStiffnessByStrength * fracture.strength_Pa;
    table.read("stiffness_Pa", fracture.stiffness_Pa, kPressure_Pa);
    int seed = 1;
    table.read("seed", seed, 0, 1'000'000'000);
    fracture.seed = static_cast<std::uint32_t>(seed);
}

void read_body_fracture(TableReader& table, BodyDescription& body) {
    table.read_table("fracture", body.fracture, read_fracture);
    if (!body.fracture) return;
    if (body.kind != physics::BodyKind::Dynamic) {
        table.warning("fracture", "only dynamic bodies break; ignored");
        body.fracture.reset();
        return;
    }
    for (const char* key : {"inertia_kgm2", "center_of_mass_m"}) {
        if (!table.has(key)) continue;
        table.warning(key, "is that of its pieces, as it can break; ignored");
        body.inertia_kgm2.reset();
        body.center_of_mass_m.reset();
    }
}

}  // namespace

void read_body_fields(TableReader& table, BodyDescription& body) {
    table.read_table("drag", body.drag, read_drag);
    table.read_table("magnet", body.magnet, read_magnet);
    read_body_fracture(table, body);
    if (body.drag && body.kind != physics::BodyKind::Dynamic) {
        table.warning("drag", "only dynamic bodies are moved by the air; ignored");
        body.drag.reset();
    }
    table.read("surface_velocity_mps", body.surface_velocity_mps, kSpeed_mps);
    table.read_degrees("surface_spin_degps",
                       body.surface_spin_radps,
                       {-1e6, 1e6, "degrees a second from -1000000 to 1000000"});
    if (body.kind != physics::BodyKind::Dynamic) return;
    for (const char* key : {"surface_velocity_mps", "surface_spin_degps"}) {
        if (table.has(key))
            table.warning(key, "only static and kinematic bodies are belts; ignored");
    }
    body.surface_velocity_mps = body.surface_spin_radps = Vec3{0, 0, 0};
}

void read_fields(TableReader& root, SceneDescription& scene) {
    read_listed(root, "wind_zone", scene.forces.wind_zones, read_wind_zone, kZones);
    read_listed(root, "water", scene.forces.waters, read_water, kWaters);
    read_listed(root, "explosion", scene.forces.explosions, read_explosion, kExplosions);
    for (std::size_t i = 0; i < scene.forces.waters.size(); ++i) {
        if (scene.forces.waters[i].name.empty())
            scene.forces.waters[i].name = fmt::format("water#{}", i + 1);
    }
}

}  // namespace plumbline::scene
