// What only the game attaches to entities. Plain data.
#pragma once

#include "engine/core/math.h"

namespace plumbline::game {

/// In the person's hand at the moment. At most one entity has it.
struct Held {
    Real mass_kg{0};
};

}  // namespace plumbline::game
