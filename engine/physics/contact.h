// What touches what, and how: materials, and what the latest step found.
#pragma once

#include "engine/physics/body.h"

namespace plumbline::physics {

/// What a caller decides about pairs of bodies, which are given by their marks (BodyDef::user). Asked in
/// the midst of a step, so it must not change the world. small_step only.
class PairRules {
public:
    virtual ~PairRules() = default;
    /// Of two bodies whose filters agree and whose boxes come to overlap.
    virtual bool may_touch(std::uint64_t user_a, std::uint64_t user_b) const = 0;
    /// Of two bodies that begin to touch.
    virtual Material combined(std::uint64_t user_a, std::uint64_t user_b) const = 0;
};

/// A contact point as the latest step left it.
struct ContactPoint {
    BodyId a{};
    BodyId b{};
    std::uint64_t user_a{0};
    std::uint64_t user_b{0};
    Vec3 point_a_world{0, 0, 0};  ///< m, on the surface
    Vec3 point_b_world{0, 0, 0};
    Vec3 normal_world{0, 1, 0};  ///< from b to a
    Real distance_m{0};          ///< negative: penetration
    Real impulse_Ns{0};          ///< normal, over the whole step
    int age_steps{0};            ///< 0: found in this step
};

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
