#include "game/parse_error.h"

#include "engine/core/nearest_name.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace plumbline::game {
namespace {

/// Option and command names that the person may have meant, across the commands in use.
std::vector<std::string> known_words(const CLI::App& app) {
    std::vector<std::string> words;
    const auto add_options = [&](const CLI::App& of) {
        for (const CLI::Option* option : of.get_options()) {
            for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
        }
    };
    add_options(app);
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->parsed()) add_options(*command);
    }
    return words;
}

}  // namespace

ExitCode answer_parse_error(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        app.exit(error);  // --help and --version
        return ExitCode::Good;
    }
    std::string line = error.what();
    const std::vector<std::string> unknown = app.remaining(true);
    if (!unknown.empty()) {
        line = "unknown option \"" + unknown.front() + "\"";
        const std::vector<std::string> words = known_words(app);
        const std::vector<std::string_view> views(words.begin(), words.end());
        const std::string_view nearest = nearest_name(unknown.front(), views);
        if (!nearest.empty()) line += "; the nearest is \"" + std::string(nearest) + "\"";
    }
    const std::string& program = app.get_name();
    std::cerr << program << ": " << line << "\n"
              << program << " --help lists commands and options\n";
    return ExitCode::BadUsage;
}

}  // namespace plumbline::game
