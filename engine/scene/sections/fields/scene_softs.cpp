// [[soft]]: read and checked.
#include "engine/assets/model_import.h"
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kSofts = 64;
constexpr double kSoftCells = 20'000;  // more would take seconds a step

constexpr Range kSoftSize{1e-2, 1e3, "lengths from 0.01 to 1000 m"};

void read_soft_pin(TableReader& table, SoftPinDescription& pin, const SceneNames& names) {
    table.require("min_m", "[x, y, z] in m");
    table.require("max_m", "[x, y, z] in m");
    table.read("min_m", pin.min_m, kCoordinate_m);
    table.read("max_m", pin.max_m, kCoordinate_m);
    read_holder(table, names, pin.to);
}

void read_form(TableReader& table, SoftDescription& soft, const LoadContext& context) {
    if (table.either("model", "primitive") == "model") {
        const auto model = read_file_reference(
            table, "model", assets::kModelExtensions, "a box stands in for it", context);
        soft.form = SoftForm::Model;
        if (model) soft.model = model->file;
        if (model) soft.model_root = model->root;
        return;
    }
    auto primitive = table.table("primitive");
    if (!primitive)
        return table.error("primitive",
                           "expected {} or {}, or a model",
                           "{ box = [x, y, z] }",
                           "{ ellipsoid = [x, y, z] }");
    const std::string_view form = primitive->either("box", "ellipsoid");
    if (form.empty()) primitive->error("box", "expected box or ellipsoid, [x, y, z] in m");
    soft.form = form == "ellipsoid" ? SoftForm::Ellipsoid : SoftForm::Box;
    Vec3 size(soft.size_m);
    if (!form.empty()) primitive->read(form, size, kSoftSize);
    soft.size_m = Vec3d(size);
    primitive->finish();
}

void read_soft(TableReader& table,
               SoftDescription& soft,
               const SceneNames& names,
               const LoadContext& context) {
    soft.name = read_name(table);
    read_form(table, soft, context);
    soft.pose = read_pose(table);
    if (table.has("cell_m")) {
        table.read("cell_m", soft.cell_m.emplace(1), {1e-3, 1e3, "a length from 0.001 to 1000 m"});
        const Vec3d cells = soft.size_m / *soft.cell_m;
        if (soft.form != SoftForm::Model && cells.x * cells.y * cells.z > kSoftCells)
            table.error("cell_m",
                        "makes {:.0f} cells; at most {} are simulated",
                        cells.x * cells.y * cells.z,
                        kSoftCells);
    }
    table.read("density_kgpm3", soft.density_kgpm3, {1e-2, 1e5, "kg/m3 from 0.01 to 100000"});
    table.read("young_Pa", soft.young_Pa, {1e-1, 1e12, "Pa from 0.1 to 1e12"});
    table.read("poisson", soft.poisson, {0, 0.499, "a ratio from 0 to 0.499"});
    table.read("damping_s", soft.damping_s, {0, 1e3, "a time from 0 to 1000 s"});
    table.read("friction", soft.friction, kGain);
    table.read("material", soft.material);
    table.read_tables("pins", soft.pins, read_soft_pin, names);
}

}  // namespace

void read_softs(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const auto nodes = root.tables("soft");
    if (nodes.empty()) return;
    if (nodes.size() > kSofts)
        return root.error("soft", "{} of them; at most {} are built", nodes.size(), kSofts);
    const SceneNames names(scene, context);
    root.read_tables("soft", scene.forces.softs, read_soft, names, context);
    std::set<std::string> taken;
    for (const RopeDescription& rope : scene.forces.ropes) taken.insert(rope.name);
    for (const ClothDescription& cloth : scene.forces.cloths) taken.insert(cloth.name);
    name_each(
        root, "soft", scene.forces.softs, names, taken, "another soft body, cloth, rope or entity");
}

}  // namespace plumbline::scene
