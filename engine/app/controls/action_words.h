// Which actions the help and the controls pages offer.
#pragma once

#include "engine/core/actions.h"

namespace plumbline::app {

/// False for the numbers beyond the things that there are, which files may bind all the same.
bool is_offered(Action action);
/// It does something while a model by itself is turned.
bool is_for_models(Action action);
/// It does something while one plays.
bool is_for_play(Action action);

}  // namespace plumbline::app
