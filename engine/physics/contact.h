// What touched what in the latest step.
#pragma once

#include "engine/physics/body.h"

namespace plumbline::physics {

/// One touching pair. Listed when either body asked for contact events.
struct ContactEvent {
    BodyId a{};
    BodyId b{};
    std::uint64_t user_a{0};
    std::uint64_t user_b{0};
    Vec3 point_world{0, 0, 0};   ///< m; where the pair pressed hardest
    Vec3 normal_world{0, 1, 0};  ///< from b to a
    Real impulse_Ns{0};          ///< normal impulse, summed over the pair's points and the step
    Real closing_speed_mps{0};   ///< along the normal before the step; > 0 when they came together
    Real sliding_speed_mps{0};   ///< across the normal
    bool began{false};           ///< the pair did not touch in the step before
};

}  // namespace plumbline::physics
