// "Adopt": a scene with the accuracy that was chosen in play.
#pragma once

#include "engine/core/result.h"
#include "engine/scene/paths/scene_list.h"
#include "engine/study/setting.h"

#include <filesystem>

namespace plumbline::app {

/// Writes NAME-adopted.toml, a scene that starts from this one (`[scene] base`) and says the setting
/// under [accuracy]: beside the scene, or among the user's, a folder that is made, where the scene is the
/// program's. Overwrites nothing: the next free number is taken. Returns where. Nothing is left where
/// it would not load as the same scene at that setting.
Result<std::filesystem::path> write_adopted_copy(const std::filesystem::path& scene,
                                                 const study::Setting& setting,
                                                 const scene::SceneFolders& folders);

}  // namespace plumbline::app
