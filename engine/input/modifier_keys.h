// Events of devices as bindings know them: which device, and which modifier a key is.
#pragma once

#include "engine/core/input_snapshot.h"
#include "engine/input/bindings.h"

#include <array>

namespace plumbline::input {

inline DeviceKind device_of(DeviceEventKind kind) {
    constexpr std::array kDevices{
        DeviceKind::Key, DeviceKind::MouseButton, DeviceKind::Wheel, DeviceKind::PadButton};
    return kDevices[static_cast<std::size_t>(kind)];
}

/// GLFW's codes.
struct ModifierKeys {
    Modifier modifier;
    std::size_t left;
    std::size_t right;
};
inline constexpr auto kModifierKeys = std::to_array<ModifierKeys>(
    {{kShift, 340, 344}, {kCtrl, 341, 345}, {kAlt, 342, 346}, {kSuper, 343, 347}});

/// The modifier that this key is; 0 for other keys.
inline std::uint8_t modifier_of(int key) {
    for (const ModifierKeys& each : kModifierKeys)
        if (key == static_cast<int>(each.left) || key == static_cast<int>(each.right))
            return each.modifier;
    return 0;
}

inline std::uint8_t modifiers_down(const std::bitset<kKeyCount>& keys) {
    unsigned down = 0;
    for (const ModifierKeys& each : kModifierKeys)
        if (keys[each.left] || keys[each.right]) down |= each.modifier;
    return static_cast<std::uint8_t>(down);
}

}  // namespace plumbline::input
