// What a bound input is called on the keyboard in front of the person.
#pragma once

#include "engine/core/actions.h"
#include "engine/input/action_latch.h"
#include "engine/input/bindings.h"

#include <string>

namespace plumbline::app {

/// "Q", "Ctrl+R", "Left mouse", "South (A)": the printed label of a key in its place.
std::string label_of(const input::Input& input);

/// The action's first input on the device used last, or "unbound".
std::string hint_for(const input::Bindings& bindings, Action action, input::LastDevice device);

/// All inputs of the action, joined by " or ".
std::string all_labels(const input::Bindings& bindings, Action action);

}  // namespace plumbline::app
