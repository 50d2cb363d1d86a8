#include "game/command_line/command_line.h"

#include "engine/app/capture/screenshot.h"
#include "engine/core/io/output.h"
#include "engine/core/log.h"

#include <CLI/CLI.hpp>

#include <charconv>

namespace plumbline::game {
namespace {

bool parse_side(std::string_view text, int& side) {
    constexpr int kLargest = 16'384;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), side);
    return error == std::errc{} && end == text.data() + text.size() && side >= 1 &&
           side <= kLargest;
}

}  // namespace

void add_common_options(CLI::App& app, CommonOptions& options) {
    app.add_option(
           "--config", options.config_folder, "Settings folder, instead of ~/.config/plumbline")
        ->check(CLI::ExistingDirectory);
    app.add_flag("--safe", options.safe, "Use built-in settings only; ignore user files")
        ->excludes("--config");
    app.add_option("--bind", options.binds, "action=key[,key]; may be repeated")
        ->allow_extra_args(false);
    app.add_option(
        "--profile", options.profile, "Control profile from config/controls: book, nature, viewer");
    app.add_flag("--no-sound", options.no_sound, "Disable sound");
    app.add_flag("--verbose", options.verbose, "Verbose output");
    app.add_flag("--quiet", options.quiet, "Print errors only")->excludes("--verbose");
}

void apply_log_level(const CommonOptions& options) {
    if (options.verbose) set_log_level(LogLevel::Debug);
    if (options.quiet) set_log_level(LogLevel::Error);
}

std::filesystem::path user_settings_folder(const CommonOptions& options) {
    if (options.safe) return {};
    return options.config_folder.empty() ? user_config_folder() : options.config_folder;
}

app::BindingsDef bindings_def(const CommonOptions& options, const DataFolders& folders) {
    return {.shipped_folder = folders.config,
            .user_folder = user_settings_folder(options),
            .profile = options.profile,
            .command_line = options.binds,
            .safe = options.safe};
}

Result<std::filesystem::path> default_output(const std::string& kind,
                                             const std::string& name,
                                             const std::string& extension) {
    const std::filesystem::path data = user_data_folder();
    if (data.empty()) {
        return Error{.message =
                         "no output folder: neither XDG_DATA_HOME nor HOME is set; use --out"};
    }
    const std::filesystem::path folder = data / kind;
    if (const Result<Done> made = make_output_folder(folder, {}); !made) return made.error();
    return app::unused_file(folder, name, extension);
}

bool parse_size(const std::string& text, int& width, int& height) {
    const std::size_t by = text.find('x');
    return by != std::string::npos && parse_side(std::string_view(text).substr(0, by), width) &&
           parse_side(std::string_view(text).substr(by + 1), height);
}

}  // namespace plumbline::game
