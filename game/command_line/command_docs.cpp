#include "game/command_line/command_docs.h"

#include "engine/core/text/text_case.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace plumbline::game {
namespace {

// What no option says: where things are and how the program ends. The codes are exit_code.h's.
constexpr std::string_view kFilesAndCodes = R"(.SH FILES
.TP
.I $XDG_CONFIG_HOME/plumbline, ~/.config/plumbline
User settings and controls. Where a file is missing, the shipped settings apply.
.TP
.I $XDG_DATA_HOME/plumbline, ~/.local/share/plumbline
Screenshots, videos, saved games, recordings and user scenes.
.TP
.I $XDG_CACHE_HOME/plumbline, ~/.cache/plumbline
Cached studies of scenes. Safe to delete.
.TP
.I ../share/plumbline
Relative to the program: the shipped scenes, models, sounds, shaders and settings.
.SH ENVIRONMENT
.TP
.B PLUMBLINE_DATA
Folder of the shipped files, same as \fB\-\-data\fR.
.TP
.B XDG_CONFIG_HOME, XDG_DATA_HOME, XDG_CACHE_HOME
Base folders. Empty or relative values are ignored.
.SH EXIT STATUS
.TP
.B 0
success
.TP
.B 1
run-time failure
.TP
.B 2
invalid option or setting
.TP
.B 3
no display, or no usable OpenGL
.TP
.B 4
invalid scene, model or other input file
.TP
.B 5
a hash or another expectation did not match
.TP
.B 6
out of memory
.TP
.B 130
interrupted
)";

struct Words {
    const CLI::Option* option;
    std::vector<std::string> spelled;  ///< with their dashes; empty for a positional one
    bool takes_value;
};

/// Those shown in --help, in that order; --help itself only once, as the program's.
std::vector<Words> options_of(const CLI::App& command) {
    std::vector<Words> all;
    for (const CLI::Option* option : command.get_options()) {
        const bool repeated = option == command.get_help_ptr() && command.get_parent() != nullptr;
        if (repeated || option->get_group().empty()) continue;
        Words words{
            .option = option, .spelled = {}, .takes_value = option->get_items_expected_max() > 0};
        for (const std::string& name : option->get_snames()) words.spelled.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) words.spelled.push_back("--" + name);
        all.push_back(words);
    }
    return all;
}

/// Those shown in --help.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands(
        [](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> dashed_words(const CLI::App& command, bool only_with_value) {
    std::vector<std::string> found;
    for (const Words& words : options_of(command)) {
        if (only_with_value && !words.takes_value) continue;
        found.insert(found.end(), words.spelled.begin(), words.spelled.end());
    }
    return found;
}

/// Every option that a value follows, of the program and its commands, each once.
std::vector<std::string> all_with_value(const CLI::App& app) {
    std::vector<std::string> found = dashed_words(app, true);
    for (const CLI::App* command : commands_of(app)) {
        const std::vector<std::string> more = dashed_words(*command, true);
        found.insert(found.end(), more.begin(), more.end());
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
    return names;
}

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (std::size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
    return text;
}

/// Text as roff takes it literally: backslash and dash escaped, no control line by accident.
std::string roff(std::string text) {
    text = replaced(replaced(std::move(text), "\\", "\\e"), "-", "\\-");
    if (text.starts_with('.') || text.starts_with('\'')) text.insert(0, "\\&");
    return text;
}

/// "[scene]", "files ...": what stands where, without options.
std::string positionals(const CLI::App& command) {
    std::string line;
    for (const Words& words : options_of(command)) {
        if (!words.spelled.empty()) continue;
        std::string name = words.option->get_name(true);
        if (words.option->get_items_expected_max() > 1) name += " ...";
        line += words.option->get_required() ? " " + name : " [" + name + "]";
    }
    return line;
}

std::string man_options(const CLI::App& command) {
    std::string page;
    for (const Words& words : options_of(command)) {
        const std::string name = words.spelled.empty()
                                     ? words.option->get_name(true)
                                     : fmt::format("{}", fmt::join(words.spelled, ", "));
        const std::string value =
            words.spelled.empty() || !words.takes_value
                ? ""
                : fmt::format(" \\fI{}\\fR", roff(words.option->get_type_name()));
        page += fmt::format(
            ".TP\n\\fB{}\\fR{}\n{}\n", roff(name), value, roff(words.option->get_description()));
    }
    return page;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
    const std::string& name = app.get_name();
    std::string upper = name;
    for (char& letter : upper) letter = to_upper(letter);
    // "Plumbline: a playground" is how --help begins; a page's first line names the program anyway.
    std::string is = app.get_description();
    if (const std::size_t colon = is.find(": "); colon != std::string::npos) is.erase(0, colon + 2);
    std::string page = fmt::format(
        ".TH {} 1 \"\" \"{}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n"
        ".B {}\n[\\fIoptions\\fR] \\fIcommand\\fR [\\fIoptions\\fR] ...\n.SH DESCRIPTION\n{}.\n"
        "An option may stand before or behind the command.\n.SH OPTIONS\n",
        roff(upper),
        version,
        roff(name),
        roff(is),
        roff(name),
        roff(app.get_description()));
    page += man_options(app) + ".SH COMMANDS\n";
    for (const CLI::App* command : commands_of(app)) {
        page += fmt::format(".SS {}{}\n{}.\n",
                            roff(command->get_name()),
                            roff(positionals(*command)),
                            roff(command->get_description()));
        page += man_options(*command);
    }
    return page.append(kFilesAndCodes);
}

std::string bash_completion(const CLI::App& app) {
    const std::string& name = app.get_name();
    const std::string function = "_" + replaced(name, "-", "_");
    const std::vector<std::string> commands = command_names(app);
    std::string script = fmt::format(
        "# bash completion of {0}, written by {0} itself\n{1}() {{\n"
        "    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} word "
        "command=\n"
        "    local words='{2} {3}'\n"
        "    case $before in {4})\n"
        "        mapfile -t COMPREPLY < <(compgen -f -- \"$current\"); return ;;\n    esac\n"
        "    for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
        "        case $word in {5}) command=$word; break ;; esac\n    done\n    case $command in\n",
        name,
        function,
        fmt::join(commands, " "),
        fmt::join(dashed_words(app, false), " "),
        fmt::join(all_with_value(app), " | "),
        fmt::join(commands, " | "));
    for (const CLI::App* command : commands_of(app)) {
        script += fmt::format("        {}) words='{} {}' ;;\n",
                              command->get_name(),
                              fmt::join(dashed_words(*command, false), " "),
                              fmt::join(dashed_words(app, false), " "));
    }
    script += fmt::format(
        "    esac\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n"
        "    [[ $current == -* ]] || mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -f -- "
        "\"$current\")\n"
        "}}\ncomplete -o filenames -F {} {}\n",
        function,
        name);
    return script;
}

}  // namespace plumbline::game
