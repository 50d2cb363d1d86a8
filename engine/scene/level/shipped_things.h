// The things that may be put into any scene: what assets/scenes/things.toml has.
#pragma once

#include "engine/scene/scene_description.h"

#include <filesystem>

namespace plumbline::scene {

/// Its prefabs and materials; nothing where there is no such file or it cannot be read.
SceneDescription shipped_things(const std::filesystem::path& assets_folder);

/// What stands for a thing: of a prefab of its name, a body that moves.
EntityDescription thing_of(const EntityDescription& prefab, std::string_view name);

}  // namespace plumbline::scene
