// The hour of a running scene, which is where its sun stands.
#pragma once

#include "engine/scene/simulation.h"

#include <optional>

namespace plumbline::scene {

/// With [time], the sun stands as at that hour, 0 to 24; else nothing happens.
void set_hour(Simulation& simulation, double hour);
/// By where the sun stands; none without [time].
std::optional<double> hour_of(const Simulation& simulation);

}  // namespace plumbline::scene
