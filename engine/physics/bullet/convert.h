// GLM and Pose to Bullet's types and back.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/transform.h"

#include <LinearMath/btTransform.h>

namespace plumbline::physics {

inline btVector3 to_bullet(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline Vec3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
inline btQuaternion to_bullet(const Quat& q) {
    return {q.x, q.y, q.z, q.w};
}
inline btTransform to_bullet(const Pose& pose) {
    return btTransform(to_bullet(pose.orientation), to_bullet(pose.position));
}

inline Quat quat_from_bullet(const btMatrix3x3& basis) {
    btQuaternion q;
    basis.getRotation(q);
    return Quat{q.w(), q.x(), q.y(), q.z()};
}
inline Pose from_bullet(const btTransform& transform) {
    return {.position = from_bullet(transform.getOrigin()),
            .orientation = quat_from_bullet(transform.getBasis())};
}

inline btMatrix3x3 to_bullet(const Mat3& m) {
    return {m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]};
}
inline Mat3 from_bullet(const btMatrix3x3& m) {
    return {m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]};
}
inline btTransform to_bullet(const Transform& transform) {
    return btTransform(to_bullet(transform.rotation), to_bullet(transform.position_m));
}
inline Transform transform_from_bullet(const btTransform& transform) {
    return {.rotation = from_bullet(transform.getBasis()),
            .position_m = from_bullet(transform.getOrigin())};
}

inline Vec3d double_from_bullet(const btVector3& v) {
    return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}
inline btVector3 bullet_from_double(const Vec3d& v) {
    return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

}  // namespace plumbline::physics
