// What an ActionLatch holds. Private to it: action_latch.cpp has keys and buttons, action_latch_axes.cpp
// sticks, triggers and the mouse's way.
#pragma once

#include "engine/input/action_latch.h"

#include <array>
#include <bitset>
#include <string>
#include <vector>

namespace plumbline::input {

/// An input that holds its action down, and the key or button that does so.
struct Holder {
    Action action;
    DeviceEventKind kind;
    int code;
    std::uint8_t modifiers;
};

/// A modifier key that may yet become part of a chord.
struct Waiting {
    Holder holder;
    double since_s;
};

/// The same for axes, which come as states, not events.
struct AxisHolder {
    Action action;
    std::size_t axis;
    int direction;
    float amount;
};

struct ActionLatch::Impl {
    Bindings bindings;
    LabelLookup label_of;
    std::vector<Holder> holders;
    std::vector<Waiting> waiting;
    std::vector<AxisHolder> axis_holders;
    std::bitset<kActionCount> toggled;
    std::array<std::uint8_t, kActionCount> step_presses{};
    std::array<int, kActionCount> frame_presses{};
    std::array<std::uint64_t, kActionCount> presses_seen{};
    std::bitset<kKeyCount> keys_down;  // as of the event being read
    std::array<bool, kPadAxisCount> axis_trusted{};
    double yaw_rad{0.0};
    double pitch_rad{0.0};
    double last_now_s{0.0};
    LastDevice last_device{LastDevice::KeyboardMouse};
    InputFocus focus{};
    bool updated_once{false};
    bool pad_present{false};

    bool is_live(Action action) const;
    bool matches(const Input& input, const DeviceEvent& event) const;
    void press(Action action);
    bool begins_chords(const DeviceEvent& event) const;
    void on_press(const DeviceEvent& event);
    void end_waiting(std::uint8_t chord);
    void start_what_waited(double now_s);
    void on_release(DeviceEventKind kind, int code);
    void drop_broken_chords();
    void on_event(const DeviceEvent& event);
    void release_everything();
    void release_keyboard();
    void release_pad();
    void follow_axes(const InputSnapshot& input);
    void follow_axis(Action action, const Input& source, const InputSnapshot& input);
    void follow_look(const InputSnapshot& input, double elapsed_s);
    void drop_sudden_focus_changes(const InputSnapshot& input, const InputFocus& now);
    float amount_of(Action action) const;
};

}  // namespace plumbline::input
