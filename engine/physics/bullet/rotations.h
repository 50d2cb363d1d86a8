// Rotations between matrix and quaternion, with Bullet's own rounding: both sides then agree on
// what a pose is.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/transform.h"

namespace plumbline::physics {

Quat quat_of(const Mat3& rotation);
/// ... in double precision, of length 1.
Quatd double_quat_of(const Mat3& rotation);
Transform transform_of(const Pose& pose);
Pose pose_of(const Transform& transform);

/// `rotation` turned by a constant spin for a while.
Mat3 turned(const Mat3& rotation, const Vec3& spin_radps, Real duration_s);
/// A share of the way from one to the other.
Mat3 turned_part_way(const Mat3& from, const Mat3& to, Real share);

/// A motion that does not change, as two velocities.
struct SteadyMotion {
    Vec3 velocity_mps{0, 0, 0};
    Vec3 spin_radps{0, 0, 0};
};
/// What leads from one place to the other in a while.
SteadyMotion motion_between(const Transform& from, const Transform& to, Real duration_s);

}  // namespace plumbline::physics
