// [wind], [grass], [[flock]], [[fountain]] and [effects.fountain].
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::scene {
namespace {

constexpr std::size_t kListed = 64;  // fountains, their pools, flocks
constexpr int kFlyers = 200;         // of a flock
constexpr int kStreams = 256;
constexpr Range kJetSpeed_mps{0, 100, "metres a second from 0 to 100"};
constexpr Range kJetSpread_deg{0, 89, "degrees from 0 to 89"};
constexpr Range kFlow_lps{0, 1e4, "litres a second from 0 to 10000"};
constexpr Range kDrop_mm{0.1, 100, "millimetres from 0.1 to 100"};

/// The items of an array of tables with their paths; none where there are too many.
std::vector<std::pair<const TomlNode*, std::string>> listed_tables(TableReader& table,
                                                                   std::string_view key) {
    const auto nodes = table.tables(key);
    if (nodes.size() > kListed) {
        table.error(key, fmt::format("{} of them; at most {} are kept", nodes.size(), kListed));
        return {};
    }
    std::vector<std::pair<const TomlNode*, std::string>> listed;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        listed.emplace_back(&nodes[i], fmt::format("{}[{}]", table.path_of(key), i));
    return listed;
}

std::vector<PoolDescription> read_pools(TableReader& fountain) {
    std::vector<PoolDescription> pools;
    for (const auto& [node, path] : listed_tables(fountain, "pools")) {
        TableReader table(*node, path, fountain.faults());
        PoolDescription pool;
        if (!table.has("center_m")) table.error("center_m", "missing; expected [x, y, z] in m");
        pool.center_m = table.vector("center_m", pool.center_m, kCoordinate_m);
        pool.radius_m = table.number("radius_m", pool.radius_m, kSize_m);
        table.finish();
        pools.push_back(pool);
    }
    return pools;
}

FountainDescription read_fountain(TableReader& table) {
    FountainDescription fountain;
    fountain.location = table.location();
    if (!table.has("position_m")) table.error("position_m", "missing; expected [x, y, z] in m");
    fountain.position_m = table.vector("position_m", fountain.position_m, kCoordinate_m);
    fountain.direction = Vec3(table.direction("direction", Vec3d(fountain.direction)));
    if (auto ring = table.table("ring")) {
        NozzleRing nozzles;
        nozzles.radius_m = ring->number("radius_m", nozzles.radius_m, kSize_m);
        nozzles.streams = ring->integer("streams", nozzles.streams, 1, kStreams);
        ring->finish();
        fountain.ring = nozzles;
    }
    fountain.speed_mps = table.number("speed_mps", fountain.speed_mps, kJetSpeed_mps);
    fountain.spread_rad = radians_from_degrees(
        table.number("spread_deg", degrees_from_radians(fountain.spread_rad), kJetSpread_deg));
    fountain.flow_lps = table.number("flow_lps", fountain.flow_lps, kFlow_lps);
    fountain.drop_mm = table.number("drop_mm", fountain.drop_mm, kDrop_mm);
    fountain.drag = table.flag("drag", fountain.drag);
    fountain.pools = read_pools(table);
    table.finish();
    return fountain;
}

/// `sound = { file, gain }`
void read_wind_sound(TableReader& wind_table, WindDescription& wind, const LoadContext& context) {
    auto table = wind_table.table("sound");
    if (!table) return;
    constexpr Range kGain{0, 10, "a factor from 0 to 10"};
    if (!table->has("file")) table->error("file", "missing; expected a sound file");
    const auto file =
        read_file_reference(*table, "file", kSoundExtensions, "it stays silent", context);
    wind.sound_gain = table->single("gain", wind.sound_gain, kGain);
    table->finish();
    if (file && file->exists) wind.sound = file->file;
}

void read_wind(TableReader& root, SceneDescription& scene, const LoadContext& context) {
    auto table = root.table("wind");
    if (!table) return;
    constexpr Range kWindSpeed_mps{0, 1000, "metres a second from 0 to 1000"};
    constexpr Range kGustSize_m{0.5, 1000, "a length from 0.5 to 1000 m"};
    WindDescription wind;
    wind.location = table->location();
    const Vec3 direction(table->direction("direction", Vec3d(wind.direction)));
    if (glm::length(Vec2{direction.x, direction.z}) < 1e-6_r)
        table->error("direction", "is upright; expected a direction along the ground");
    wind.direction = normalize_or(Vec3{direction.x, 0, direction.z}, wind.direction);
    wind.speed_mps = table->number("speed_mps", wind.speed_mps, kWindSpeed_mps);
    wind.gusts = table->number("gusts", wind.gusts, kFraction);
    wind.gust_size_m = table->number("gust_size_m", wind.gust_size_m, kGustSize_m);
    read_wind_sound(*table, wind, context);
    table->finish();
    scene.wind = wind;
}

FlockDescription read_flock(TableReader& table) {
    constexpr std::array<std::string_view, 2> kFlockKinds{"birds", "butterflies"};
    FlockDescription flock;
    flock.location = table.location();
    flock.kind = static_cast<FlockKind>(table.choice("kind", 0, kFlockKinds));
    flock.count = table.integer("count", flock.count, 1, kFlyers);
    if (!table.has("center_m")) table.error("center_m", "missing; expected [x, y, z] in m");
    flock.center_m = table.vector("center_m", flock.center_m, kCoordinate_m);
    flock.radius_m = table.number("radius_m", flock.radius_m, kSize_m);
    flock.height_m = table.number("height_m", flock.height_m, kSize_m);
    table.finish();
    return flock;
}

void read_grass(TableReader& root, SceneDescription& scene) {
    auto table = root.table("grass");
    if (!table) return;
    constexpr Range kHeight_m{0.01, 2, "a length from 0.01 to 2 m"};
    constexpr Range kDensity_perm2{0, 100, "tufts a square metre from 0 to 100"};
    constexpr Range kDistance_m{1, 60, "a length from 1 to 60 m"};
    GrassDescription grass;
    grass.location = table->location();
    grass.on = table->texts("on");
    if (grass.on.empty())
        table->error("on", "missing; expected names of entities that it grows on");
    for (const std::string& name : grass.on) {
        const auto is_it = [&](const EntityDescription& entity) { return entity.name == name; };
        const auto found = std::ranges::find_if(scene.entities, is_it);
        if (found == scene.entities.end()) {
            table->error("on", fmt::format("no entity is called \"{}\"", shown(name)));
        } else if (!found->body) {
            table->error("on", fmt::format("\"{}\" has no body", shown(name)));
        }
    }
    grass.color = table->color("color", grass.color, kFraction);
    grass.height_m = table->number("height_m", grass.height_m, kHeight_m);
    grass.density_perm2 = table->number("density_perm2", grass.density_perm2, kDensity_perm2);
    grass.distance_m = table->number("distance_m", grass.distance_m, kDistance_m);
    table->finish();
    scene.grass = grass;
}

}  // namespace

Fidelity read_fidelity(TableReader& table) {
    constexpr std::array<std::string_view, 3> kNames{"draft", "balanced", "precise"};
    return static_cast<Fidelity>(
        table.choice("fidelity", static_cast<std::size_t>(Fidelity::Balanced), kNames));
}

void read_nature(TableReader& root, SceneDescription& scene, const LoadContext& context) {
    read_wind(root, scene, context);
    read_grass(root, scene);
    for (const auto& [node, path] : listed_tables(root, "flock")) {
        TableReader table(*node, path, root.faults());
        scene.flocks.push_back(read_flock(table));
    }
    for (const auto& [node, path] : listed_tables(root, "fountain")) {
        TableReader table(*node, path, root.faults());
        scene.fountains.push_back(read_fountain(table));
    }
}

}  // namespace plumbline::scene
