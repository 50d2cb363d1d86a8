// Keys, a mouse and a pad, played by hand in tests.
#pragma once

#include "engine/core/math.h"
#include "engine/input/action_latch.h"

#include <gtest/gtest.h>

namespace plumbline::input {

inline constexpr int kEscape = 256;
inline constexpr int kF3 = 292;
inline constexpr int kLeftShift = 340;
inline constexpr int kRightShift = 344;
inline constexpr int kLeftControl = 341;
inline constexpr double kFrame_s = 1.0 / 60.0;

/// Devices played by hand: what is pressed stays down until released.
class Hands {
public:
    explicit Hands(std::string_view file = {})
        : latch(load_bindings({{"bindings.toml", std::string{file}}}, {}, faults)) {
        next.pad_axes = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    }

    void key(int code, bool down) {
        next.keys[static_cast<std::size_t>(code)] = down;
        next.events.push_back({DeviceEventKind::Key, code, down});
    }
    void tap(int code) {
        key(code, true);
        key(code, false);
    }
    void button(int code, bool down) {
        next.buttons[static_cast<std::size_t>(code)] = down;
        next.events.push_back({DeviceEventKind::MouseButton, code, down});
    }
    void wheel(int code) { next.events.push_back({DeviceEventKind::Wheel, code, true}); }
    void pad_button(int code, bool down) {
        next.pad_present = true;
        next.events.push_back({DeviceEventKind::PadButton, code, down});
    }
    void frame(const InputFocus& focus = {}) {
        next.now_s += kFrame_s;
        latch.update(next, focus);
        next.events.clear();
        next.mouse_counts = {};
        next.lost_focus = false;
        next.stalled = false;
    }
    /// A pad with its axes at rest, so that they count from now on.
    void plug_pad() {
        next.pad_present = true;
        frame();
    }

    Diagnostics faults;
    ActionLatch latch;
    InputSnapshot next;
};

}  // namespace plumbline::input
