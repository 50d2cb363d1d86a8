#include "engine/core/pose.h"

namespace plumbline {

Pose compose(const Pose& a_from_b, const Pose& b_from_c) {
    return {.position = a_from_b.position + a_from_b.orientation * b_from_c.position,
            .orientation = glm::normalize(a_from_b.orientation * b_from_c.orientation)};
}

Pose invert(const Pose& pose) {
    const Quat inverse = glm::conjugate(pose.orientation);
    return {.position = -(inverse * pose.position), .orientation = inverse};
}

Vec3 transform_point(const Pose& pose, const Vec3& point) {
    return pose.position + pose.orientation * point;
}

Pose blend(const Pose& a, const Pose& b, Real t) {
    return {.position = a.position + (b.position - a.position) * t,
            .orientation = glm::slerp(a.orientation, b.orientation, t)};
}

bool is_finite(const Pose& pose) {
    return is_finite(pose.position) && is_finite(pose.orientation);
}

Mat4f matrix_of(const Pose& pose, const Vec3& scale) {
    const Mat3f rotation = glm::mat3_cast(Quatf(pose.orientation));
    return Mat4f(Vec4f(rotation[0] * static_cast<float>(scale.x), 0.0F),
                 Vec4f(rotation[1] * static_cast<float>(scale.y), 0.0F),
                 Vec4f(rotation[2] * static_cast<float>(scale.z), 0.0F),
                 Vec4f(Vec3f(pose.position), 1.0F));
}

}  // namespace plumbline
