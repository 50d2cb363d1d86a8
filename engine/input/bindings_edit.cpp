#include "engine/input/bindings_edit.h"

#include "engine/input/modifier_keys.h"
#include "engine/input/stick.h"
#include "engine/input/tuning_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace plumbline::input {
namespace {

constexpr float kPushed = 0.7F;  // of an axis' travel, when a press is waited for
constexpr float kAtRest = 0.3F;

std::vector<Input>& inputs_of(Bindings& bindings, Action action) {
    return bindings.inputs[index_of(action)];
}

}  // namespace

void put_input(Bindings& bindings, Action action, std::size_t slot, const Input& input) {
    for (const Action other : also_drives(bindings, input, action))
        std::erase(inputs_of(bindings, other), input);
    std::vector<Input>& inputs = inputs_of(bindings, action);
    const auto there = std::ranges::find(inputs, input);
    if (there != inputs.end()) {
        // It drives this action already: the slot that was to change gives way to it.
        if (slot < inputs.size() && there != inputs.begin() + static_cast<std::ptrdiff_t>(slot))
            inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(slot));
        return;
    }
    if (slot < inputs.size()) {
        inputs[slot] = input;
    } else {
        inputs.push_back(input);
    }
}

void remove_input(Bindings& bindings, Action action, std::size_t slot) {
    std::vector<Input>& inputs = inputs_of(bindings, action);
    if (slot < inputs.size()) inputs.erase(inputs.begin() + static_cast<std::ptrdiff_t>(slot));
}

void reset_action(Bindings& bindings, const Bindings& below, Action action) {
    std::vector<Input> inputs = below.of(action);
    std::erase_if(
        inputs, [&](const Input& input) { return !also_drives(bindings, input, action).empty(); });
    inputs_of(bindings, action) = std::move(inputs);
    const auto i = index_of(action);
    bindings.hold_mode[i] = below.hold_mode[i];
}

void reset_group(Bindings& bindings, const Bindings& below, ActionGroup group) {
    const auto of_group = [&](const std::function<void(Action)>& what) {
        for (std::size_t i = 0; i < kActionCount; ++i)
            if (group_of(static_cast<Action>(i)) == group) what(static_cast<Action>(i));
    };
    // Emptied first, so that inputs exchanged within the group find their way back.
    of_group([&](Action action) { inputs_of(bindings, action).clear(); });
    of_group([&](Action action) { reset_action(bindings, below, action); });
}

bool same_inputs(const Bindings& a, const Bindings& b, Action action) {
    return a.of(action) == b.of(action);
}

std::string ui_bindings_text(const Bindings& below, const Bindings& wanted) {
    std::string text =
        "# Written by Plumbline's controls pages. Your own lines belong in bindings.toml beside\n"
        "# it, which the program never writes; this file is laid over it.\n"
        "format = 1\n";
    const auto add = [&](std::string_view& table, std::string_view group, std::string line) {
        if (table != group) text += fmt::format("\n[{}]\n", group);
        table = group;
        text += std::move(line) + '\n';
    };
    std::string_view table;
    for (const TuningKey& key : tuning_keys()) {
        if (key.flag != nullptr && below.tuning.*key.flag != wanted.tuning.*key.flag)
            add(table, "tuning", fmt::format("{} = {}", key.name, wanted.tuning.*key.flag));
        if (key.number != nullptr && below.tuning.*key.number != wanted.tuning.*key.number)
            add(table, "tuning", fmt::format("{} = {}", key.name, wanted.tuning.*key.number));
    }
    for (std::size_t i = 0; i < kActionCount; ++i) {
        if (below.hold_mode[i] == wanted.hold_mode[i]) continue;
        const bool holds = wanted.hold_mode[i] == HoldMode::Hold;
        add(table,
            "hold",
            fmt::format(
                "{} = \"{}\"", action_name(static_cast<Action>(i)), holds ? "hold" : "toggle"));
    }
    for (std::size_t i = 0; i < kActionCount; ++i) {
        const auto action = static_cast<Action>(i);
        if (same_inputs(below, wanted, action)) continue;
        add(table,
            group_name(group_of(action)),
            fmt::format("{} = {}", action_name(action), inputs_text(wanted.inputs[i])));
    }
    return text;
}

PressCapture::State PressCapture::take_event(const DeviceEvent& event) {
    const bool is_key = event.kind == DeviceEventKind::Key;
    const bool is_known_key = is_key && event.code >= 0 && event.code < kKeyCount;
    if (is_known_key) keys_down_[static_cast<std::size_t>(event.code)] = event.pressed;
    if (!event.pressed) {
        if (!is_key || event.code != lone_modifier_) return State::Waiting;
        taken_ = input_of(DeviceKind::Key, event.code, 0, 0);
        return taken_ ? State::Taken : State::Waiting;
    }
    if (is_key && event.code == kEscapeKey) return State::Cancelled;
    if (is_key && modifier_of(event.code) != 0) {
        lone_modifier_ = event.code;
        return State::Waiting;
    }
    lone_modifier_ = -1;
    const bool is_pad = event.kind == DeviceEventKind::PadButton;
    const std::uint8_t modifiers = is_pad ? std::uint8_t{0} : modifiers_down(keys_down_);
    taken_ = input_of(device_of(event.kind), event.code, 0, modifiers);
    return taken_ ? State::Taken : State::Waiting;
}

PressCapture::State PressCapture::take_axes(const InputSnapshot& input) {
    if (!input.pad_present) return State::Waiting;
    for (std::size_t axis = 0; axis < input.pad_axes.size(); ++axis) {
        const bool is_trigger = axis >= kTriggerAxis;
        const float value = input.pad_axes[axis];
        const float travel = is_trigger ? trigger_travel(value) : std::abs(value);
        if (travel < kAtRest) axis_at_rest_[axis] = true;
        if (travel < kPushed || !axis_at_rest_[axis]) continue;
        const int direction = is_trigger || value > 0.0F ? 1 : -1;
        taken_ = input_of(DeviceKind::PadAxis, static_cast<int>(axis), direction, 0);
        if (taken_) return State::Taken;
    }
    return State::Waiting;
}

PressCapture::State PressCapture::take(const InputSnapshot& input) {
    for (const DeviceEvent& event : input.events) {
        const State state = take_event(event);
        if (state != State::Waiting) return state;
    }
    return take_axes(input);
}

}  // namespace plumbline::input
