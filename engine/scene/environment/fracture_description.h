// What a scene file says of a body that breaks, as plain data in SI units.
#pragma once

#include "engine/core/math.h"

#include <cstdint>

namespace plumbline::scene {

/// `fracture` of a body.
struct FractureDescription {
    std::uint32_t pieces{20};
    Real strength_Pa{2e6_r};  ///< tension that the cut between two pieces bears
    Real stiffness_Pa{
        2e9_r};  ///< how short impacts are; absent in the file: a thousand times the strength
    std::uint32_t seed{1};  ///< of where it is cut
};

}  // namespace plumbline::scene
