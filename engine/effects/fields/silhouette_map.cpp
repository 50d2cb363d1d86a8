#include "engine/effects/fields/silhouette_map.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {

double SilhouetteMap::at(const Vec3d& direction, const Silhouette& exact) {
    // From behind it looks as large: one half of the sphere is enough.
    const Vec3d facing = direction.y < 0 ? -direction : direction;
    const double sum = std::abs(facing.x) + facing.y + std::abs(facing.z);
    const double u = (facing.x / sum + 1) / 2 * kCells;
    const double v = (facing.z / sum + 1) / 2 * kCells;
    const int left = std::clamp(static_cast<int>(u), 0, kCells - 1);
    const int low = std::clamp(static_cast<int>(v), 0, kCells - 1);
    const double across = u - left;
    const double up = v - low;
    return (corner(left, low, exact) * (1 - across) + corner(left + 1, low, exact) * across) *
               (1 - up) +
           (corner(left, low + 1, exact) * (1 - across) +
            corner(left + 1, low + 1, exact) * across) *
               up;
}

double SilhouetteMap::corner(int u, int v, const Silhouette& exact) {
    constexpr std::size_t kAlong = static_cast<std::size_t>(kCells) + 1;
    if (corners_m2_.empty()) corners_m2_.assign(kAlong * kAlong, -1);
    double& area_m2 =
        corners_m2_[static_cast<std::size_t>(v) * kAlong + static_cast<std::size_t>(u)];
    if (area_m2 >= 0) return area_m2;
    const double x = 2.0 * u / kCells - 1;
    const double z = 2.0 * v / kCells - 1;
    Vec3d direction{x, 1 - std::abs(x) - std::abs(z), z};
    if (direction.y < 0) {
        direction.x = (1 - std::abs(z)) * (x < 0 ? -1 : 1);
        direction.z = (1 - std::abs(x)) * (z < 0 ? -1 : 1);
    }
    area_m2 = exact(glm::normalize(direction));
    return area_m2;
}

}  // namespace plumbline::effects
