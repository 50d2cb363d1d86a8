// [[change]]: how things of the scene begin otherwise than they are described.
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

namespace plumbline::scene {
namespace {

void read_change(TableReader& table, ChangeDescription& change, const SceneNames& names) {
    table.require("of", "the name of an entity with a body");
    const NamedEnd end = read_named_end(table, "of", names, change.of, false);
    if (table.has("frozen")) table.read("frozen", change.frozen.emplace());
    table.read("gone", change.gone);
    const bool is_moved = table.has("position_m");
    const auto turn = read_turn(table);
    if (!is_moved) {
        if (turn) table.error("position_m", "missing; expected where it is turned so");
        return;
    }
    Pose& pose = change.world_from_body.emplace();
    table.read("position_m", pose.position, kCoordinate_m);
    if (turn) {
        pose.orientation = *turn;
    } else if (end.entity != nullptr) {
        pose.orientation = end.entity->world_from_body.orientation;
    }
}

}  // namespace

void read_changes(TableReader& root, SceneDescription& scene, LoadContext& context) {
    const SceneNames names(scene, context);
    root.read_tables("change", scene.changes, read_change, names);
}

}  // namespace plumbline::scene
