// Where a shadow map of a light looks, and how it is drawn.
#pragma once

#include "engine/core/math.h"

#include <cstdint>

namespace plumbline::render {

/// In steps of a float from a half to one: 3e-5 of the light's range.
inline constexpr float kShadowBias_units = 512.0F;

struct ShadowView {
    Mat4f clip_from_world{1.0F};
    Vec3f eye_world{0.0F};  ///< casters nearest to it are drawn first
    std::uint32_t size_px{1024};
    float slope_bias{1.5F};
    float bias_units{kShadowBias_units};
    float error_m{0.0F};       ///< casters may be coarser by so much; 0: full meshes
    bool from_lamp{false};     ///< emitters do not cast: they are the lamp
    bool moves{false};         ///< the light itself moves: there is no use in keeping its map
    bool may_lag{false};       ///< the map may be behind moving things
    std::uint64_t statics{0};  ///< hash of all that cannot move, wherever it is; 0: not known
};

}  // namespace plumbline::render
