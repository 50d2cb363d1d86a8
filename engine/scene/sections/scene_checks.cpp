// What only the whole scene can tell: counts, names, groups, and what is not built yet.
#include "engine/core/limits.h"
#include "engine/core/text/nearest_name.h"
#include "engine/scene/sections/scene_names.h"
#include "engine/scene/sections/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace plumbline::scene {
namespace {

constexpr std::size_t kGroups = 32;  // bits of a filter mask

/// Calls visit(entity, place, path, copies) for all that will stand in the scene.
template <class Visit>
void for_each_kind(const SceneDescription& scene, const LoadContext& context, Visit visit) {
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        visit(scene.entities[i],
              context.entity_locations[i],
              fmt::format("entity[{}]", i),
              std::uint64_t{1});
    }
    for (std::size_t i = 0; i < scene.arrays.size(); ++i) {
        visit(scene.arrays[i].prefab,
              context.array_locations[i],
              fmt::format("array[{}]", i),
              copies_of(scene.arrays[i]));
    }
}

void check_counts(const SceneDescription& scene, LoadContext& context) {
    std::uint64_t things = 0;
    std::uint64_t lights = 0;
    bool refused = false;
    for_each_kind(scene,
                  context,
                  [&](const EntityDescription& entity,
                      const SourceLocation& location,
                      const std::string& path,
                      auto n) {
                      things += n;
                      if (entity.light) lights += n;
                      if (things <= limits::kBodies || refused) return;
                      refused = true;
                      context.faults.error(location,
                                           path,
                                           "brings the scene to {} things; at most {} are built",
                                           things,
                                           limits::kBodies);
                  });
    if (refused || scene.file.empty()) return;
    const SourceLocation whole = context.scene_location;
    if (things > limits::kBodiesWarn)
        context.faults.warning(
            whole, {}, "{} things; expect fewer than 30 frames a second", things);
    if (lights > limits::kLights)
        context.faults.warning(
            whole, {}, "{} lights; the nearest {} shine", lights, limits::kLights);
}

void check_groups(const SceneDescription& scene, LoadContext& context) {
    std::set<std::string> groups{"default"};
    for_each_kind(
        scene, context, [&](const EntityDescription& entity, const auto&, const auto&, auto) {
            if (entity.body) groups.insert(entity.body->group);
        });
    if (groups.size() > kGroups) {
        context.faults.error(context.scene_location,
                             {},
                             "{} collision groups; at most {} can be told apart",
                             groups.size(),
                             kGroups);
    }
    std::vector<std::string_view> known(groups.begin(), groups.end());
    for_each_kind(scene,
                  context,
                  [&](const EntityDescription& entity,
                      const SourceLocation& location,
                      const std::string& path,
                      auto) {
                      if (!entity.body) return;
                      for (const std::string& group : entity.body->collides_with) {
                          if (group == kNoGroup || groups.contains(group)) continue;
                          context.faults.warning(location,
                                                 path + ".body.collides_with",
                                                 "no body is in group \"{}\"{}",
                                                 shown(group),
                                                 suggestion(group, known));
                      }
                  });
}

/// Solvers lose their grip where very unlike masses touch.
void check_mass_ratio(const SceneDescription& scene, LoadContext& context) {
    constexpr double kRatio = 1e4;
    struct Extreme {
        double mass_kg{0};
        std::string name;
        SourceLocation location{};
    };
    Extreme light;
    Extreme heavy;
    for_each_kind(
        scene,
        context,
        [&](const EntityDescription& entity,
            const SourceLocation& location,
            const auto& path,
            auto) {
            if (!entity.body || entity.body->kind != physics::BodyKind::Dynamic ||
                !entity.body->mass_kg)
                return;
            const auto mass_kg = static_cast<double>(*entity.body->mass_kg);
            const Extreme here{mass_kg, entity.name.empty() ? path : entity.name, location};
            if (light.mass_kg == 0 || mass_kg < light.mass_kg) light = here;
            if (mass_kg > heavy.mass_kg) heavy = here;
        });
    if (light.mass_kg == 0 || heavy.mass_kg <= light.mass_kg * kRatio * 1.000001) return;
    context.faults.warning(heavy.location,
                           {},
                           "\"{}\" weighs {:.3g} times as much as \"{}\" ({}); if they touch, the "
                           "lighter one may sink in",
                           shown(heavy.name),
                           heavy.mass_kg / light.mass_kg,
                           shown(light.name),
                           to_string(light.location));
}

/// A name that nothing has never comes in. Things made in play are numbered: "crate#1".
void check_triggers(const SceneDescription& scene, LoadContext& context) {
    const auto has_trigger = [](const EntityDescription& e) { return e.trigger.has_value(); };
    if (std::ranges::none_of(scene.entities, has_trigger)) return;
    const SceneNames names(scene, context);
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const auto& trigger = scene.entities[i].trigger;
        if (!trigger) continue;
        for (const std::string& name : trigger->of) {
            if (names.find(name) || name.find('#') != std::string::npos) continue;
            context.faults.warning(context.entity_locations[i],
                                   fmt::format("entity[{}].trigger.of", i),
                                   "no entity is called \"{}\"{}",
                                   shown(name),
                                   names.hint(name));
        }
    }
}

void check_ground(const SceneDescription& scene, LoadContext& context) {
    if (!scene.player) return;
    bool stands = false;
    for_each_kind(
        scene, context, [&](const EntityDescription& entity, const auto&, const auto&, auto) {
            stands = stands || (entity.body && entity.body->kind != physics::BodyKind::Dynamic);
        });
    if (!stands)
        context.faults.warning(context.scene_location,
                               {},
                               "no static body: there is nothing for the player to stand on");
}

}  // namespace

void check_whole_scene(SceneDescription& scene, LoadContext& context) {
    check_counts(scene, context);
    check_names(scene, context);
    check_groups(scene, context);
    check_mass_ratio(scene, context);
    check_triggers(scene, context);
    check_ground(scene, context);
    if (context.not_built.empty()) return;
    context.faults.warning(context.not_built_location,
                           {},
                           "checked but not built yet: {}",
                           fmt::join(context.not_built, "; "));
}

}  // namespace plumbline::scene
