// A saved game as a state that the runs of a study go on from.
#pragma once

#include "engine/study/scene_start.h"

#include <filesystem>

namespace plumbline::game {

/// Of the scene's own bodies, in a game saved in play or by `simulate --save`. Refused (exit code 4):
/// a game that cannot be gone on from, or of another scene.
Result<study::SceneStart> saved_start(const std::filesystem::path& saved_game,
                                      const std::filesystem::path& scene);

}  // namespace plumbline::game
