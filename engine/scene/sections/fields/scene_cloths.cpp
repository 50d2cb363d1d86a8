// [[cloth]]: read and checked.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <algorithm>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kCloths = 64;
constexpr int kCells = 1000;  // along a side
constexpr int kFolds = 100;
constexpr int kAllCells = 40'000;  // more would take seconds a step

constexpr Range kClothSize{1e-2, 1e3, "lengths from 0.01 to 1000 m"};
constexpr Range kClothStiffness{0, 1e9, "a number from 0 to 1e9"};
constexpr Range kShare{0, 1, "shares from 0 to 1"};

void read_pin(TableReader& table, ClothPinDescription& pin, const SceneNames& names) {
    read_holder(table, names, pin.to);
    if (!table.has("edge")) {
        table.require(
            "at",
            "[x, y], shares of the width from the left and of the height from the top; or an edge");
        if (const auto at = table.pair("at", kShare, "two shares from 0 to 1")) {
            const glm::dvec2 place{(*at)[0], (*at)[1]};
            pin.along = {place.x, place.y, place.x, place.y};
        }
        return;
    }
    enum class Edge : std::uint8_t { Top, Bottom, Left, Right } edge{};
    table.read_choice("edge", edge, {"top", "bottom", "left", "right"});
    constexpr std::array<std::array<double, 4>, 4> kEdges{
        {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 0, 0, 1}, {1, 0, 1, 1}}};
    pin.along = kEdges[static_cast<std::size_t>(edge)];
}

void read_cells(TableReader& table, ClothDescription& cloth) {
    const auto cells =
        table.pair("cells", {1, kCells, "whole numbers from 1 to 1000"}, "two whole numbers");
    if (!cells) return;
    cloth.cells = {static_cast<int>((*cells)[0]), static_cast<int>((*cells)[1])};
    for (std::size_t i = 0; i < 2; ++i) {
        if (static_cast<Real>((*cloth.cells)[i]) != (*cells)[i])
            table.error("cells", "expected two whole numbers");
    }
    const int all = (*cloth.cells)[0] * (*cloth.cells)[1];
    if (all > kAllCells)
        table.error("cells", "{} in all; at most {} are simulated", all, kAllCells);
}

void read_folds(TableReader& table, ClothDescription& cloth) {
    table.read("folds", cloth.folds, 0, kFolds);
    if (cloth.folds > 0) {
        table.require("gather", "the share of its width that the folds take up");
        if (cloth.cells && (*cloth.cells)[0] < 2 * cloth.folds)
            table.error(
                "folds", "{} of them need at least {} cells across", cloth.folds, 2 * cloth.folds);
    } else if (table.has("gather")) {
        table.error("gather", "a flat cloth has none; say folds too");
    }
    table.read("gather", cloth.gather, {0.1_r, 1, "a share from 0.1 to 1"});
}

void read_cloth(TableReader& table, ClothDescription& cloth, const SceneNames& names) {
    cloth.name = read_name(table);
    table.require("size_m", "[x, y] in m");
    if (const auto size = table.pair("size_m", kClothSize, "two lengths in m"))
        cloth.size_m = {static_cast<double>((*size)[0]), static_cast<double>((*size)[1])};
    cloth.pose = read_pose(table);
    read_cells(table, cloth);
    read_folds(table, cloth);
    table.read("density_kgpm2", cloth.density_kgpm2, {1e-3, 1e4, "kg/m2 from 0.001 to 10000"});
    table.read("stretch_Npm", cloth.stretch_Npm, {1e-3, 1e9, "N/m from 0.001 to 1e9"});
    if (table.has("shear_Npm"))
        table.read("shear_Npm", cloth.shear_Npm.emplace(0), kClothStiffness);
    table.read("bend_Nm", cloth.bend_Nm, kClothStiffness);
    table.read("thickness_m", cloth.thickness_m, {1e-4, 1, "a length from 0.0001 to 1 m"});
    table.read("friction", cloth.friction, kGain);
    table.read("damping_s", cloth.damping_s, {0, 1e3, "a time from 0 to 1000 s"});
    table.read("drag", cloth.drag, {0, 100, "a coefficient from 0 to 100"});
    table.read("self_collision", cloth.self_collision);
    table.read("asleep", cloth.asleep);
    table.read("tear_Npm", cloth.tear_Npm, kClothStiffness);
    table.read("material", cloth.material);
    table.read_tables("pins", cloth.pins, read_pin, names);
}

}  // namespace

void read_cloths(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("cloth");
    if (nodes.empty()) return;
    if (nodes.size() > kCloths)
        return root.error("cloth", "{} of them; at most {} are built", nodes.size(), kCloths);
    const SceneNames names(scene, context);
    root.read_tables("cloth", scene.forces.cloths, read_cloth, names);
    std::set<std::string> taken;
    for (const RopeDescription& rope : scene.forces.ropes) taken.insert(rope.name);
    name_each(root, "cloth", scene.forces.cloths, names, taken, "another cloth, rope or entity");
}

}  // namespace plumbline::scene
