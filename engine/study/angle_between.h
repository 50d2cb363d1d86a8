// How far one orientation is from another.
#pragma once

#include "engine/core/math.h"

#include <cmath>

namespace plumbline::study {

/// 0 to pi. atan2 keeps its digits at small angles, where acos of the dot product has none left.
inline double angle_between_rad(const Quatd& a, const Quatd& b) {
    const Quatd between = glm::conjugate(a) * b;
    return 2 * std::atan2(glm::length(Vec3d{between.x, between.y, between.z}), std::abs(between.w));
}

}  // namespace plumbline::study
