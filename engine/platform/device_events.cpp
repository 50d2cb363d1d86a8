#include "engine/platform/device_events.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumbline::platform {

// A press that does not fit is dropped together with its release; a release whose press went in
// always fits, so that no key can stay down.
void DeviceEvents::push(const DeviceEvent& event, bool& press_dropped) {
    if (event.pressed) {
        press_dropped = next_.events.size() >= kMaxEvents;
        if (!press_dropped) next_.events.push_back(event);
    } else if (!std::exchange(press_dropped, false)) {
        next_.events.push_back(event);
    }
}

void DeviceEvents::on_key(int code, bool pressed) {
    bool dropped = false;
    if (code < 0 || code >= kKeyCount) {
        if (pressed) push({DeviceEventKind::Key, -1, true}, dropped);
        return;
    }
    const auto index = static_cast<std::size_t>(code);
    if (next_.keys[index] == pressed) return;  // auto-repeat, or a release of what is not down
    next_.keys[index] = pressed;
    dropped = key_press_dropped_[index];
    push({DeviceEventKind::Key, code, pressed}, dropped);
    key_press_dropped_[index] = dropped;
}

void DeviceEvents::on_mouse_button(int button, bool pressed) {
    if (button < 0 || button >= kMouseButtonCount) return;
    const auto index = static_cast<std::size_t>(button);
    if (next_.buttons[index] == pressed) return;
    next_.buttons[index] = pressed;
    bool dropped = button_press_dropped_[index];
    push({DeviceEventKind::MouseButton, button, pressed}, dropped);
    button_press_dropped_[index] = dropped;
}

void DeviceEvents::on_scroll(double right, double up) {
    if (!std::isfinite(right) || !std::isfinite(up)) return;
    const auto limit = static_cast<double>(kMaxNotches);
    scroll_pending_[0] = std::clamp(scroll_pending_[0] + right, -limit, limit);
    scroll_pending_[1] = std::clamp(scroll_pending_[1] + up, -limit, limit);
    push_notches(scroll_pending_[1], 0, 1);
    push_notches(scroll_pending_[0], 3, 2);
}

// Touchpads scroll by fractions: what is short of a notch waits for the rest.
void DeviceEvents::push_notches(double& pending, int positive_code, int negative_code) {
    bool dropped = false;
    while (std::abs(pending) >= 1.0) {
        const int code = pending > 0.0 ? positive_code : negative_code;
        push({DeviceEventKind::Wheel, code, true}, dropped);
        pending -= pending > 0.0 ? 1.0 : -1.0;
    }
}

void DeviceEvents::on_cursor(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    const double right = x - cursor_[0];
    const double down = y - cursor_[1];
    cursor_ = {x, y};
    // A free pointer that drags moves the view of those who look at something.
    if (!std::exchange(cursor_known_, true) || (!captured_ && next_.buttons.none())) return;
    // Window systems warp the pointer now and then; no mouse moves that far between two reports.
    if (std::abs(right) > kJump_counts || std::abs(down) > kJump_counts) {
        ++jumps_dropped_;
        return;
    }
    next_.mouse_counts[0] += right;
    next_.mouse_counts[1] += down;
}

void DeviceEvents::on_focus(bool focused) {
    focused_ = focused;
    if (!focused) lost_focus_ = true;
    cursor_known_ = false;
}

void DeviceEvents::on_iconify(bool iconified) {
    iconified_ = iconified;
    if (iconified) lost_focus_ = true;
}

void DeviceEvents::on_drop(std::string file) {
    constexpr std::size_t kMaxDropped = 64;
    if (next_.dropped_files.size() < kMaxDropped) next_.dropped_files.push_back(std::move(file));
}

void DeviceEvents::set_captured(bool captured) {
    if (captured_ == captured) return;
    captured_ = captured;
    cursor_known_ = false;
    next_.mouse_counts = {};
}

void DeviceEvents::confirm_down(const std::bitset<kKeyCount>& keys,
                                const std::bitset<kMouseButtonCount>& buttons) {
    for (int key = 0; key < kKeyCount; ++key)
        if (!keys[static_cast<std::size_t>(key)]) on_key(key, false);
    for (int button = 0; button < kMouseButtonCount; ++button)
        if (!buttons[static_cast<std::size_t>(button)]) on_mouse_button(button, false);
    confirmed_ = true;
}

void DeviceEvents::follow_pad(const PadReading& pad) {
    const std::bitset<kPadButtonCount> now =
        pad.present ? pad.buttons : std::bitset<kPadButtonCount>{};
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] == pad_buttons_[i]) continue;
        next_.events.push_back({DeviceEventKind::PadButton, static_cast<int>(i), now[i]});
    }
    pad_buttons_ = now;
    next_.pad_present = pad.present;
    next_.pad_buttons = now;
    for (std::size_t i = 0; i < next_.pad_axes.size(); ++i) {
        // Axes 4 and 5 are the triggers: they rest at -1.
        const float rest = i >= 4 ? -1.0F : 0.0F;
        const float value = pad.present ? pad.axes[i] : rest;
        next_.pad_axes[i] = std::isfinite(value) ? std::clamp(value, -1.0F, 1.0F) : rest;
    }
}

InputSnapshot DeviceEvents::take(double now_s, const PadReading& pad) {
    follow_pad(pad);
    next_.now_s = now_s;
    next_.focused = focused_ && !iconified_;
    next_.lost_focus = std::exchange(lost_focus_, false);
    next_.stalled = is_stalled(now_s) && !std::exchange(confirmed_, false);
    next_.close_requested = std::exchange(close_requested_, false);
    next_.cursor_px = {cursor_[0] * pixel_ratio_[0], cursor_[1] * pixel_ratio_[1]};
    taken_once_ = true;
    last_take_s_ = now_s;

    InputSnapshot taken = next_;
    next_.events.clear();
    next_.mouse_counts = {};
    next_.dropped_files.clear();
    return taken;
}

}  // namespace plumbline::platform
