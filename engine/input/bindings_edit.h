// Changing bindings one by one, and the text of bindings.ui.toml that says so.
#pragma once

#include "engine/core/input_snapshot.h"
#include "engine/input/bindings.h"

#include <optional>
#include <string>

namespace plumbline::input {

/// `input` takes the place of the action's `slot`-th one, or comes after the last. Other actions
/// that are live together with this one lose it.
void put_input(Bindings& bindings, Action action, std::size_t slot, const Input& input);
void remove_input(Bindings& bindings, Action action, std::size_t slot);
/// The action's inputs and hold mode as `below` has them, but for those that drive something else
/// by now.
void reset_action(Bindings& bindings, const Bindings& below, Action action);

/// The same for every action of a group.
void reset_group(Bindings& bindings, const Bindings& below, ActionGroup group);

bool same_inputs(const Bindings& a, const Bindings& b, Action action);

/// The actions, holds and tuning in which `wanted` differs from the layers below it.
std::string ui_bindings_text(const Bindings& below, const Bindings& wanted);

/// Waits for the press that shall drive an action: a key, button, wheel step, pad button, trigger
/// or stick, with the modifiers that are down. A modifier alone counts when it is let go.
class PressCapture {
public:
    enum class State : std::uint8_t { Waiting, Taken, Cancelled };

    /// `keys_down`: the modifiers among them are part of the chord.
    explicit PressCapture(const std::bitset<kKeyCount>& keys_down) : keys_down_(keys_down) {}
    /// Escape cancels. Events after the one that decides are not looked at.
    State take(const InputSnapshot& input);
    const Input& taken() const { return *taken_; }

private:
    State take_event(const DeviceEvent& event);
    State take_axes(const InputSnapshot& input);

    std::bitset<kKeyCount> keys_down_;
    std::array<bool, kPadAxisCount> axis_at_rest_{};
    int lone_modifier_{-1};
    std::optional<Input> taken_;
};

}  // namespace plumbline::input
