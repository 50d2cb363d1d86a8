// Where a thing is and how it is turned.
#pragma once

#include "engine/core/math.h"

namespace plumbline {

/// A rigid placement. Named target_from_source: `world_from_body` turns body into world points.
struct Pose {
    Vec3 position{0, 0, 0};                                ///< m
    Quat orientation{Real{1}, Real{0}, Real{0}, Real{0}};  ///< unit
};

/// a_from_b * b_from_c = a_from_c.
inline Pose compose(const Pose& a_from_b, const Pose& b_from_c) {
    return {.position = a_from_b.position + a_from_b.orientation * b_from_c.position,
            .orientation = glm::normalize(a_from_b.orientation * b_from_c.orientation)};
}

inline Pose invert(const Pose& pose) {
    const Quat inverse = glm::conjugate(pose.orientation);
    return {.position = -(inverse * pose.position), .orientation = inverse};
}

inline Vec3 transform_point(const Pose& pose, const Vec3& point) {
    return pose.position + pose.orientation * point;
}

/// Between two steps: 0 gives a, 1 gives b. Positions blend linearly, orientations along the
/// shorter arc.
inline Pose blend(const Pose& a, const Pose& b, Real t) {
    return {.position = a.position + (b.position - a.position) * t,
            .orientation = portable_slerp(a.orientation, b.orientation, t)};
}

inline bool is_finite(const Pose& pose) {
    return is_finite(pose.position) && is_finite(pose.orientation);
}

/// As the GPU wants it.
inline Mat4f matrix_of(const Pose& pose, const Vec3& scale = Vec3{1, 1, 1}) {
    const Mat3f rotation = glm::mat3_cast(Quatf(pose.orientation));
    return Mat4f(Vec4f(rotation[0] * static_cast<float>(scale.x), 0.0F),
                 Vec4f(rotation[1] * static_cast<float>(scale.y), 0.0F),
                 Vec4f(rotation[2] * static_cast<float>(scale.z), 0.0F),
                 Vec4f(Vec3f(pose.position), 1.0F));
}

}  // namespace plumbline
