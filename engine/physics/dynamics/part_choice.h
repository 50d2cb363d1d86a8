// Into how many parts an island's step is cut, with its contact points found anew before each: points that roll over a body
// or a mesh must not lag far behind.
#pragma once

#include <cstddef>

namespace plumbline::physics {

struct Island;

/// Finding the points of more so often would cost too much.
inline constexpr std::size_t kMostBodiesInParts = 64;

/// Not where joints, many bodies or a force that drives a body through others are in it.
bool may_be_parted(const Island& island, double step_s);
/// At most.
int most_parts(const Island& island);
/// For the rest of a step, as the bodies move now and as impacts are about to change that.
int parts_of_step(const Island& island, double rest_s);

}  // namespace plumbline::physics
