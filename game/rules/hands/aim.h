// Where the person looks from and to: what dropping, throwing and grabbing start from.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/body.h"

namespace plumbline::game {

struct Aim {
    Vec3 eye_m{0, 0, 0};
    Vec3 forward{0, 0, -1};  ///< unit
    Real yaw_rad{0};
    Vec3 velocity_mps{0, 0, 0};
    physics::BodyId own_body{};  ///< the person's capsule, if there is one
    physics::BodyId support{};   ///< what the person stands on
    Real keep_away_m{0};         ///< level distance from the eye's axis that held things keep
    bool by_pointer{false};      ///< a free pointer aims: it reaches as far as one sees

    /// How far something at most `arm_m` away may be taken, moved or removed.
    Real reach_m(Real arm_m) const { return by_pointer ? kSight_m : arm_m; }
    static constexpr Real kSight_m = 1000;
};

/// Level and unit; yaw 0 looks down -Z, left is positive.
inline Vec3 level_forward(Real yaw_rad) {
    return {-portable_sin(yaw_rad), 0, -portable_cos(yaw_rad)};
}
inline Vec3 level_right(Real yaw_rad) {
    return {portable_cos(yaw_rad), 0, -portable_sin(yaw_rad)};
}

}  // namespace plumbline::game
