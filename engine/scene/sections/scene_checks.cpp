// What only the whole scene can tell: counts, names, groups, and what is not built yet.
#include "engine/core/limits.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kGroups = 32;  // bits of a filter mask

/// An entity, or an array's copies of its prefab.
struct Kind {
    const EntityDescription& entity;
    const SourceLocation& location;
    std::string path;
    std::uint64_t copies{1};
};

/// All that will stand in the scene.
std::vector<Kind> kinds_of(const SceneDescription& scene, const LoadContext& context) {
    std::vector<Kind> kinds;
    for (std::size_t i = 0; i < scene.entities.size(); ++i)
        kinds.push_back(
            {scene.entities[i], context.entity_locations[i], fmt::format("entity[{}]", i)});
    for (std::size_t i = 0; i < scene.arrays.size(); ++i)
        kinds.push_back({scene.arrays[i].prefab,
                         context.array_locations[i],
                         fmt::format("array[{}]", i),
                         copies_of(scene.arrays[i])});
    return kinds;
}

void check_counts(const SceneDescription& scene,
                  const std::vector<Kind>& kinds,
                  LoadContext& context) {
    std::uint64_t things = 0;
    std::uint64_t lights = 0;
    for (const Kind& kind : kinds) {
        things += kind.copies;
        if (kind.entity.light) lights += kind.copies;
        if (things <= limits::kBodies) continue;
        return context.faults.error(kind.location,
                                    kind.path,
                                    "brings the scene to {} things; at most {} are built",
                                    things,
                                    limits::kBodies);
    }
    if (scene.file.empty()) return;
    const SourceLocation whole = context.scene_location;
    if (things > limits::kBodiesWarn)
        context.faults.warning(
            whole, {}, "{} things; expect fewer than 30 frames a second", things);
    if (lights > limits::kLights)
        context.faults.warning(
            whole, {}, "{} lights; the nearest {} shine", lights, limits::kLights);
}

void check_groups(const std::vector<Kind>& kinds, LoadContext& context) {
    std::set<std::string> groups{"default"};
    for (const Kind& kind : kinds) {
        if (!kind.entity.body) continue;
        groups.insert(kind.entity.body->group);
        for (const BodyDescription& part : kind.entity.body->parts) groups.insert(part.group);
    }
    if (groups.size() > kGroups) {
        context.faults.error(context.scene_location,
                             {},
                             "{} collision groups; at most {} can be told apart",
                             groups.size(),
                             kGroups);
    }
    const std::vector<std::string_view> known(groups.begin(), groups.end());
    for (const Kind& kind : kinds) {
        if (!kind.entity.body) continue;
        for (const std::string& group : kind.entity.body->collides_with) {
            if (group == kNoGroup || groups.contains(group)) continue;
            context.faults.warning(kind.location,
                                   kind.path + ".body.collides_with",
                                   "no body is in group \"{}\"{}",
                                   shown(group),
                                   suggestion(group, known));
        }
    }
}

/// Solvers lose their grip where very unlike masses touch.
void check_mass_ratio(const std::vector<Kind>& kinds, LoadContext& context) {
    constexpr double kRatio = 1e4;
    const Kind* light = nullptr;
    const Kind* heavy = nullptr;
    const auto mass_of = [](const Kind& kind) {
        return static_cast<double>(*kind.entity.body->mass_kg);
    };
    for (const Kind& kind : kinds) {
        const auto& body = kind.entity.body;
        if (!body || body->kind != physics::BodyKind::Dynamic || !body->mass_kg) continue;
        if (light == nullptr || mass_of(kind) < mass_of(*light)) light = &kind;
        if (heavy == nullptr || mass_of(kind) > mass_of(*heavy)) heavy = &kind;
    }
    if (light == nullptr || mass_of(*heavy) <= mass_of(*light) * kRatio * 1.000001) return;
    const auto name_of = [](const Kind& kind) {
        return shown(kind.entity.name.empty() ? kind.path : kind.entity.name);
    };
    context.faults.warning(heavy->location,
                           {},
                           "\"{}\" weighs {:.3g} times as much as \"{}\" ({}); if they touch, the "
                           "lighter one may sink in",
                           name_of(*heavy),
                           mass_of(*heavy) / mass_of(*light),
                           name_of(*light),
                           to_string(light->location));
}

/// A name that nothing has never comes in. Things made in play are numbered: "crate#1".
void check_triggers(const SceneDescription& scene, LoadContext& context) {
    const auto has_trigger = [](const EntityDescription& e) { return e.trigger.has_value(); };
    if (std::ranges::none_of(scene.entities, has_trigger)) return;
    const SceneNames names(scene, context);
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const auto& trigger = scene.entities[i].trigger;
        if (!trigger) continue;
        const auto missing = [&](const char* key, const std::string& what) {
            context.faults.warning(context.entity_locations[i],
                                   fmt::format("entity[{}].trigger.{}", i, key),
                                   "no {}",
                                   what);
        };
        const auto called = [&names](const std::string& name) {
            const std::string hint = names.find(name) ? std::string() : names.hint(name);
            return fmt::format(" is called \"{}\"{}", shown(name), hint);
        };
        for (const std::string& name : trigger->of) {
            if (!names.find(name) && name.find('#') == std::string::npos)
                missing("of", "entity" + called(name));
        }
        const auto light = names.find(trigger->light);
        if (!trigger->light.empty() && !(light && light->entity->light))
            missing("light", "entity with a light" + called(trigger->light));
        const auto is_named = [&trigger](const ExplosionDescription& charge) {
            return charge.name == trigger->explode;
        };
        if (!trigger->explode.empty() && std::ranges::none_of(scene.forces.explosions, is_named))
            missing("explode", fmt::format("explosion is called \"{}\"", shown(trigger->explode)));
    }
}

void check_ground(const std::vector<Kind>& kinds, LoadContext& context) {
    const auto stands = [](const Kind& kind) {
        return kind.entity.body && kind.entity.body->kind != physics::BodyKind::Dynamic;
    };
    if (std::ranges::none_of(kinds, stands))
        context.faults.warning(context.scene_location,
                               {},
                               "no static body: there is nothing for the player to stand on");
}

}  // namespace

void check_whole_scene(SceneDescription& scene, LoadContext& context) {
    const std::vector<Kind> kinds = kinds_of(scene, context);
    check_counts(scene, kinds, context);
    check_names(scene, context);
    check_groups(kinds, context);
    check_mass_ratio(kinds, context);
    check_triggers(scene, context);
    check_plaques(scene, context);
    if (scene.player) check_ground(kinds, context);
}

}  // namespace plumbline::scene
