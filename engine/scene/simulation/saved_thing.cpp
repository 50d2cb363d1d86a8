#include "engine/scene/simulation/saved_thing.h"

#include "engine/scene/build/fragments.h"
#include "engine/scene/simulation/entity_lookup.h"

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

SavedRope saved_rope(const Simulation& simulation, std::size_t rope) {
    const RopeDescription& description = simulation.description().forces.ropes[rope];
    SavedRope saved{.name = description.name,
                    .ends = {.names = {description.a, description.b},
                             .anchors_world_m = {description.anchor_a_m, description.anchor_b_m}},
                    .pieces = {}};
    for (const physics::BodyId piece : simulation.ropes()[rope].pieces) {
        const bool is_there = simulation.physics.contains(piece);
        saved.pieces.push_back(
            {.entity = is_there ? entity_of(simulation, piece) : ecs::Entity{}, .body = piece});
    }
    return saved;
}

bool is_of_tied_rope(const Simulation& simulation, ecs::Entity entity) {
    const auto* part = simulation.registry.find<PartOf>(entity);
    return part != nullptr && part->whole == PartOf::Whole::Rope &&
           simulation.ropes()[part->index].tied;
}

bool reserve(Simulation& simulation, const std::vector<Made>& made) {
    return std::all_of(made.rbegin(), made.rend(), [&](const Made& one) {
        return simulation.registry.reserve(one.entity) &&
               (!one.body || simulation.physics.reserve_body(one.body));
    });
}

}  // namespace plumbline::scene
