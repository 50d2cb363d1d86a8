// The wind at a place and a time: a mean, and two waves of gusts that it carries along. Each wave blows
// across its own number, so that the field has no divergence; over time they average to nothing.
// shaders/include/wind.glsl is the same by the numbers of waves_at().
#pragma once

#include "engine/scene/nature_description.h"

#include <array>

namespace plumbline::scene {

struct GustWave {
    Vec2 number_radpm{0, 0};  ///< along x and z
    Real phase_rad{0};        ///< at the origin, then
    Real speed_mps{0};
};

/// Phases lie in 0…2 pi.
std::array<GustWave, 2> waves_at(const WindDescription& wind, double time_s);

/// m/s, level.
Vec3 wind_at(const WindDescription& wind, const Vec3& place_world, double time_s);

}  // namespace plumbline::scene
