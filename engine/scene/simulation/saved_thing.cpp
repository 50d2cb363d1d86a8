#include "engine/scene/simulation/saved_thing.h"

#include "engine/scene/build/fragments.h"

#include <algorithm>

namespace plumbline::scene {
namespace {

Made made_of(const ecs::Registry& registry, ecs::Entity entity) {
    const auto* ref = registry.find<BodyRef>(entity);
    return {.entity = entity, .body = ref != nullptr ? ref->body : physics::BodyId{}};
}

}  // namespace

std::vector<Made> all_of(const ecs::Registry& registry, ecs::Entity entity) {
    std::vector<Made> made{made_of(registry, entity)};
    const auto* bodies = registry.find<PartBodies>(entity);
    if (bodies == nullptr) return made;
    for (const PartBodies::Part& part : bodies->parts) {
        if (registry.alive(part.entity)) made.push_back(made_of(registry, part.entity));
    }
    return made;
}

SavedThing saved_thing(const Simulation& simulation, ecs::Entity entity) {
    const ecs::Registry& registry = simulation.registry;
    SavedThing saved{.made = all_of(registry, entity),
                     .description = registry.get<Spawned>(entity).description,
                     .name = registry.get<Name>(entity).text,
                     .is_dropped = registry.has<Dropped>(entity)};
    const auto* fragile = registry.find<Fragile>(entity);
    if (fragile == nullptr) return saved;
    const FragileWhole& whole = *simulation.wholes()[fragile->whole];
    if (fragile->pieces.size() == whole.pattern.pieces.size()) return saved;
    saved.whole = whole.name;
    saved.pieces = fragile->pieces;
    return saved;
}

bool reserve(Simulation& simulation, const std::vector<Made>& made) {
    return std::all_of(made.rbegin(), made.rend(), [&](const Made& one) {
        return simulation.registry.reserve(one.entity) &&
               (!one.body || simulation.physics.reserve_body(one.body));
    });
}

}  // namespace plumbline::scene
