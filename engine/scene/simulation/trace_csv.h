// The trace of `simulate` as comma-separated values: a line a body and a time.
#pragma once

#include "engine/scene/simulation.h"

#include <string>

namespace plumbline::scene {

/// The first line: names of columns, with their units.
std::string trace_csv_head();
/// Of every body that may move, in the order of the state file, parts of ropes and vehicles included. World axes, SI units.
std::string trace_csv_lines(const Simulation& simulation);

}  // namespace plumbline::scene
