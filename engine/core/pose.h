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
Pose compose(const Pose& a_from_b, const Pose& b_from_c);
Pose invert(const Pose& pose);
Vec3 transform_point(const Pose& pose, const Vec3& point);

/// Between two steps: 0 gives a, 1 gives b. Positions blend linearly, orientations along the
/// shorter arc.
Pose blend(const Pose& a, const Pose& b, Real t);

bool is_finite(const Pose& pose);

/// As the GPU wants it.
Mat4f matrix_of(const Pose& pose, const Vec3& scale = Vec3{1, 1, 1});

}  // namespace plumbline
