#include "game/command_line/parse_error.h"

#include "engine/core/text/nearest_name.h"
#include "engine/core/text/printable.h"

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

/// What was typed, short enough to be read.
std::string shortened(const std::string& text) {
    constexpr std::size_t kShownBytes = 60;
    return text.size() <= kShownBytes ? text : text.substr(0, kShownBytes) + "...";
}

std::string command_names(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        const bool is_hidden = command->get_group().empty();
        if (!is_hidden) names += (names.empty() ? "" : ", ") + command->get_name();
    }
    return names;
}

std::string about_unknown(const CLI::App& app, const std::string& word) {
    if (!word.starts_with('-')) {
        return "unexpected word \"" + shortened(word) + "\"; the commands are " +
               command_names(app);
    }
    const std::vector<std::string> words = known_words(app);
    const std::vector<std::string_view> views(words.begin(), words.end());
    return "unknown option \"" + shortened(word) + "\"" + nearest_words(word, views);
}

}  // namespace

ExitCode answer_parse_error(const CLI::App& app, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        app.exit(error);  // --help and --version
        return ExitCode::Good;
    }
    constexpr std::size_t kLineBytes = 400;
    const std::vector<std::string> unknown = app.remaining(true);
    const std::string line = unknown.empty() ? error.what() : about_unknown(app, unknown.front());
    const std::string& program = app.get_name();
    std::cerr << program << ": " << printable(line.substr(0, kLineBytes)) << "\n"
              << program << " --help lists commands and options\n";
    return ExitCode::BadUsage;
}

}  // namespace plumbline::game
