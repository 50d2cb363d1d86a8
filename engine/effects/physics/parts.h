// Bodies that are parts of a rope or a vehicle, switched together.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::effects {

/// Freezes all parts of such things, or lets those go that it froze. What a player froze stays so.
void stop_parts(scene::Simulation& simulation, scene::PartOf::Whole of, bool stopped);

}  // namespace plumbline::effects
