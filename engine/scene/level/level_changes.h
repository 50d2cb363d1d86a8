// Levels that were made in play: what of a scene begins otherwise, as `[[change]]` says it.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::scene {

/// Moves, freezes and takes away what the description's changes name, after everything is built. Names of nothing, as
/// of what an earlier change took away, are passed over.
void apply_changes(Simulation& simulation);

}  // namespace plumbline::scene
