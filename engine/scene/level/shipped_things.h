// The things that may be put into any scene, which are those of assets/scenes/things.toml, and what play put there.
#pragma once

#include "engine/scene/simulation.h"

#include <filesystem>
#include <vector>

namespace plumbline::scene {

/// Its prefabs and materials; nothing where there is no such file or it cannot be read.
SceneDescription shipped_things(const std::filesystem::path& assets_folder);

/// What stands for a thing: of a prefab of its name, a body that moves.
EntityDescription thing_of(const EntityDescription& prefab, std::string_view name);

/// What play made of prefabs and is whole: without parts of models and fragments.
std::vector<MovingBody> things_made_in_play(const Simulation& simulation);

}  // namespace plumbline::scene
