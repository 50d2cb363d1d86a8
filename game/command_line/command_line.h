// What the program is told on its command line: the options that every command takes, and how a
// mistake in them is answered.
#pragma once

#include "engine/app/controls/live_bindings.h"
#include "engine/app/settings/app_config.h"
#include "engine/core/io/files.h"
#include "engine/core/process/exit_code.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library has it
class App;
}  // namespace CLI

namespace plumbline::game {

/// --config DIR --safe --bind action=key[,key] --profile NAME --no-sound --verbose --quiet
struct CommonOptions {
    std::filesystem::path config_folder;  ///< instead of the user's own
    bool safe{false};
    std::vector<std::string> binds;
    std::string profile;
    bool no_sound{false};
    bool verbose{false};
    bool quiet{false};
};

void add_common_options(CLI::App& app, CommonOptions& options);
void apply_log_level(const CommonOptions& options);

/// Where the user's own settings are: --config, else the XDG folder; empty with --safe.
std::filesystem::path user_settings_folder(const CommonOptions& options);
app::BindingsDef bindings_def(const CommonOptions& options, const DataFolders& folders);

/// A new name for what was given none: KIND/NAME_DATE_TIME_N, with `extension`, in the folder of the
/// user's data. The folder KIND is made.
Result<std::filesystem::path> default_output(const std::string& kind,
                                             const std::string& name,
                                             const std::string& extension);

/// "1280x720" to two numbers in 1…16384; false when it is none.
bool parse_size(const std::string& text, int& width, int& height);

}  // namespace plumbline::game
