// A running scene as fields of an archive, for saved games (entities first, then state) and the ghost.
#pragma once

#include "engine/scene/simulation.h"

#include <functional>
#include <string>

namespace plumbline::scene {

/// A thing of the game's that a saved game had: made again under this name. Null where there is no
/// such description.
using Remake = std::function<ecs::Entity(const std::string& description, const std::string& name)>;

/// Which entities there are. When read: those of the scene that were gone go, and what play had made
/// of the scene's prefabs, or `remake` of others, is made again, all under their old ids.
void serialize_entities(Simulation& simulation, Archive& archive, const Remake& remake);

/// Everything else that decides how the world goes on. When read: into a world with the same
/// entities; what fails leaves it fit only to be thrown away.
void serialize_state(Simulation& simulation, Archive& archive);

/// Where the scene's own bodies are and what they carry, without what play made: for a ghost. When
/// read: into a freshly built world; its definition becomes that of the archive.
void serialize_bodies_of_scene(Simulation& simulation, Archive& archive);

}  // namespace plumbline::scene
