// `plumbline explain`, `controls` and `check`: what a scene calls for, what the keys do, what is
// wrong with a file.
#pragma once

#include "game/command_line/command_line.h"

#include <string>
#include <vector>

namespace plumbline::game {

/// Runs one simulated second (and one image, where GL is to be had), then prints the ledger.
ExitCode run_explain(const std::string& scene, bool as_json);
ExitCode run_controls(const CommonOptions& common);
/// One line for each fault of each scene or config file; 0 clean, 2 config faults, 4 scene faults.
ExitCode run_check(const std::vector<std::filesystem::path>& files);

}  // namespace plumbline::game
