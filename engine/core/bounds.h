// Boxes and spheres around things, for culling and queries.
#pragma once

#include "engine/core/math.h"

#include <limits>

namespace plumbline {

/// Axis-aligned box. A default-made one is empty: min above max.
struct Aabb {
    Vec3f min{std::numeric_limits<float>::max()};
    Vec3f max{std::numeric_limits<float>::lowest()};

    bool empty() const { return min.x > max.x; }
    Vec3f center() const { return (min + max) * 0.5F; }
    Vec3f size() const { return empty() ? Vec3f{0.0F} : max - min; }

    void include(const Vec3f& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void include(const Aabb& other) {
        if (other.empty()) return;
        include(other.min);
        include(other.max);
    }
};

/// The box around `box` after the transform.
inline Aabb transformed(const Aabb& box, const Mat4f& target_from_source) {
    if (box.empty()) return box;
    const Vec3f center{target_from_source * Vec4f{box.center(), 1.0F}};
    const Vec3f half = box.size() * 0.5F;
    const Vec3f reach = glm::abs(Vec3f{target_from_source[0]}) * half.x +
                        glm::abs(Vec3f{target_from_source[1]}) * half.y +
                        glm::abs(Vec3f{target_from_source[2]}) * half.z;
    return {.min = center - reach, .max = center + reach};
}

struct Sphere {
    Vec3f center{0.0F};
    float radius{0.0F};
};

inline Sphere sphere_around(const Aabb& box) {
    if (box.empty()) return {};
    return {.center = box.center(), .radius = glm::length(box.size()) * 0.5F};
}

}  // namespace plumbline
