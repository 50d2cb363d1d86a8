#include "engine/physics/bullet/rotations.h"

#include "engine/physics/bullet/convert.h"
#include "engine/physics/dynamics/rotation.h"

#include <LinearMath/btTransformUtil.h>

namespace plumbline::physics {

Quat quat_of(const Mat3& rotation) {
    return quat_from_bullet(to_bullet(rotation));
}

Quatd double_quat_of(const Mat3& rotation) {
    btQuaternion q;
    to_bullet(rotation).getRotation(q);
    return glm::normalize(Quatd{static_cast<double>(q.w()),
                                static_cast<double>(q.x()),
                                static_cast<double>(q.y()),
                                static_cast<double>(q.z())});
}

Transform transform_of(const Pose& pose) {
    return transform_from_bullet(to_bullet(pose));
}

Pose pose_of(const Transform& transform) {
    return {.position = transform.position_m, .orientation = quat_of(transform.rotation)};
}

Mat3 turned(const Mat3& rotation, const Vec3& spin_radps, Real duration_s) {
    btQuaternion q;
    to_bullet(rotation).getRotation(q);
    const btQuaternion turn = to_bullet(turn_by(spin_radps, duration_s));
    return from_bullet(btMatrix3x3((turn * q).normalized()));
}

Mat3 turned_part_way(const Mat3& from, const Mat3& to, Real share) {
    btQuaternion first;
    btQuaternion last;
    to_bullet(from).getRotation(first);
    to_bullet(to).getRotation(last);
    return from_bullet(btMatrix3x3(first.slerp(last, share).normalized()));
}

SteadyMotion motion_between(const Transform& from, const Transform& to, Real duration_s) {
    btVector3 velocity;
    btVector3 spin;
    btTransformUtil::calculateVelocity(to_bullet(from), to_bullet(to), duration_s, velocity, spin);
    return {.velocity_mps = from_bullet(velocity), .spin_radps = from_bullet(spin)};
}

}  // namespace plumbline::physics
