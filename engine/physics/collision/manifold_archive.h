// The manifolds of a pair in a saved game.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/physics/collision/pair.h"

namespace plumbline::physics {

/// All that the next step reads of the pair, and whoever asks before it. A pair that is read has both its bodies.
void serialize_pair(Archive& archive, Pair& pair);

}  // namespace plumbline::physics
