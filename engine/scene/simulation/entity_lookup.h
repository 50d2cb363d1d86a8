// Entities by the bodies and marks that physics knows them by, and what people call them.
#pragma once

#include "engine/scene/simulation.h"

#include <cstdint>
#include <string>

namespace plumbline::scene {

/// Entity of a body, or null.
ecs::Entity entity_of(const Simulation& simulation, physics::BodyId body);
/// As entity_of, from the mark that hits and contact events carry.
ecs::Entity entity_of_mark(const Simulation& simulation, std::uint64_t user);
/// What the entity of a mark is covered by, in surfaces(); 0, the plain one, where it says nothing.
std::uint16_t surface_of_mark(const Simulation& simulation, std::uint64_t user);
/// "cube", or "player" for a body that is no entity's.
std::string name_of_mark(const Simulation& simulation, std::uint64_t user);
/// "entity fountain (garden.toml:120)"; things made in play have no place in a file.
std::string describe(const Simulation& simulation, ecs::Entity entity);

}  // namespace plumbline::scene
