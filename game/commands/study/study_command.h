// `plumbline study`: what accuracy costs, by scenarios whose outcome is known or in a scene.
#pragma once

#include "engine/core/process/exit_code.h"
#include "engine/study/findings/findings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}  // namespace CLI

namespace plumbline::game {

struct StudyOptions {
    std::vector<std::string> cases;  ///< ids of scenarios or their beginnings, or scenes; none: all
    std::filesystem::path out;       ///< folder of findings.json, findings.csv and report.html
    std::optional<study::Shard> shard{};       ///< its runs only
    std::vector<std::filesystem::path> merge;  ///< folders of shards: nothing is run
    bool quick{false};
    bool quiet{false};
    bool list{false};
    bool effects{false};
    bool image{false};
    int jobs{0};                      ///< 0: as many as there are cores
    std::filesystem::path load_file;  ///< a saved game of the one scene; empty: from its start
    std::string camera;               ///< of --picture; empty: the scene's own
    std::optional<double> seconds{};
    std::optional<double> tolerance{};
    std::optional<double> budget_ms{};
    std::string engines;  ///< names with commas between them
    std::vector<int> threads;
    std::string command;  ///< the command line, for the report
};

CLI::App* add_study(CLI::App& app, StudyOptions& options);
ExitCode run_study(const StudyOptions& options);

}  // namespace plumbline::game
