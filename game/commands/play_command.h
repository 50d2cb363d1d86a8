// `plumbline play`: a scene in a window.
#pragma once

#include "game/command_line/command_line.h"

#include <optional>
#include <string>

namespace plumbline::game {

struct PlayOptions {
    std::string scene;  ///< empty: the one that was played last, and the start page
    std::string size;
    std::filesystem::path load;  ///< a saved game to go on from
    std::filesystem::path record;
    std::filesystem::path replay;
    std::filesystem::path report;
    std::filesystem::path camera_path;
    std::string level;             ///< of the image; empty: as the settings say
    std::optional<double> hour{};  ///< of the day, for the first scene
    std::optional<double> seconds{};
    std::optional<std::uint64_t> random_input{};
    std::optional<std::string> expect_hash{};
    std::string audio_device;
};

ExitCode run_play(const PlayOptions& options, const CommonOptions& common);

}  // namespace plumbline::game
