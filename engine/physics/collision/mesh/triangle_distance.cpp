#include "engine/physics/collision/mesh/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics {

NearestPoint nearest_to(const Vec3d& place,
                        const std::array<Vec3d, 3>& corners,
                        const Vec3d& normal) {
    NearestPoint found;
    double best2 = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = i == 2 ? 0 : i + 1;
        const Vec3d along = corners[k] - corners[i];
        const Vec3d there = place - corners[i];
        if (glm::dot(glm::cross(along, normal), there) <= 0) continue;
        const double t = glm::dot(there, along) / glm::dot(along, along);
        const Vec3d at = corners[i] + along * std::clamp(t, 0.0, 1.0);
        const Vec3d away = place - at;
        if (glm::dot(away, away) >= best2) continue;
        best2 = glm::dot(away, away);
        found = {at, false, t >= 1 ? k : i, t <= 0 ? i : k};
    }
    if (found.is_face) found.at = place - normal * glm::dot(place - corners[0], normal);
    return found;
}

double away_from_triangle2(const Vec3d& place, const std::array<Vec3d, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec3d normal = glm::normalize(glm::cross(b - a, c - a));
    const Vec3d away = nearest_to(place, corners, normal).at - place;
    return glm::dot(away, away);
}

double away_from_line2(const Vec3d& place, const Vec3d& from, const Vec3d& to) {
    const Vec3d along = to - from;
    const double length2 = glm::dot(along, along);
    const double t =
        length2 > 0 ? std::clamp(glm::dot(place - from, along) / length2, 0.0, 1.0) : 0.0;
    const Vec3d away = place - (from + along * t);
    return glm::dot(away, away);
}

}  // namespace plumbline::physics
