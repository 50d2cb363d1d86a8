// A rotation as a matrix, and a place: what points go through.
#pragma once

#include "engine/core/math.h"

namespace plumbline::physics {

struct Transform {
    Mat3 rotation{1};
    Vec3 position_m{0, 0, 0};

    Vec3 operator()(const Vec3& point) const { return rotation * point + position_m; }
    friend bool operator==(const Transform&, const Transform&) = default;
};

/// `v` seen along the rotation's axes.
inline Vec3 unrotated(const Vec3& v, const Mat3& rotation) {
    return {glm::dot(rotation[0], v), glm::dot(rotation[1], v), glm::dot(rotation[2], v)};
}

}  // namespace plumbline::physics
