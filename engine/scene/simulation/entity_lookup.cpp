#include "engine/scene/simulation/entity_lookup.h"

#include <fmt/format.h>

namespace plumbline::scene {

ecs::Entity entity_of(const Simulation& simulation, physics::BodyId body) {
    return simulation.physics.contains(body)
               ? entity_of_mark(simulation, simulation.physics.state(body).user)
               : ecs::Entity{};
}

ecs::Entity entity_of_mark(const Simulation& simulation, std::uint64_t user) {
    const ecs::Entity entity{static_cast<std::uint32_t>(user),
                             static_cast<std::uint32_t>(user >> 32U)};
    return simulation.registry.alive(entity) ? entity : ecs::Entity{};
}

std::uint16_t surface_of_mark(const Simulation& simulation, std::uint64_t user) {
    const ecs::Entity entity = entity_of_mark(simulation, user);
    if (!simulation.registry.alive(entity)) return 0;
    const auto* surface = simulation.registry.find<SurfaceRef>(entity);
    return surface == nullptr ? std::uint16_t{0} : surface->surface;
}

std::string name_of_mark(const Simulation& simulation, std::uint64_t user) {
    const ecs::Entity entity = entity_of_mark(simulation, user);
    return simulation.registry.alive(entity) ? simulation.registry.get<Name>(entity).text
                                             : "player";
}

std::string describe(const Simulation& simulation, ecs::Entity entity) {
    if (!simulation.registry.alive(entity)) return "a body of the game";
    const std::string& name = simulation.registry.get<Name>(entity).text;
    const DescribedAt* source = simulation.registry.find<DescribedAt>(entity);
    if (source == nullptr) return "entity " + name;
    return fmt::format("entity {} ({})", name, to_string(*source));
}

}  // namespace plumbline::scene
