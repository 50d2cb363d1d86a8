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

std::array<double, 3> nearest_shares(const Vec3d& p, const std::array<Vec3d, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec3d ab = b - a;
    const Vec3d ac = c - a;
    const double d1 = glm::dot(ab, p - a);
    const double d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = glm::dot(ab, p - b);
    const double d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = glm::dot(ab, p - c);
    const double d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double share = (d4 - d3) / (d4 - d3 + d5 - d6);
        return {0, 1 - share, share};
    }
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
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
