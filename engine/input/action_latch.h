// Device snapshots to Actions. Presses are kept until one step has taken them: none is lost in a
// frame without a step, none counts twice in a frame with three.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/input_snapshot.h"
#include "engine/input/bindings.h"

#include <array>
#include <bitset>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::input {

/// Who gets the input of this frame.
struct InputFocus {
    bool menu_open{false};    ///< only the menu group is live, everything else is released
    bool ui_keyboard{false};  ///< a text field has the keyboard
    bool ui_mouse{false};     ///< the pointer is over a panel
    /// Where the free pointer is, as Actions has it; none: the mouse looks around.
    std::optional<std::array<float, 2>> pointer{};
};

/// Which device was used last: hints follow it.
enum class LastDevice : std::uint8_t { KeyboardMouse, Gamepad };

/// What the key with this GLFW code prints in the user's layout: platform::printed_key_name.
using LabelLookup = std::function<std::string(int key)>;

class ActionLatch {
public:
    explicit ActionLatch(Bindings bindings);

    /// Once a frame. Focus loss, stalls and the menu release every action, drop what no step has
    /// taken yet, and forget the stick until it has been at rest.
    void update(const InputSnapshot& input, const InputFocus& focus);

    /// For one simulation step: presses and look since the last take, then cleared.
    Actions take();

    /// For things that belong to frames, not steps (menu, HUD, screenshot): presses since the last
    /// call for this action. Independent of take().
    int take_frame_presses(Action action);

    /// Look that no step has taken yet, so that the frame can turn at once.
    float pending_yaw_rad() const { return static_cast<float>(yaw_rad_); }
    float pending_pitch_rad() const { return static_cast<float>(pitch_rad_); }

    /// Lets go of an action in toggle mode, as when what was grabbed is gone. The key that is down
    /// counts no more until it is pressed again.
    void release(Action action);

    /// As if it had been pressed, in toggle mode: a saved game goes on with a thing in the hand. Other
    /// modes follow their keys.
    void engage(Action action);

    void set_bindings(Bindings bindings);  ///< releases everything held
    /// For `label:x` bindings; without it keys print what they do in the US layout.
    void set_label_lookup(LabelLookup lookup);
    const Bindings& bindings() const { return bindings_; }
    LastDevice last_device() const { return last_device_; }

    /// Presses per action since the start, for the report; for look: updates that turned the view.
    const std::array<std::uint64_t, kActionCount>& presses_seen() const { return presses_seen_; }

private:
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
    /// What holds an action down by an axis, which comes as a state, not as events.
    struct AxisHolder {
        Action action;
        std::size_t axis;
        int direction;
        float amount;
    };

    // action_latch.cpp: keys and buttons
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
    void drop_sudden_focus_changes(const InputSnapshot& input, const InputFocus& now);
    float amount_of(Action action) const;

    // action_latch_axes.cpp: sticks, triggers and the mouse's way
    void follow_axes(const InputSnapshot& input);
    void follow_axis(Action action, const Input& source, const InputSnapshot& input);
    void follow_look(const InputSnapshot& input, double elapsed_s);

    Bindings bindings_;
    LabelLookup label_of_;
    std::vector<Holder> holders_;
    std::vector<Waiting> waiting_;
    std::vector<AxisHolder> axis_holders_;
    std::bitset<kActionCount> toggled_;
    std::array<std::uint8_t, kActionCount> step_presses_{};
    std::array<int, kActionCount> frame_presses_{};
    std::array<std::uint64_t, kActionCount> presses_seen_{};
    std::bitset<kKeyCount> keys_down_;  ///< as of the event being read
    std::array<bool, kPadAxisCount> axis_trusted_{};
    double yaw_rad_{0.0};
    double pitch_rad_{0.0};
    double last_now_s_{0.0};
    LastDevice last_device_{LastDevice::KeyboardMouse};
    InputFocus focus_{};
    bool updated_once_{false};
    bool pad_present_{false};
};

}  // namespace plumbline::input
