#include "game/command_line/program_words.h"

#include "engine/core/math.h"
#include "engine/study/machine.h"
#include "game/command_line/command_docs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace plumbline::game {
namespace {

/// A flag that prints something made from `app` and ends the program well.
void add_printing_flag(CLI::App& command, const char* flag, std::function<std::string()> text) {
    command.add_flag_callback(flag, [text = std::move(text)] {
        std::cout << text();
        throw CLI::Success();
    });
}

}  // namespace

std::string version_text() {
    return fmt::format("plumbline {} ({})", PL_VERSION, kPrecisionName);
}

void add_program_words(CLI::App& app) {
    app.footer(
        "Exit codes: 0 success, 1 failure, 2 invalid option or setting, 3 no display or OpenGL, "
        "4 invalid scene or file,\n5 hash or expectation mismatch, 6 out of memory, "
        "130 interrupted.");
    app.set_version_flag("--version",
                         fmt::format("{}\nBullet {} in {}, OpenGL 3.3 core\n{}: {}",
                                     version_text(),
                                     PL_BULLET_VERSION,
                                     kPrecisionName,
                                     study::build_text(),
                                     PL_BUILD_FLAGS),
                         "Print version, precision and build type");
    app.add_option_function<std::string>(
           "--data",
           [](const std::string& folder) {
               ::setenv("PLUMBLINE_DATA", std::filesystem::absolute(folder).c_str(), 1);
           },
           "Data folder with assets, shaders and config")
        ->check(CLI::ExistingDirectory);

    CLI::App* data =
        app.add_subcommand("help-data", "Print the manual page or shell completion")->group("");
    data->require_option(1);
    const std::string footer = fmt::format("plumbline {}", PL_VERSION);
    add_printing_flag(*data, "--man", [&app, footer] { return man_page(app, footer); });
    add_printing_flag(*data, "--bash", [&app] { return bash_completion(app); });
}

}  // namespace plumbline::game
