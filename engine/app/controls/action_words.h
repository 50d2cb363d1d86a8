// What actions are called where people read: in the help, the controls pages and messages.
#pragma once

#include "engine/core/actions.h"

#include <string_view>

namespace plumbline::app {

std::string_view action_words(Action action);     ///< "drop the chosen thing"
std::string_view group_words(ActionGroup group);  ///< "Things"
/// False for the numbers beyond the things that there are, which files may bind all the same.
bool is_offered(Action action);
/// It does something while a model by itself is turned.
bool is_for_models(Action action);
/// It does something while one plays.
bool is_for_play(Action action);

}  // namespace plumbline::app
