// Whether a world that was read from an archive is one that steps could have made.
#pragma once

#include <string>

namespace plumbline::physics {

struct WorldState;

/// Why no step may run from what was read of bodies and joints; empty: one may. Asked before anything is
/// built from them. That numbers are finite and choices among those there are has been seen to by the
/// archive; orders and lists are checked where they are read.
std::string fault_of_restored(const WorldState& world);

}  // namespace plumbline::physics
