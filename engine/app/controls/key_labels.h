// What a bound input is called on the keyboard in front of the person.
#pragma once

#include "engine/core/actions.h"
#include "engine/input/action_latch.h"
#include "engine/input/bindings.h"

#include <string>
#include <string_view>

namespace plumbline::app {

inline constexpr std::string_view kUnbound = "unbound";

/// "Q", "Ctrl+R", "Left mouse", "South (A)": the printed label of a key in its place.
std::string label_of(const input::Input& input);

/// The action's first input on the device used last, or "unbound".
std::string hint_for(const input::Bindings& bindings, Action action, input::LastDevice device);

/// All inputs of the action, joined by " or "; those of gamepads only `with_pad`. None: "unbound".
std::string all_labels(const input::Bindings& bindings, Action action, bool with_pad);

/// "W A S D": the first key of each direction to walk in.
std::string walk_labels(const input::Bindings& bindings, input::LastDevice device);

}  // namespace plumbline::app
