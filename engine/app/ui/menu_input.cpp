#include "engine/app/ui/menu_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace plumbline::app::ui {
namespace {

constexpr double kFirstRepeat_s = 0.4;
constexpr double kRepeat_s = 0.07;
constexpr float kStickOut = 0.55F;

// GLFW's codes.
struct FixedKey {
    int code;
    MenuPress press;
};
constexpr std::array<FixedKey, 11> kKeys{{{265, MenuPress::Up},
                                          {264, MenuPress::Down},
                                          {263, MenuPress::Left},
                                          {262, MenuPress::Right},
                                          {266, MenuPress::PageUp},
                                          {267, MenuPress::PageDown},
                                          {257, MenuPress::Accept},  // Enter
                                          {335, MenuPress::Accept},  // Enter on the keypad
                                          {32, MenuPress::Accept},
                                          {kEscapeKey, MenuPress::Back},
                                          {261, MenuPress::Remove}}};
constexpr std::array<FixedKey, 4> kPadButtons{
    {{11, MenuPress::Up}, {12, MenuPress::Right}, {13, MenuPress::Down}, {14, MenuPress::Left}}};

bool drives(const input::Bindings& bindings, Action action, const DeviceEvent& event) {
    using input::DeviceKind;
    constexpr std::array kKinds{
        DeviceKind::Key, DeviceKind::MouseButton, DeviceKind::Wheel, DeviceKind::PadButton};
    return std::ranges::any_of(bindings.of(action), [&](const input::Input& input) {
        return input.modifiers == 0 && input.code == event.code &&
               input.kind == kKinds[static_cast<std::size_t>(event.kind)];
    });
}

template <std::size_t N>
std::optional<MenuPress> fixed(const std::array<FixedKey, N>& keys, int code) {
    const auto found = std::ranges::find(keys, code, &FixedKey::code);
    if (found == keys.end()) return std::nullopt;
    return found->press;
}

std::optional<MenuPress> arrow_held(const InputSnapshot& input, bool& stick_is_out) {
    for (std::size_t i = 0; i < 6; ++i)  // arrows and pages only
        if (input.keys[static_cast<std::size_t>(kKeys[i].code)]) return kKeys[i].press;
    for (const FixedKey& button : kPadButtons)
        if (input.pad_present && input.pad_buttons[static_cast<std::size_t>(button.code)])
            return button.press;
    const float x = input.pad_present ? input.pad_axes[0] : 0.0F;
    const float y = input.pad_present ? input.pad_axes[1] : 0.0F;
    stick_is_out = std::max(std::abs(x), std::abs(y)) > kStickOut;
    if (!stick_is_out) return std::nullopt;
    if (std::abs(x) > std::abs(y)) return x > 0.0F ? MenuPress::Right : MenuPress::Left;
    return y > 0.0F ? MenuPress::Down : MenuPress::Up;
}

}  // namespace

std::vector<MenuPress> MenuKeys::press_of(const DeviceEvent& event,
                                          const input::Bindings& bindings) {
    if (!event.pressed) return {};
    std::optional<MenuPress> press;
    if (event.kind == DeviceEventKind::Key) press = fixed(kKeys, event.code);
    if (event.kind == DeviceEventKind::PadButton) press = fixed(kPadButtons, event.code);
    if (event.kind == DeviceEventKind::MouseButton && event.code == 0) press = MenuPress::Click;
    if (event.kind == DeviceEventKind::MouseButton && event.code == 1) press = MenuPress::Back;
    if (event.kind == DeviceEventKind::Wheel && event.code < 2)
        press = event.code == 0 ? MenuPress::WheelUp : MenuPress::WheelDown;
    if (!press && drives(bindings, Action::Accept, event)) press = MenuPress::Accept;
    if (!press &&
        (drives(bindings, Action::BackOut, event) || drives(bindings, Action::Menu, event)))
        press = MenuPress::Back;
    if (!press) return {};
    return {*press};
}

std::vector<MenuPress> MenuKeys::repeats(const InputSnapshot& input) {
    bool stick_is_out = false;
    const std::optional<MenuPress> now = arrow_held(input, stick_is_out);
    std::vector<MenuPress> presses;
    if (stick_is_out && !stick_was_out_) presses.push_back(*now);
    stick_was_out_ = stick_is_out;
    if (!now) {
        held_since_s_ = -1.0;
        return presses;
    }
    if (held_since_s_ < 0.0 || *now != held_) {
        held_ = *now;
        held_since_s_ = input.now_s;
        repeated_ = 0;
    }
    const double beyond_s = input.now_s - held_since_s_ - kFirstRepeat_s;
    const int due = beyond_s < 0.0 ? 0 : 1 + static_cast<int>(beyond_s / kRepeat_s);
    for (; repeated_ < due; ++repeated_) presses.push_back(held_);
    return presses;
}

bool opens_menu(const DeviceEvent& event, const input::Bindings& bindings) {
    if (!event.pressed) return false;
    const bool escape = event.kind == DeviceEventKind::Key && event.code == kEscapeKey;
    return escape || drives(bindings, Action::Menu, event);
}

bool opens_help(const DeviceEvent& event, const input::Bindings& bindings) {
    return event.pressed && drives(bindings, Action::Help, event);
}

}  // namespace plumbline::app::ui
