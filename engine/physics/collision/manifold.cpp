#include "engine/physics/collision/manifold.h"

#include <cmath>

namespace plumbline::physics {

void forget_loads(Manifold& manifold) {
    for (ManifoldPoint& point : manifold.points) {
        point.load = {};
        point.normal_Ns = 0;
    }
    manifold.load = {};
}

std::array<Vec3, 2> tangents_of(const Vec3& normal) {
    constexpr Real kHalfRoot = 0.7071067811865475_r;
    // Across the plane in which the normal has most of its length.
    if (std::abs(normal.z) > kHalfRoot) {
        const Real square = normal.y * normal.y + normal.z * normal.z;
        const Real inverse = 1 / std::sqrt(square);
        const Vec3 first{0, -normal.z * inverse, normal.y * inverse};
        return {first, {square * inverse, -normal.x * first.z, normal.x * first.y}};
    }
    const Real square = normal.x * normal.x + normal.y * normal.y;
    const Real inverse = 1 / std::sqrt(square);
    const Vec3 first{-normal.y * inverse, normal.x * inverse, 0};
    return {first, {-normal.z * first.y, normal.z * first.x, square * inverse}};
}

}  // namespace plumbline::physics
