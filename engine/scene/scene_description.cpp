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

Pose pose_of_copy(const ArrayDescription& array, const std::array<int, 3>& index) {
    const Vec3 cell{
        static_cast<Real>(index[0]), static_cast<Real>(index[1]), static_cast<Real>(index[2])};
    return {.position = array.origin_m + array.spacing_m * cell,
            .orientation = portable_angle_axis(glm::dot(array.turn_rad, cell), Vec3{0, 1, 0}) *
                           array.prefab.world_from_body.orientation};
}

std::size_t copies_of(const ArrayDescription& array) {
    std::size_t copies = 1;
    for (const int count : array.count) copies *= static_cast<std::size_t>(std::max(count, 0));
    return copies;
}

}  // namespace plumbline::scene
