// Hulls for tests, found by trying every plane through three points: slow, plain, and none of the engine's code.
#pragma once

#include "engine/physics/collision/shape/hull_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace plumbline::physics::hull_rig {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
constexpr double kPi_rad = 3.14159265358979323846;

/// The points of one face, round its normal.
inline std::vector<std::uint32_t> sorted_round(const std::vector<Vec3d>& points,
                                               std::vector<std::uint32_t> face,
                                               const Vec3d& normal) {
    Vec3d middle{0, 0, 0};
    for (const std::uint32_t i : face) middle += points[i] / static_cast<double>(face.size());
    const Vec3d u = glm::normalize(points[face[0]] - middle);
    const Vec3d v = glm::cross(normal, u);
    const auto angle = [&](std::uint32_t i) {
        const Vec3d out = points[i] - middle;
        return std::atan2(glm::dot(out, v), glm::dot(out, u));
    };
    std::ranges::sort(face, [&](std::uint32_t i, std::uint32_t k) { return angle(i) < angle(k); });
    return face;
}

/// The closed surface round the points, which are all corners or lie on faces.
inline Triangles surface_of(const std::vector<Vec3d>& points) {
    constexpr double kOnPlane = 1e-9;
    Triangles surface;
    const auto count = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        for (std::uint32_t k = i + 1; k < count; ++k) {
            for (std::uint32_t l = k + 1; l < count; ++l) {
                Vec3d normal = glm::cross(points[k] - points[i], points[l] - points[i]);
                if (glm::length(normal) < 1e-12) continue;
                normal = glm::normalize(normal);
                std::vector<std::uint32_t> face;
                int above = 0;
                int below = 0;
                for (std::uint32_t p = 0; p < count; ++p) {
                    const double height = glm::dot(points[p] - points[i], normal);
                    if (height > kOnPlane) ++above;
                    if (height < -kOnPlane) ++below;
                    if (std::abs(height) <= kOnPlane) face.push_back(p);
                }
                // A plane of many points counts once: for its first three that span it.
                if ((above > 0 && below > 0) || face[0] != i || face[1] != k) continue;
                if (std::ranges::any_of(face, [&](std::uint32_t p) {
                        const Vec3d across =
                            glm::cross(points[k] - points[i], points[p] - points[i]);
                        return p > k && p < l && glm::length(across) > 1e-12;
                    }))
                    continue;
                const std::vector<std::uint32_t> round =
                    sorted_round(points, face, above > 0 ? -normal : normal);
                for (std::size_t p = 1; p + 1 < round.size(); ++p)
                    surface.push_back({round[0], round[p], round[p + 1]});
            }
        }
    }
    return surface;
}

inline HullGeometry hull_round(const std::vector<Vec3d>& points) {
    return hull_geometry(points, surface_of(points));
}

inline std::vector<Vec3d> cube_corners(const Vec3d& half) {
    std::vector<Vec3d> corners;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) corners.push_back(half * Vec3d{x, y, z});
        }
    }
    return corners;
}

/// A regular prism upright on y.
inline std::vector<Vec3d> prism_corners(int sides, double radius, double half_height) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle_rad = 2 * kPi_rad * i / sides;
        for (const double y : {-half_height, half_height})
            corners.emplace_back(radius * std::cos(angle_rad), y, radius * std::sin(angle_rad));
    }
    return corners;
}

/// Spread evenly over a sphere: all of them corners.
inline std::vector<Vec3d> sphere_corners(int count, double radius) {
    constexpr double kGoldenAngle_rad = 2.39996322972865332;
    std::vector<Vec3d> corners;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - 2 * (i + 0.5) / count;
        const double ring = std::sqrt(1 - y * y);
        corners.emplace_back(radius * Vec3d{ring * std::cos(kGoldenAngle_rad * i),
                                            y,
                                            ring * std::sin(kGoldenAngle_rad * i)});
    }
    return corners;
}

}  // namespace plumbline::physics::hull_rig
