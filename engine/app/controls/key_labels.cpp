#include "engine/app/controls/key_labels.h"

#include "engine/core/text/text_case.h"
#include "engine/platform/window.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace plumbline::app {
namespace {

using input::DeviceKind;
using input::Input;

std::string capitalised(std::string text) {
    for (char& letter : text) {
        if (letter == '_') letter = ' ';
    }
    if (!text.empty()) text[0] = to_upper(text[0]);
    return text;
}

std::string without_modifiers(const std::string& word) {
    const std::size_t plus = word.rfind('+');
    return plus == std::string::npos || plus + 1 == word.size() ? word : word.substr(plus + 1);
}

struct PadName {
    std::string_view word;
    std::string_view label;
};
// A pad's buttons by place, with the letters that most pads print; sticks by where they are pushed.
constexpr auto kPadNames = std::to_array<PadName>({{"pad.a", "South (A)"},
                                                   {"pad.b", "East (B)"},
                                                   {"pad.x", "West (X)"},
                                                   {"pad.y", "North (Y)"},
                                                   {"pad.left_thumb", "Left stick pressed"},
                                                   {"pad.right_thumb", "Right stick pressed"},
                                                   {"pad.left_x-", "Left stick left"},
                                                   {"pad.left_x+", "Left stick right"},
                                                   {"pad.left_y-", "Left stick up"},
                                                   {"pad.left_y+", "Left stick down"},
                                                   {"pad.right_x-", "Right stick left"},
                                                   {"pad.right_x+", "Right stick right"},
                                                   {"pad.right_y-", "Right stick up"},
                                                   {"pad.right_y+", "Right stick down"},
                                                   {"pad.dpad_up", "Pad up"},
                                                   {"pad.dpad_right", "Pad right"},
                                                   {"pad.dpad_down", "Pad down"},
                                                   {"pad.dpad_left", "Pad left"},
                                                   {"pad.back", "Pad Back"},
                                                   {"pad.start", "Pad Start"},
                                                   {"pad.guide", "Pad Guide"}});

std::string pad_label(const std::string& word) {
    const auto* const named = std::ranges::find(kPadNames, word, &PadName::word);
    if (named != kPadNames.end()) return std::string(named->label);
    return capitalised(word.substr(word.find('.') + 1));
}

bool on_pad(const Input& input) {
    return input.kind == DeviceKind::PadButton || input.kind == DeviceKind::PadAxis ||
           input.kind == DeviceKind::PadStick;
}

}  // namespace

std::string label_of(const Input& input) {
    std::string label;
    if ((input.modifiers & input::kCtrl) != 0) label += "Ctrl+";
    if ((input.modifiers & input::kShift) != 0) label += "Shift+";
    if ((input.modifiers & input::kAlt) != 0) label += "Alt+";
    if ((input.modifiers & input::kSuper) != 0) label += "Super+";
    const std::string word = without_modifiers(input.word);
    switch (input.kind) {
        case DeviceKind::Key: {
            const std::string printed = platform::printed_key_name(input.code);
            return label + capitalised(printed.empty() ? word : printed);
        }
        case DeviceKind::Label:
            return label + capitalised(std::string(1, input.label));
        case DeviceKind::MouseButton:
            return label + capitalised(word.substr(word.find('.') + 1)) + " mouse";
        case DeviceKind::MouseMove:
            return label + "Mouse";
        case DeviceKind::Wheel:
            return label + "Wheel " + word.substr(word.find('.') + 1);
        case DeviceKind::PadButton:
        case DeviceKind::PadAxis:
        case DeviceKind::PadStick:
            return label + pad_label(word);
    }
    return label + word;
}

std::string hint_for(const input::Bindings& bindings, Action action, input::LastDevice device) {
    const bool want_pad = device == input::LastDevice::Gamepad;
    for (const Input& input : bindings.of(action)) {
        if (on_pad(input) == want_pad) return label_of(input);
    }
    return bindings.of(action).empty() ? std::string(kUnbound)
                                       : label_of(bindings.of(action).front());
}

std::string all_labels(const input::Bindings& bindings, Action action, bool with_pad) {
    std::string text;
    for (const Input& input : bindings.of(action)) {
        if (on_pad(input) && !with_pad) continue;
        if (!text.empty()) text += " or ";
        text += label_of(input);
    }
    return text.empty() ? std::string(kUnbound) : text;
}

std::string walk_labels(const input::Bindings& bindings, input::LastDevice device) {
    std::string text;
    for (const Action each : {Action::Forward, Action::Left, Action::Back, Action::Right})
        text += (text.empty() ? "" : " ") + hint_for(bindings, each, device);
    return text;
}

}  // namespace plumbline::app
