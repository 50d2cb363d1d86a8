// [[rope]]: read and checked.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kRopes = 256;
constexpr std::size_t kPathPoints = 256;
constexpr int kPieces = 400;
constexpr double kUnequal =
    1e-3;  // of the length: a rope that does not stretch is as long as its path

constexpr Range kLength{1e-2, 1e4, "a length from 0.01 to 10000 m"};
constexpr Range kRopeForce{0, 1e12, "a number from 0 to 1e12"};

void read_path(TableReader& table, std::vector<Vec3>& path) {
    const TomlNode* node = table.find("path_m");
    if (node == nullptr) return;
    const TomlArray* points = node->array();
    if (points == nullptr || points->size() < 2 || points->size() > kPathPoints)
        return table.error("path_m", "expected 2 to {} points [x, y, z] in m", kPathPoints);
    for (const TomlNode& point : *points) {
        const auto at = vector_of(point, table.path_of("path_m"), kCoordinate_m, table.faults());
        path.push_back(at ? Vec3(*at) : Vec3{0, 0, 0});
    }
}

/// Where the ends are, by the path, the keys or the entities.
void read_anchors(TableReader& table, RopeDescription& rope, const NamedEnd& a, const NamedEnd& b) {
    rope.anchor_a_m = !rope.path_m.empty() ? rope.path_m.front() : a.position_m;
    rope.anchor_b_m = !rope.path_m.empty() ? rope.path_m.back() : b.position_m;
    table.read("anchor_a_m", rope.anchor_a_m, kCoordinate_m);
    table.read("anchor_b_m", rope.anchor_b_m, kCoordinate_m);
    const bool has_path = !rope.path_m.empty();
    if (a.good && a.entity == nullptr && !has_path)
        table.require("anchor_a_m", "the point of the world that holds it");
    if (!rope.b.empty()) {
        if (b.good && b.entity == nullptr && !has_path)
            table.require("anchor_b_m", "the point of the world that holds it");
        return;
    }
    if (has_path) return;
    table.require("length_m", "the length of a rope with a free end, in m");
    if (!table.has("anchor_b_m"))
        rope.anchor_b_m = rope.anchor_a_m - Vec3{0, static_cast<Real>(rope.length_m), 0};
}

void check_length(TableReader& table, RopeDescription& rope) {
    const double way_m = rope.path_m.empty()
                             ? glm::distance(Vec3d(rope.anchor_a_m), Vec3d(rope.anchor_b_m))
                             : length_of(rope.path_m);
    if (!table.has("length_m")) rope.length_m = way_m;
    if (rope.length_m < kLength.min)
        return table.error("length_m", "{:g} m; expected {}", rope.length_m, kLength.expected);
    if (rope.stiffness_N > 0) return;
    const double shortest_m = way_m * (1 - kUnequal);
    if (rope.length_m < shortest_m)
        return table.error(
            "length_m",
            "{:g} m do not reach over {:g} m, and without stiffness_N it does not stretch",
            rope.length_m,
            way_m);
    if (!rope.path_m.empty() && rope.length_m > way_m * (1 + kUnequal))
        table.error("length_m",
                    "{:g} m, but its path_m is {:g} m long; leave one of the two out",
                    rope.length_m,
                    way_m);
}

void read_rope(TableReader& table, RopeDescription& rope, const SceneNames& names) {
    rope.name = read_name(table);
    table.require("a", "\"world\" or the name of an entity");
    const NamedEnd a = read_named_end(table, "a", names, rope.a, true);
    NamedEnd b;
    if (table.has("b")) b = read_named_end(table, "b", names, rope.b, true);
    if (a.good && b.good && rope.a == rope.b && a.entity != nullptr)
        table.error("b", "\"{}\" is at the other end already", shown(rope.b));
    read_path(table, rope.path_m);
    table.read("length_m", rope.length_m, kLength);
    table.read("damping_s", rope.damping_s, {0, 1e3, "a time from 0 to 1000 s"});
    table.read("radius_m", rope.radius_m, {1e-3, 10, "a length from 0.001 to 10 m"});
    table.read("mass_kg", rope.mass_kg, {1e-3, 1e6, "a mass from 0.001 to 1000000 kg"});
    table.read("stiffness_N", rope.stiffness_N, kRopeForce);
    table.read("bend_Nm2", rope.bend_Nm2, kRopeForce);
    table.read("friction", rope.friction, kGain);
    table.read("break_N", rope.break_N, kRopeForce);
    table.read("pieces", rope.pieces, 2, kPieces);
    table.read("material", rope.material);
    read_anchors(table, rope, a, b);
    if (a.good) check_length(table, rope);
}

}  // namespace

void read_ropes(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("rope");
    if (nodes.empty()) return;
    if (nodes.size() > kRopes) {
        root.error("rope", "{} of them; at most {} are built", nodes.size(), kRopes);
        return;
    }
    const SceneNames names(scene, context);
    root.read_tables("rope", scene.forces.ropes, read_rope, names);
    std::set<std::string> taken;
    name_each(root, "rope", scene.forces.ropes, names, taken, "another rope or entity");
}

}  // namespace plumbline::scene
