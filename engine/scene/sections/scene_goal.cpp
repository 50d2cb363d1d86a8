// [goal]: a small game.
#include "engine/scene/goal_names.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::scene {
namespace {

constexpr std::size_t kTextBytes = 200;

std::optional<Region> read_region(TableReader& goal, std::string_view key) {
    auto table = goal.table(key);
    if (!table) return {};
    for (const std::string_view corner : {"min_m", "max_m"}) {
        if (!table->has(corner)) table->error(corner, "missing; expected [x, y, z] in m");
    }
    Region region;
    region.min_m = table->vector("min_m", region.min_m, kCoordinate_m);
    region.max_m = table->vector("max_m", region.max_m, kCoordinate_m);
    if (glm::any(glm::lessThan(region.max_m, region.min_m)))
        table->error("max_m", "is less than min_m; expected the corner with the larger numbers");
    table->finish();
    return region;
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
        if (!array.prefab.body || !(array.name + ".").starts_with(*stem)) continue;
        std::uint64_t copies = 1;
        for (const int count : array.count) copies *= static_cast<std::uint64_t>(count);
        bodies += copies;
    }
    return bodies;
}

void read_things(TableReader& table,
                 GoalDescription& goal,
                 const SceneDescription& scene,
                 const LoadContext& context) {
    goal.things = table.texts("things");
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
        if (names.find(name)) {
            table.error("things", fmt::format("\"{}\" has no body", shown(name)));
            continue;
        }
        table.error("things",
                    fmt::format("no body is called \"{}\"{}", shown(name), names.hint(name)));
    }
    goal.count = table.integer("count", 0, 1, 50'000);
    if (bodies > 0 && static_cast<std::uint64_t>(goal.count) > bodies) {
        table.error(
            "count",
            fmt::format("{} of {} things; expected no more than there are", goal.count, bodies));
    }
}

}  // namespace

void read_goal(TableReader& root, SceneDescription& scene, LoadContext& context) {
    auto table = root.table("goal");
    if (!table) return;
    GoalDescription goal;
    goal.location = table->location();
    goal.text = table->text("text", {});
    if (goal.text.empty() || goal.text.size() > kTextBytes)
        table->error("text",
                     fmt::format("expected 1 to {} letters: what is to be done", kTextBytes));
    read_things(*table, goal, scene, context);
    goal.below_m = table->optional_number("below_m", kCoordinate_m);
    goal.inside = read_region(*table, "inside");
    goal.outside = read_region(*table, "outside");
    if (int{goal.below_m.has_value()} + int{goal.inside.has_value()} +
            int{goal.outside.has_value()} !=
        1)
        table->error("below_m", "expected one of below_m, inside and outside");
    constexpr Range kWithin_s{1, 36'000, "seconds from 1 to 36000"};
    if (const auto within_s = table->optional_number("within_s", kWithin_s))
        goal.within_s = static_cast<double>(*within_s);
    if (table->has("throws")) goal.throws = table->integer("throws", 1, 1, 10'000);
    goal.with = table->text("with", {});
    if (table->has("with") && !scene.prefabs.contains(goal.with)) {
        std::vector<std::string_view> known;
        for (const auto& [name, prefab] : scene.prefabs) known.push_back(name);
        table->error(
            "with",
            fmt::format(
                "no prefab is called \"{}\"{}", shown(goal.with), suggestion(goal.with, known)));
    }
    goal.hands_off = table->flag("hands_off", false);
    table->finish();
    scene.goal = std::move(goal);
}

}  // namespace plumbline::scene
