// [wind], [grass], [[flock]], [[fountain]] and [effects.fountain].
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

constexpr std::size_t kListed = 64;  // fountains, their pools, flocks
constexpr int kFlyers = 200;         // of a flock
constexpr int kStreams = 256;

void read_pool(TableReader& table, PoolDescription& pool) {
    table.require("center_m", "[x, y, z] in m");
    table.read("center_m", pool.center_m, kCoordinate_m);
    table.read("radius_m", pool.radius_m, kSize_m);
}

void read_ring(TableReader& table, NozzleRing& nozzles) {
    table.read("radius_m", nozzles.radius_m, kSize_m);
    table.read("streams", nozzles.streams, 1, kStreams);
}

void read_fountain(TableReader& table, FountainDescription& fountain) {
    table.require("position_m", "[x, y, z] in m");
    table.read("position_m", fountain.position_m, kCoordinate_m);
    table.read_direction("direction", fountain.direction);
    table.read_table("ring", fountain.ring, read_ring);
    table.read("speed_mps", fountain.speed_mps, {0, 100, "metres a second from 0 to 100"});
    table.read_degrees("spread_deg", fountain.spread_rad, {0, 89, "degrees from 0 to 89"});
    table.read("flow_lps", fountain.flow_lps, {0, 1e4, "litres a second from 0 to 10000"});
    table.read("drop_mm", fountain.drop_mm, {0.1, 100, "millimetres from 0.1 to 100"});
    table.read("drag", fountain.drag);
    read_listed(table, "pools", fountain.pools, read_pool, kListed);
}

void read_wind(TableReader& table, WindDescription& wind, const LoadContext& context) {
    const Vec3 fallback = wind.direction;
    table.read_direction("direction", wind.direction);
    const Vec3 level{wind.direction.x, 0, wind.direction.z};
    if (glm::length(level) < 1e-6_r)
        table.error("direction", "is upright; expected a direction along the ground");
    wind.direction = normalize_or(level, fallback);
    table.read("speed_mps", wind.speed_mps, {0, 1000, "metres a second from 0 to 1000"});
    table.read("gusts", wind.gusts, kFraction);
    table.read("gust_size_m", wind.gust_size_m, {0.5, 1000, "a length from 0.5 to 1000 m"});
    table.read("shelter", wind.shelter);
    if (auto sound = table.table("sound")) {
        wind.sound = read_sound_file(*sound, "file", context);
        sound->read("gain", wind.sound_gain, kGain);
        sound->finish();
    }
}

void read_flock(TableReader& table, FlockDescription& flock) {
    table.read_choice("kind", flock.kind, {"birds", "butterflies"});
    table.read("count", flock.count, 1, kFlyers);
    table.require("center_m", "[x, y, z] in m");
    table.read("center_m", flock.center_m, kCoordinate_m);
    table.read("radius_m", flock.radius_m, kSize_m);
    table.read("height_m", flock.height_m, kSize_m);
}

void read_grass(TableReader& table, GrassDescription& grass, const SceneDescription& scene) {
    table.read("on", grass.on);
    if (grass.on.empty()) table.error("on", "missing; expected names of entities that it grows on");
    for (const std::string& name : grass.on) {
        const auto found = std::ranges::find(scene.entities, name, &EntityDescription::name);
        if (found == scene.entities.end()) {
            table.error("on", "no entity is called \"{}\"", shown(name));
        } else if (!found->body) {
            table.error("on", "\"{}\" has no body", shown(name));
        }
    }
    table.read_color("color", grass.color, kFraction);
    table.read("height_m", grass.height_m, {0.01, 2, "a length from 0.01 to 2 m"});
    table.read(
        "density_perm2", grass.density_perm2, {0, 100, "tufts a square metre from 0 to 100"});
    table.read("distance_m", grass.distance_m, {1, 60, "a length from 1 to 60 m"});
}

}  // namespace

void read_fidelity(TableReader& table, Fidelity& fidelity) {
    table.read_choice("fidelity", fidelity, {"draft", "balanced", "precise"});
}

void read_nature(TableReader& root, SceneDescription& scene, const LoadContext& context) {
    root.read_table("wind", scene.wind, read_wind, context);
    root.read_table("grass", scene.grass, read_grass, scene);
    read_listed(root, "flock", scene.flocks, read_flock, kListed);
    read_listed(root, "fountain", scene.fountains, read_fountain, kListed);
}

}  // namespace plumbline::scene
