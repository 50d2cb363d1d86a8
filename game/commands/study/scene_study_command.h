// `plumbline study SCENE`: what accuracy costs in a scene, as a table or as the lines to paste.
#pragma once

#include "engine/core/process/exit_code.h"
#include "engine/core/result.h"
#include "engine/study/scenes/scene_text.h"

#include <filesystem>
#include <optional>

namespace plumbline::game {

struct SceneStudyCommand {
    std::filesystem::path scene{};      ///< a file
    std::filesystem::path load_file{};  ///< a saved game to continue from; empty: from the start
    std::optional<double> seconds{};
    std::vector<const study::EngineRow*> engines{};  ///< other engines, measured too
    std::vector<int> threads{};                      ///< numbers of them, measured too
    study::Wish
        wish{};  ///< with either of them: just the lines to paste, from the kept study if any
};

/// Prints to standard output, progress to standard error, and keeps the study for later. An
/// interrupted one is printed as far as it came, and not kept.
Result<study::SceneStudy> run_scene_study(const SceneStudyCommand& command);

}  // namespace plumbline::game
