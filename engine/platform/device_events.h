// Collects what devices report between two polls and hands it over as one InputSnapshot. Knows no
// window library, so that its rules can be tested: bounded queue, whole wheel notches, no cursor
// jumps, stalls noticed.
#pragma once

#include "engine/core/input_snapshot.h"

#include <cstdint>
#include <string>

namespace plumbline::platform {

/// A gamepad as the window library reports it.
struct PadReading {
    bool present{false};
    std::bitset<kPadButtonCount> buttons;
    std::array<float, kPadAxisCount> axes{};
};

class DeviceEvents {
public:
    static constexpr double kStall_s = 0.25;
    static constexpr double kJump_counts = 4'000.0;   ///< one report above it is dropped
    static constexpr std::size_t kMaxEvents = 1'024;  ///< a poll; later presses are dropped
    static constexpr int kMaxNotches = 32;            ///< a poll and direction

    void on_key(int code, bool pressed);  ///< unknown keys are -1 and only an event
    void on_mouse_button(int button, bool pressed);
    void on_scroll(double right, double up);
    void on_cursor(double x, double y);  ///< window library's coordinates
    void on_focus(bool focused);
    void on_iconify(bool iconified);
    void on_close() { close_requested_ = true; }
    void on_drop(std::string file);

    /// While captured, cursor positions are motion; the first after a change is only a start.
    void set_captured(bool captured);
    /// Framebuffer pixels per cursor unit.
    void set_pixel_ratio(double x, double y) { pixel_ratio_ = {x, y}; }

    /// True when more than kStall_s went by since the last take().
    bool is_stalled(double now_s) const { return taken_once_ && now_s - last_take_s_ > kStall_s; }
    /// After a stall: what is really down. Everything else is released by events of its own, and
    /// the next snapshot is no stalled one.
    void confirm_down(const std::bitset<kKeyCount>& keys,
                      const std::bitset<kMouseButtonCount>& buttons);

    /// Everything since the last call. `now_s` is compared with the last call's to notice stalls.
    InputSnapshot take(double now_s, const PadReading& pad);

    std::uint64_t jumps_dropped() const { return jumps_dropped_; }

private:
    void push(const DeviceEvent& event, bool& press_dropped);
    void push_notches(double& pending, int positive_code, int negative_code);
    void follow_pad(const PadReading& pad);

    InputSnapshot next_;
    std::bitset<kKeyCount> key_press_dropped_;
    std::bitset<kMouseButtonCount> button_press_dropped_;
    std::bitset<kPadButtonCount> pad_buttons_;
    std::array<double, 2> scroll_pending_{};
    std::array<double, 2> cursor_{};
    std::array<double, 2> pixel_ratio_{1.0, 1.0};
    std::uint64_t jumps_dropped_{0};
    double last_take_s_{0.0};
    bool taken_once_{false};
    bool captured_{false};
    bool cursor_known_{false};
    bool focused_{true};
    bool iconified_{false};
    bool lost_focus_{false};
    bool confirmed_{false};
    bool close_requested_{false};
};

}  // namespace plumbline::platform
