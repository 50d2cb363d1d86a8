// A rotation as a matrix, and a place: what points go through.
#pragma once

#include "engine/core/math.h"

#include <cmath>

namespace plumbline::physics {

/// |v|, component by component. glm::abs() branches on each sign, which is slow where signs are random.
template <class T>
glm::vec<3, T> magnitudes_of(const glm::vec<3, T>& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

struct Transform {
    Mat3 rotation{1};
    Vec3 position_m{0, 0, 0};

    Vec3 operator()(const Vec3& point) const { return rotation * point + position_m; }
    friend bool operator==(const Transform&, const Transform&) = default;
};

/// First `inner`, then `outer`.
inline Transform operator*(const Transform& outer, const Transform& inner) {
    return {.rotation = outer.rotation * inner.rotation, .position_m = outer(inner.position_m)};
}

/// `v` seen along the rotation's axes.
inline Vec3 unrotated(const Vec3& v, const Mat3& rotation) {
    return {glm::dot(rotation[0], v), glm::dot(rotation[1], v), glm::dot(rotation[2], v)};
}

/// The way back.
inline Transform inverse(const Transform& t) {
    return {.rotation = glm::transpose(t.rotation),
            .position_m = -unrotated(t.position_m, t.rotation)};
}

}  // namespace plumbline::physics
