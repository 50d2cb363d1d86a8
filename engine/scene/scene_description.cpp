#include "engine/scene/scene_description.h"

#include <fmt/format.h>

namespace plumbline::scene {

Quat upright(const Vec3& up) {
    constexpr Real kSame = 1 - 1e-6_r;
    if (up.y > kSame) return kNoRotation;
    if (up.y < -kSame) return portable_angle_axis(kPi, Vec3{0, 0, 1});
    const Vec3 axis = glm::cross(Vec3{0, 1, 0}, up);
    return glm::normalize(Quat{1 + up.y, axis.x, axis.y, axis.z});
}

}  // namespace plumbline::scene
