// The program `plumbline-f64`: `simulate` in double precision, for references and for the question
// what the precision changes.

#include "engine/core/log.h"
#include "engine/core/nearest_name.h"
#include "game/simulate_cli.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace plumbline::game {
namespace {

std::string nearest_option(const CLI::App& command, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* app : {command.get_parent(), &command}) {
        for (const CLI::Option* option : app->get_options()) {
            for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
        }
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return std::string(nearest_name(word, views));
}

ExitCode answer_parse_error(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        app.exit(error);  // --help and --version
        return ExitCode::Good;
    }
    std::string line = error.what();
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) {
        line = "unknown option \"" + unknown.front() + "\"";
        const std::string nearest =
            nearest_option(*app.get_subcommand("simulate"), unknown.front());
        if (!nearest.empty()) line += "; the nearest is \"" + nearest + "\"";
    }
    std::cerr << "plumbline-f64: " << line << "\nplumbline-f64 --help lists commands and options\n";
    return ExitCode::BadUsage;
}

int run_program(int argc, char** argv) {
    CLI::App app("Plumbline in double precision, without window or sound", "plumbline-f64");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    app.fallthrough();
    bool verbose = false;
    bool quiet = false;
    app.add_flag("--verbose", verbose, "Says more");
    app.add_flag("--quiet", quiet, "Says only what went wrong");
    SimulateOptions options;
    add_simulate(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return static_cast<int>(answer_parse_error(app, error));
    }
    if (verbose) set_log_level(LogLevel::Debug);
    if (quiet) set_log_level(LogLevel::Error);
    return static_cast<int>(run_simulate(options));
}

}  // namespace
}  // namespace plumbline::game

int main(int argc, char** argv) {
    return plumbline::game::run_program(argc, argv);
}
