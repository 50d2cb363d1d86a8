// Boxes of a pair's bodies in Bullet's broad phase.
#pragma once

#include "engine/physics/collision/pair.h"

namespace plumbline::physics {

/// Whether the boxes that the broad phase holds overlap.
bool boxes_overlap(const Pair& pair);
/// Whether the broad phase may forget the pair: it will find it again when either body moves on.
bool boxes_are_far(const Pair& pair);

}  // namespace plumbline::physics
