// Device snapshots to Actions. Presses are kept until one step has taken them: none is lost in a
// frame without a step, none counts twice in a frame with three.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/input_snapshot.h"
#include "engine/input/bindings.h"

#include <functional>
#include <memory>
#include <string>

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
    ~ActionLatch();
    ActionLatch(const ActionLatch&) = delete;
    ActionLatch& operator=(const ActionLatch&) = delete;

    /// Once a frame. Focus loss, stalls and the menu release every action, drop what no step has
    /// taken yet, and forget the stick until it has been at rest.
    void update(const InputSnapshot& input, const InputFocus& focus);

    /// For one simulation step: presses and look since the last take, then cleared.
    Actions take();

    /// For things that belong to frames, not steps (menu, HUD, screenshot): presses since the last
    /// call for this action. Independent of take().
    int take_frame_presses(Action action);

    /// Look that no step has taken yet, so that the frame can turn at once.
    float pending_yaw_rad() const;
    float pending_pitch_rad() const;

    /// Lets go of an action in toggle mode, as when what was grabbed is gone. The key that is down
    /// counts no more until it is pressed again.
    void release(Action action);

    /// As if it had been pressed, in toggle mode: a saved game goes on with a thing in the hand. Other
    /// modes follow their keys.
    void engage(Action action);

    void set_bindings(Bindings bindings);  ///< releases everything held
    /// For `label:x` bindings; without it keys print what they do in the US layout.
    void set_label_lookup(LabelLookup lookup);
    const Bindings& bindings() const;
    LastDevice last_device() const;

    /// Presses per action since the start, for the report; for look: updates that turned the view.
    const std::array<std::uint64_t, kActionCount>& presses_seen() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::input
