// [goal]: a small game.
#include "engine/scene/goal_names.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

namespace plumbline::scene {
namespace {

constexpr std::size_t kTextBytes = 200;

void read_region(TableReader& table, Region& region) {
    for (const std::string_view corner : {"min_m", "max_m"})
        table.require(corner, "[x, y, z] in m");
    table.read("min_m", region.min_m, kCoordinate_m);
    table.read("max_m", region.max_m, kCoordinate_m);
    if (glm::any(glm::lessThan(region.max_m, region.min_m)))
        table.error("max_m", "is less than min_m; expected the corner with the larger numbers");
}

/// How many bodies a name means: one, or with ".*" all that begin so.
std::uint64_t bodies_named(const std::string& name,
                           const SceneDescription& scene,
                           const SceneNames& names) {
    const std::optional<std::string_view> stem = stem_of(name);
    if (!stem) {
        const auto found = names.find(name);
        return found && found->entity->body ? 1 : 0;
    }
    std::uint64_t bodies = 0;
    for (const EntityDescription& entity : scene.entities)
        bodies += entity.body && entity.name.starts_with(*stem) ? 1U : 0U;
    for (const ArrayDescription& array : scene.arrays) {
        if (array.prefab.body && (array.name + ".").starts_with(*stem)) bodies += copies_of(array);
    }
    return bodies;
}

void read_things(TableReader& table,
                 GoalDescription& goal,
                 const SceneDescription& scene,
                 const LoadContext& context) {
    table.read("things", goal.things);
    if (goal.things.empty()) {
        table.error("things", "missing; expected names of bodies, \"can.*\" for all that begin so");
        return;
    }
    const SceneNames names(scene, context);
    std::uint64_t bodies = 0;
    for (const std::string& name : goal.things) {
        const std::uint64_t found = bodies_named(name, scene, names);
        bodies += found;
        if (found > 0) continue;
        if (names.find(name))
            table.error("things", "\"{}\" has no body", shown(name));
        else
            table.error("things", "no body is called \"{}\"{}", shown(name), names.hint(name));
    }
    table.read("count", goal.count, 1, 50'000);
    if (bodies > 0 && static_cast<std::uint64_t>(goal.count) > bodies)
        table.error(
            "count", "{} of {} things; expected no more than there are", goal.count, bodies);
}

void read_whole_goal(TableReader& table,
                     GoalDescription& goal,
                     const SceneDescription& scene,
                     const LoadContext& context) {
    table.read("text", goal.text);
    if (goal.text.empty() || goal.text.size() > kTextBytes)
        table.error("text", "expected 1 to {} letters: what is to be done", kTextBytes);
    table.read("triggers", goal.triggers);
    if (goal.triggers) {
        table.read("count", goal.count, 1, 50'000);
        table.require("count", "how often triggers that count must have been come into");
    } else {
        read_things(table, goal, scene, context);
    }
    table.read("below_m", goal.below_m, kCoordinate_m);
    table.read_table("inside", goal.inside, read_region);
    table.read_table("outside", goal.outside, read_region);
    if (int{goal.below_m.has_value()} + int{goal.inside.has_value()} +
            int{goal.outside.has_value()} + int{goal.triggers} !=
        1)
        table.error("below_m", "expected one of below_m, inside, outside and triggers");
    table.read("holds_s", goal.holds_s, {0.1, 600, "seconds from 0.1 to 600"});
    table.read("within_s", goal.within_s, {1, 36'000, "seconds from 1 to 36000"});
    table.read("throws", goal.throws, 1, 10'000);
    table.read("with", goal.with);
    if (table.has("with") && !scene.prefabs.contains(goal.with)) {
        const std::string hint = suggestion(goal.with, scene.prefabs);
        table.error("with", "no prefab is called \"{}\"{}", shown(goal.with), hint);
    }
    table.read("hands_off", goal.hands_off);
}

}  // namespace

void read_goal(TableReader& root, SceneDescription& scene, LoadContext& context) {
    root.read_table("goal", scene.goal, read_whole_goal, scene, context);
}

}  // namespace plumbline::scene
