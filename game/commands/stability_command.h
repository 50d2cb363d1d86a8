// `plumbline stability`: runs the gallery of hard cases and says which solver holds which.
#pragma once

#include "engine/core/process/exit_code.h"
#include "engine/physics/physics_world.h"
#include "engine/study/findings/findings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}  // namespace CLI

namespace plumbline::game {

struct StabilityOptions {
    std::vector<std::string> cases;           ///< none: all of the tier
    std::optional<physics::Solver> solver{};  ///< none: all
    std::string engines;  ///< names with commas between them: beside the solvers
    std::string tier{"ci"};
    std::filesystem::path out;  ///< folder of stability.json and stability.html; empty: none
    int jobs{0};                ///< 0: as many as there are cores
    std::optional<study::Shard> shard{};       ///< its runs only
    std::vector<std::filesystem::path> merge;  ///< folders of shards: nothing is run
    bool rates{false};                         ///< at 30 and 240 Hz too
    bool images{true};
    bool expect_green{false};
    std::string command;  ///< the command line, for the page
};

CLI::App* add_stability(CLI::App& app, StabilityOptions& options);
ExitCode run_stability(const StabilityOptions& options);

}  // namespace plumbline::game
