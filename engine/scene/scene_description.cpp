#include "engine/scene/scene_description.h"

#include <algorithm>

namespace plumbline::scene {

Quat upright(const Vec3& up) {
    constexpr Real kSame = 1 - 1e-6_r;
    if (up.y > kSame) return kNoRotation;
    if (up.y < -kSame) return portable_angle_axis(kPi, Vec3{0, 0, 1});
    const Vec3 axis = glm::cross(Vec3{0, 1, 0}, up);
    return glm::normalize(Quat{1 + up.y, axis.x, axis.y, axis.z});
}

std::size_t copies_of(const ArrayDescription& array) {
    std::size_t copies = 1;
    for (const int count : array.count) copies *= static_cast<std::size_t>(std::max(count, 0));
    return copies;
}

}  // namespace plumbline::scene
