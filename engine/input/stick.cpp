#include "engine/input/stick.h"

#include <algorithm>
#include <cmath>

namespace plumbline::input {

std::array<float, 2> shape_stick(float x, float y, const Tuning& tuning) {
    if (!std::isfinite(x)) x = 0.0F;
    if (!std::isfinite(y)) y = 0.0F;
    const float length = std::hypot(x, y);
    const float inner = tuning.pad_inner_dead_zone;
    const float outer = 1.0F - tuning.pad_outer_dead_zone;
    if (length <= inner || length <= 0.0F) return {0.0F, 0.0F};
    const float travel = std::clamp((length - inner) / std::max(outer - inner, 1e-3F), 0.0F, 1.0F);
    const float scale = std::pow(travel, tuning.pad_curve) / length;
    return {x * scale, y * scale};
}

float trigger_travel(float axis) {
    if (!std::isfinite(axis)) return 0.0F;
    return std::clamp((axis + 1.0F) * 0.5F, 0.0F, 1.0F);
}

}  // namespace plumbline::input
