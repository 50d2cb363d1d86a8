// The player of events: what [[hard_case.event]] does to a scene while it runs.
#pragma once

#include "engine/scene/simulation.h"

namespace plumbline::study {

/// From now on each event of the scene's [hard_case] happens at the beginning of the step that begins
/// at its time, wherever the simulation is stepped. Those of the past do not happen again: not in a
/// loaded game, not to a ghost. What they add to the energy, but for forces' and impulses' work, is
/// counted in added_energy_J. Nothing for other scenes.
void play_case_events(scene::Simulation& simulation);

}  // namespace plumbline::study
