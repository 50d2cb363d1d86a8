// `plumbline export`: a scene as a glTF file with physics.
#pragma once

#include "engine/core/process/exit_code.h"

#include <filesystem>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}

namespace plumbline::game {

struct ExportOptions {
    std::string scene;
    std::filesystem::path out;
    std::filesystem::path load;  ///< a saved game to begin from; empty: the scene's start
};

CLI::App* add_export(CLI::App& app, ExportOptions& options);
/// Says on standard error what the file lacks.
ExitCode run_export(const ExportOptions& options);

}  // namespace plumbline::game
