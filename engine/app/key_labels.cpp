#include "engine/app/key_labels.h"

#include "engine/platform/window.h"

#include <array>
#include <cctype>
#include <string_view>

namespace plumbline::app {
namespace {

using input::DeviceKind;
using input::Input;

std::string capitalised(std::string text) {
    for (char& letter : text) {
        if (letter == '_') letter = ' ';
    }
    if (!text.empty())
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

std::string without_modifiers(const std::string& word) {
    const std::size_t plus = word.rfind('+');
    return plus == std::string::npos || plus + 1 == word.size() ? word : word.substr(plus + 1);
}

// A pad's buttons by place, with the letters that most pads print.
std::string pad_label(const std::string& word) {
    constexpr std::array<std::array<std::string_view, 2>, 4> kByPlace{{{"pad.a", "South (A)"},
                                                                       {"pad.b", "East (B)"},
                                                                       {"pad.x", "West (X)"},
                                                                       {"pad.y", "North (Y)"}}};
    for (const auto& [name, place] : kByPlace) {
        if (word == name) return std::string(place);
    }
    return "pad " + capitalised(word.substr(word.find('.') + 1));
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
            return label + word.substr(word.find('.') + 1) + " mouse";
        case DeviceKind::MouseMove:
            return label + "mouse";
        case DeviceKind::Wheel:
            return label + "wheel " + word.substr(word.find('.') + 1);
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
    return bindings.of(action).empty() ? "unbound" : label_of(bindings.of(action).front());
}

std::string all_labels(const input::Bindings& bindings, Action action) {
    std::string text;
    for (const Input& input : bindings.of(action)) {
        if (!text.empty()) text += " or ";
        text += label_of(input);
    }
    return text.empty() ? "unbound" : text;
}

}  // namespace plumbline::app
