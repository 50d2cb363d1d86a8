#include "engine/input/bindings.h"
#include "engine/input/tuning_keys.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::input {
namespace {

std::string in_quotes(std::string_view word) {
    std::string quoted = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

/// The layers behind a list, its losses, and who else it shares an input with.
std::string comment_of(const Bindings& bindings, Action action) {
    const auto i = index_of(action);
    std::string comment = bindings.origin[i].empty() ? std::string{"unbound"} : bindings.origin[i];
    for (const std::string& note : bindings.notes[i]) comment += "; " + note;
    for (const Input& input : bindings.inputs[i]) {
        for (std::size_t j = 0; j < kActionCount; ++j) {
            const auto other = static_cast<Action>(j);
            const bool is_other_domain =
                (group_of(other) == ActionGroup::Menu) != (group_of(action) == ActionGroup::Menu);
            if (j == i || is_other_domain) continue;
            if (std::ranges::find(bindings.inputs[j], input) != bindings.inputs[j].end())
                comment += fmt::format("; \"{}\" also drives {}", input.word, action_name(other));
        }
    }
    return comment;
}

void print_tuning(std::string& text, const Tuning& tuning) {
    text += "\n[tuning]\n";
    for (const TuningKey& key : tuning_keys()) {
        if (key.flag != nullptr) {
            text += fmt::format("{} = {}\n", key.name, tuning.*key.flag);
        } else {
            text += fmt::format("{} = {}\n", key.name, tuning.*key.number);
        }
    }
}

void print_holds(std::string& text, const Bindings& bindings) {
    text += "\n[hold]\n";
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        const bool is_usual =
            action == Action::Crouch || action == Action::Sprint || action == Action::Grab;
        if (!is_usual && bindings.hold_mode[i] == HoldMode::Hold) continue;
        text += fmt::format("{} = \"{}\"\n",
                            action_name(action),
                            bindings.hold_mode[i] == HoldMode::Hold ? "hold" : "toggle");
    }
}

}  // namespace

std::string inputs_text(const std::vector<Input>& inputs) {
    std::string list;
    for (const Input& input : inputs) {
        if (!list.empty()) list += ", ";
        list += in_quotes(input.word);
    }
    return "[" + list + "]";
}

std::string print_bindings(const Bindings& bindings) {
    std::string text =
        "# What drives what, all layers together. Each line says which layer it comes from.\n"
        "format = 1\n";
    print_tuning(text, bindings.tuning);
    print_holds(text, bindings);
    std::string_view group;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (group_name(group_of(action)) != group) {
            group = group_name(group_of(action));
            text += fmt::format("\n[{}]\n", group);
        }
        const std::string line =
            fmt::format("{} = {}", action_name(action), inputs_text(bindings.inputs[i]));
        text += fmt::format("{:<56}  # {}\n", line, comment_of(bindings, action));
    }
    return text;
}

}  // namespace plumbline::input
