// Ghost collisions: contact points of shapes that never meet.
//
// A pair's points are found by its two bodies alone, and a point says what lies along one normal. What slides over a floor sinks into
// it by a little, so that the side of the next tile would stop it, though the tile below covers that side; and what flies past an
// edge would be stopped by the plane through its nearest point of it.
#pragma once

#include "engine/physics/collision/pair_reach.h"

#include <span>

namespace plumbline::physics {

/// Drops points of `bodies`, which are those that forces move, on convex parts of others:
/// - from the side of what is level with something else that the body touches: along the normal of that contact the two overlap by
///   no more than that contact does, and a little;
/// - within another shape that does not give way and that the body meets there first;
/// - of what the body passes by, as some direction keeps the two apart all through the step: where that is so of all that either
///   might meet, and of balls and capsules past edges. No joint may hold either.
/// Pairs that lose all of their points do not touch any more. The order of `bodies` does not matter.
void drop_ghost_contacts(std::span<BodyRecord* const> bodies, const CollideStep& step);

}  // namespace plumbline::physics
