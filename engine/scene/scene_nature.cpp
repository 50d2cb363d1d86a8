// [wind], [[fountain]] and [effects.fountain].
#include "engine/scene/scene_parts.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace plumbline::scene {
namespace {

constexpr std::size_t kFountains = 64;
constexpr std::size_t kPools = 64;
constexpr int kStreams = 256;
constexpr Range kJetSpeed_mps{0, 100, "metres a second from 0 to 100"};
constexpr Range kJetSpread_deg{0, 89, "degrees from 0 to 89"};
constexpr Range kFlow_lps{0, 1e4, "litres a second from 0 to 10000"};
constexpr Range kDrop_mm{0.1, 100, "millimetres from 0.1 to 100"};

std::vector<PoolDescription> read_pools(TableReader& fountain) {
    const auto nodes = fountain.tables("pools");
    if (nodes.size() > kPools) {
        fountain.error("pools", fmt::format("{} pools; at most {} are kept", nodes.size(), kPools));
        return {};
    }
    std::vector<PoolDescription> pools;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        TableReader table(
            nodes[i], fmt::format("{}[{}]", fountain.path_of("pools"), i), fountain.faults());
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
    fountain.origin = origin_of(table.place());
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

void read_wind(TableReader& root, SceneDescription& scene) {
    auto table = root.table("wind");
    if (!table) return;
    constexpr Range kSpeed_mps{0, 1000, "metres a second from 0 to 1000"};
    constexpr Range kGustSize_m{0.5, 1000, "a length from 0.5 to 1000 m"};
    WindDescription wind;
    wind.origin = origin_of(table->place());
    const Vec3 direction(table->direction("direction", Vec3d(wind.direction)));
    if (std::hypot(direction.x, direction.z) < 1e-6_r)
        table->error("direction", "is upright; expected a direction along the ground");
    wind.direction = normalize_or(Vec3{direction.x, 0, direction.z}, wind.direction);
    wind.speed_mps = table->number("speed_mps", wind.speed_mps, kSpeed_mps);
    wind.gusts = table->number("gusts", wind.gusts, kFraction);
    wind.gust_size_m = table->number("gust_size_m", wind.gust_size_m, kGustSize_m);
    table->finish();
    scene.wind = wind;
}

}  // namespace

Fidelity read_fidelity(TableReader& table) {
    constexpr std::array<std::string_view, 3> kNames{"draft", "balanced", "precise"};
    return static_cast<Fidelity>(
        table.choice("fidelity", static_cast<std::size_t>(Fidelity::Balanced), kNames));
}

void read_nature(TableReader& root, SceneDescription& scene) {
    read_wind(root, scene);
    const auto nodes = root.tables("fountain");
    if (nodes.size() > kFountains) {
        root.error("fountain",
                   fmt::format("{} fountains; at most {} are kept", nodes.size(), kFountains));
        return;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        TableReader table(nodes[i], fmt::format("fountain[{}]", i), root.faults());
        scene.fountains.push_back(read_fountain(table));
    }
}

}  // namespace plumbline::scene
