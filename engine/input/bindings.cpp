#include "engine/input/bindings.h"

#include "engine/core/input_snapshot.h"
#include "engine/core/limits.h"
#include "engine/core/log.h"
#include "engine/input/bindings_layer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plumbline::input {
namespace {

bool is_escape(const Input& input) {
    return input.kind == DeviceKind::Key && input.code == kEscapeKey && input.modifiers == 0;
}

/// Bit 1: live in play, bit 2: live with a panel open. `menu` itself is live in both.
unsigned domain_of(Action action) {
    if (action == Action::Menu) return 3;
    return group_of(action) == ActionGroup::Menu ? 2 : 1;
}

bool share_domain(Action a, Action b) {
    return (domain_of(a) & domain_of(b)) != 0;
}

/// Escape may drive something else as well, but is never taken from the menu.
bool clash(const Input& a, Action action_a, const Input& b, Action action_b) {
    if (action_a == action_b || !(a == b) || !share_domain(action_a, action_b)) return false;
    return !(is_escape(a) && (action_a == Action::Menu || action_b == Action::Menu));
}

/// True where a press without a hold means nothing: what the wheel cannot do.
bool needs_holding(Action action, HoldMode mode) {
    switch (action) {
        case Action::Forward:
        case Action::Back:
        case Action::Left:
        case Action::Right:
        case Action::RotateHeld:
            return true;
        case Action::Crouch:
        case Action::Sprint:
        case Action::Grab:
            return mode == HoldMode::Hold;
        default:
            return false;
    }
}

std::string words_of(const std::vector<Input>& inputs) {
    if (inputs.empty()) return "nothing";
    std::vector<std::string_view> words;
    for (const Input& input : inputs) words.push_back(input.word);
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Why this input cannot drive this action; empty when it can.
std::string misfit(const Input& input, Action action, HoldMode mode) {
    const bool turns = input.kind == DeviceKind::MouseMove || input.kind == DeviceKind::PadStick;
    if (turns && action != Action::Look)
        return fmt::format(
            "\"{}\" can only drive \"look\", not \"{}\"", input.word, action_name(action));
    if (!turns && action == Action::Look)
        return fmt::format(
            "\"look\" is driven by mouse.move, pad.left_stick or pad.right_stick, not by \"{}\"",
            input.word);
    if (input.kind == DeviceKind::Wheel && needs_holding(action, mode))
        return fmt::format(
            "\"{}\" cannot be held down, and \"{}\" needs that", input.word, action_name(action));
    return {};
}

/// A message whose last words are what an action keeps: known only once every layer is laid.
struct Kept {
    Diagnostic fault;
    Action action;
};

/// Lays one layer over the table.
class Merge {
public:
    Merge(Bindings& bindings, std::string layer, std::vector<Kept>& reports)
        : bindings_(bindings), layer_(std::move(layer)), reports_(reports) {}

    void apply(const std::vector<LayerLine>& lines) {
        for (const LayerLine& line : lines) apply_line(line);
        for (const Accepted& entry : accepted_) take_from_others(entry);
    }

private:
    struct Accepted {
        Action action;
        Input input;
        SourceLocation location;
    };

    std::string origin_of(const SourceLocation& location) const {
        return location.line > 0 ? fmt::format("{}:{}", layer_, location.line) : layer_;
    }

    /// `message` ends where the words that `action` keeps follow.
    void report(Severity severity,
                const SourceLocation& location,
                std::string message,
                Action action) {
        reports_.push_back(
            {{severity, layer_, location.line, location.column, {}, std::move(message)}, action});
    }

    const Accepted* clashing(const Input& input, Action action) const {
        const auto found = std::ranges::find_if(accepted_, [&](const Accepted& other) {
            return clash(input, action, other.input, other.action);
        });
        return found == accepted_.end() ? nullptr : &*found;
    }

    /// Why this entry is refused; empty when it is good.
    std::string fault_of(const Input& input, Action action, const std::vector<Input>& taken) const {
        std::string fault = misfit(input, action, bindings_.hold_mode[index_of(action)]);
        if (!fault.empty()) return fault;
        if (std::ranges::find(taken, input) != taken.end())
            return fmt::format("\"{}\" stands twice in this list", input.word);
        if (const Accepted* other = clashing(input, action)) {
            const std::string place =
                other->location.line > 0 ? fmt::format("line {}", other->location.line) : layer_;
            return fmt::format("\"{}\" already drives \"{}\" ({}, same group)",
                               input.word,
                               action_name(other->action),
                               place);
        }
        if (taken.size() >= limits::kInputsPerAction)
            return fmt::format("\"{}\" is one too many: at most {} inputs for an action",
                               input.word,
                               limits::kInputsPerAction);
        return {};
    }

    void apply_line(const LayerLine& line) {
        std::vector<EntryFault> faults = line.faults;
        std::vector<Input> taken;
        std::vector<Accepted> accepted;
        for (const LocatedInput& entry : line.inputs) {
            std::string fault = fault_of(entry.input, line.action, taken);
            if (!fault.empty()) {
                faults.push_back({entry.location, std::move(fault)});
                continue;
            }
            taken.push_back(entry.input);
            taken.back().origin = origin_of(line.location);
            accepted.push_back({line.action, entry.input, line.location});
        }
        std::vector<Input>& kept = bindings_.inputs[index_of(line.action)];
        const bool is_unbound_on_purpose = line.inputs.empty() && line.faults.empty();
        const bool is_used = !taken.empty() || is_unbound_on_purpose;
        if (is_used) {
            kept = std::move(taken);
            bindings_.origin[index_of(line.action)] = origin_of(line.location);
            bindings_.notes[index_of(line.action)].clear();
            accepted_.insert(accepted_.end(), accepted.begin(), accepted.end());
        }
        for (const EntryFault& fault : faults)
            report(Severity::Error,
                   fault.location,
                   fmt::format("{}. {}; \"{}\" keeps: ",
                               with_action(fault.message, line.action),
                               is_used ? "This entry is left out" : "Line ignored",
                               action_name(line.action)),
                   line.action);
    }

    /// `unknown input "x"` becomes `unknown input "x" for action "jump"`.
    static std::string with_action(const std::string& message, Action action) {
        if (!message.starts_with("unknown input")) return message;
        const auto end = std::min(message.find(". Nearest"), message.size());
        return fmt::format("{} for action \"{}\"{}",
                           message.substr(0, end),
                           action_name(action),
                           message.substr(end));
    }

    void take_from_others(const Accepted& entry) {
        for (std::size_t i = 0; i < kActionCount; ++i) {
            const auto other = static_cast<Action>(i);
            const bool is_mine = std::ranges::any_of(
                accepted_, [&](const Accepted& a) { return a.action == other; });
            if (is_mine) continue;  // clashes within a layer are settled already
            std::vector<Input>& inputs = bindings_.inputs[i];
            const auto gone = std::ranges::find_if(inputs, [&](const Input& input) {
                return clash(entry.input, entry.action, input, other);
            });
            if (gone == inputs.end()) continue;
            const std::string from = gone->origin;
            inputs.erase(gone);
            bindings_.notes[i].push_back(fmt::format("\"{}\" taken by {} ({})",
                                                     entry.input.word,
                                                     action_name(entry.action),
                                                     origin_of(entry.location)));
            report(Severity::Warning,
                   entry.location,
                   fmt::format("\"{}\" now drives \"{}\" and no longer \"{}\" ({}), which keeps: ",
                               entry.input.word,
                               action_name(entry.action),
                               action_name(other),
                               from),
                   other);
        }
    }

    Bindings& bindings_;
    std::string layer_;
    std::vector<Kept>& reports_;
    std::vector<Accepted> accepted_;
};

/// Whoever holds the pointer must always be able to let it go.
void keep_escape(Bindings& bindings) {
    std::vector<Input>& menu = bindings.inputs[index_of(Action::Menu)];
    if (std::ranges::any_of(menu, is_escape)) return;
    menu.insert(
        menu.begin(),
        Input{.kind = DeviceKind::Key, .code = kEscapeKey, .word = "escape", .origin = "built-in"});
    bindings.notes[index_of(Action::Menu)].emplace_back("escape always opens the menu");
}

/// A layer may turn an action to "hold" that a lower one bound to the wheel.
void drop_wheels_that_cannot_hold(Bindings& bindings, Diagnostics& faults) {
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (!needs_holding(action, bindings.hold_mode[i])) continue;
        std::erase_if(bindings.inputs[i], [&](const Input& input) {
            if (input.kind != DeviceKind::Wheel) return false;
            faults.add_error(input.origin,
                             fmt::format("{}. This entry is left out",
                                         misfit(input, action, bindings.hold_mode[i])));
            return true;
        });
    }
}

}  // namespace

