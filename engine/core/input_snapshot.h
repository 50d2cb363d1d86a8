// Keyboard, mouse and gamepad at one instant, and what happened since the instant before.
// Plain data: no GLFW.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>
#include <vector>

namespace plumbline {

inline constexpr int kKeyCount = 349;  ///< GLFW key codes 0…348
inline constexpr int kEscapeKey = 256;
inline constexpr int kMouseButtonCount = 8;
inline constexpr int kPadButtonCount = 15;  ///< GLFW_GAMEPAD_BUTTON_*
inline constexpr int kPadAxisCount = 6;     ///< GLFW_GAMEPAD_AXIS_*

enum class DeviceEventKind : std::uint8_t { Key, MouseButton, Wheel, PadButton };

/// A press or release, in the order it came. Wheel: one event per notch, `code` 0 up, 1 down,
/// 2 left, 3 right, always pressed.
struct DeviceEvent {
    DeviceEventKind kind{DeviceEventKind::Key};
    int code{0};  ///< GLFW's code; unknown keys are -1
    bool pressed{false};
};

struct InputSnapshot {
    double now_s{0};
    std::vector<DeviceEvent> events;  ///< since the last poll, in order; no auto-repeats
    std::bitset<kKeyCount> keys;      ///< down now
    std::bitset<kMouseButtonCount> buttons;
    std::array<double, 2>
        mouse_counts{};                 ///< relative motion since the last poll; +x right, +y down
    std::array<double, 2> cursor_px{};  ///< framebuffer pixels, when not captured
    bool pad_present{false};
    std::bitset<kPadButtonCount> pad_buttons;
    std::array<float, kPadAxisCount> pad_axes{};  ///< raw; triggers rest at -1
    bool focused{true};
    bool lost_focus{false};  ///< since the last poll: release everything
    bool stalled{false};     ///< more than 250 ms since the last poll: release everything
    bool close_requested{false};
    std::vector<std::string> dropped_files;
};

}  // namespace plumbline
