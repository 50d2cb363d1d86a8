// The waters of a running scene.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::scene {

/// Adds it to Simulation::waters, with an entity for its surface where it has a material. Refused, with file and line: a basin
/// that is not there, has no mesh, or holds no water at that level.
Result<Done> add_water(Simulation& simulation, const WaterDescription& description);

}  // namespace plumbline::scene