std::vector<Action> also_drives(const Bindings& bindings, const Input& input, Action action) {
    std::vector<Action> others;
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto other = static_cast<Action>(i);
        const auto clashes = [&](const Input& theirs) {
            return clash(input, action, theirs, other);
        };
        if (std::ranges::any_of(bindings.inputs[i], clashes)) others.push_back(other);
    }
    return others;
}

std::string why_not(const Bindings& bindings, const Input& input, Action action) {
    return misfit(input, action, bindings.hold_mode[index_of(action)]);
}

Bindings load_bindings(const std::vector<BindingLayer>& layers,
                       const std::vector<std::string>& command_line,
                       Diagnostics& faults) {
    Bindings bindings = built_in_bindings();
    std::vector<Kept> reports;
    for (const BindingLayer& layer : layers) {
        const std::optional<LayerContent> content = read_layer(layer, bindings.tuning, faults);
        if (!content) {
            bindings.left_out.push_back(layer.name);
            continue;
        }
        for (const std::string& alias : content->aliases) log_note("{}", alias);
        for (const LayerHold& hold : content->holds)
            bindings.hold_mode[index_of(hold.action)] = hold.mode;
        Merge(bindings, layer.name, reports).apply(content->lines);
    }
    std::vector<LayerLine> options;
    for (const std::string& option : command_line)
        if (std::optional<LayerLine> line = read_bind_option(option, faults))
            options.push_back(std::move(*line));
    Merge(bindings, "--bind", reports).apply(options);
    drop_wheels_that_cannot_hold(bindings, faults);
    keep_escape(bindings);
    for (Kept& report : reports) {
        report.fault.message += words_of(bindings.of(report.action));
        faults.add(std::move(report.fault));
    }
    return bindings;
}

}  // namespace plumbline::input
