#include "engine/scene/level/shipped_things.h"

#include "engine/scene/build/fragments.h"
#include "engine/scene/scene_file.h"

#include <utility>

namespace plumbline::scene {

SceneDescription shipped_things(const std::filesystem::path& assets_folder) {
    const std::filesystem::path file = assets_folder / "scenes" / "things.toml";
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return {};
    Diagnostics faults;
    Result<SceneDescription> things = read_description(file, assets_folder, faults);
    return things ? std::move(*things) : SceneDescription{};
}

EntityDescription thing_of(const EntityDescription& prefab, std::string_view name) {
    EntityDescription thing = prefab;
    thing.name = name;
    if (!thing.body) thing.body.emplace();
    thing.body->kind = physics::BodyKind::Dynamic;
    return thing;
}

std::vector<MovingBody> things_made_in_play(const Simulation& simulation) {
    std::vector<MovingBody> things;
    const ecs::Registry& registry = simulation.registry;
    for (const MovingBody& moving : simulation.moving_bodies()) {
        if (registry.find<Spawned>(moving.entity) == nullptr ||
            registry.find<PartOf>(moving.entity) != nullptr ||
            !simulation.physics.contains(moving.body))
            continue;
        const auto* fragile = registry.find<Fragile>(moving.entity);
        if (fragile != nullptr && is_fragment(*simulation.wholes()[fragile->whole], *fragile))
            continue;
        things.push_back(moving);
    }
    return things;
}

}  // namespace plumbline::scene
