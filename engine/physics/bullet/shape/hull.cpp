#include "engine/physics/bullet/shape/hull.h"

#include "engine/core/limits.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::physics {
namespace {

/// Share of the largest extent below which a hull counts as flat.
constexpr double kFlatShare = 2e-5;

HullSurface compute(const std::vector<Vec3d>& points) {
    btConvexHullComputer computer;
    computer.compute(&points[0].x, sizeof(Vec3d), static_cast<int>(points.size()), 0, 0);
    HullSurface hull;
    for (int i = 0; i < computer.vertices.size(); ++i) {
        // The input's own coordinates: the computer works on a grid of its own.
        hull.corners_m.push_back(
            points[static_cast<std::size_t>(computer.original_vertex_index[i])]);
    }
    for (int f = 0; f < computer.faces.size(); ++f) {
        const btConvexHullComputer::Edge* first = &computer.edges[computer.faces[f]];
        const auto a = static_cast<std::uint32_t>(first->getSourceVertex());
        for (const auto* edge = first->getNextEdgeOfFace();
             edge->getTargetVertex() != first->getSourceVertex();
             edge = edge->getNextEdgeOfFace()) {
            hull.triangles.push_back({a,
                                      static_cast<std::uint32_t>(edge->getSourceVertex()),
                                      static_cast<std::uint32_t>(edge->getTargetVertex())});
        }
    }
    return hull;
}

/// Smallest extent over the directions of the faces (the exact width may lie across two edges; it
/// is never far below).
double width_of(const HullSurface& hull) {
    double width = std::numeric_limits<double>::max();
    for (const auto& t : hull.triangles) {
        const Vec3d a = hull.corners_m[t[0]];
        const Vec3d n = glm::cross(hull.corners_m[t[1]] - a, hull.corners_m[t[2]] - a);
        const double length = glm::length(n);
        if (!(length > 0)) continue;
        double deepest = 0;
        for (const Vec3d& corner : hull.corners_m) {
            deepest = std::max(deepest, std::abs(glm::dot(corner - a, n)) / length);
        }
        width = std::min(width, deepest);
    }
    return hull.triangles.empty() ? 0 : width;
}

/// The corners farthest out in directions spread evenly over the sphere.
std::vector<Vec3d> thinned(const std::vector<Vec3d>& corners) {
    constexpr double kGoldenAngle_rad = 2.39996322972865332;
    std::vector<bool> kept(corners.size(), false);
    std::size_t count = 0;
    // More directions than corners wanted: neighbours often agree on the corner.
    constexpr int kDirections = 4 * static_cast<int>(kMaxHullCorners);
    for (int stride = 4; stride >= 1 && count < kMaxHullCorners; stride /= 2) {
        for (int i = 0; i < kDirections && count < kMaxHullCorners; i += stride) {
            const double y = 1.0 - 2.0 * (i + 0.5) / kDirections;
            const double ring = std::sqrt(1.0 - y * y);
            const Vec3d direction{ring * portable_cos(kGoldenAngle_rad * i),
                                  y,
                                  ring * portable_sin(kGoldenAngle_rad * i)};
            std::size_t best = 0;
            for (std::size_t c = 1; c < corners.size(); ++c) {
                if (glm::dot(corners[c], direction) > glm::dot(corners[best], direction)) best = c;
            }
            if (!kept[best]) {
                kept[best] = true;
                ++count;
            }
        }
    }
    std::vector<Vec3d> result;
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (kept[c]) result.push_back(corners[c]);
    }
    return result;
}

/// The direction in which the points reach least: of the plane through the three points that span
/// the most area.
Vec3d normal_of_flat(const std::vector<Vec3d>& p) {
    const auto farthest_from = [&p](auto&& distance) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < p.size(); ++i) {
            if (distance(p[i]) > distance(p[best])) best = i;
        }
        return p[best];
    };
    const Vec3d a = farthest_from([&](const Vec3d& x) { return glm::length(x - p[0]); });
    const Vec3d b = farthest_from([&](const Vec3d& x) { return glm::length(x - a); });
    const Vec3d along = normalize_or(b - a, Vec3d{1, 0, 0});
    const Vec3d c =
        farthest_from([&](const Vec3d& x) { return glm::length(glm::cross(x - a, along)); });
    const Vec3d normal = glm::cross(along, c - a);
    if (glm::length(normal) > 1e-9) return glm::normalize(normal);
    const Vec3d other = std::abs(along.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    return glm::normalize(glm::cross(along, other));
}

}  // namespace

HullSurface hull_of(const std::vector<Vec3>& points_m) {
    const std::vector<Vec3d> points(points_m.begin(), points_m.end());
    HullSurface hull = compute(points);
    const std::size_t corners = hull.corners_m.size();
    if (corners > kMaxHullCorners) {
        hull = compute(thinned(hull.corners_m));
        hull.dropped = corners - hull.corners_m.size();
    }
    if (hull.triangles.size() < 4) return {};
    hull.width_m = width_of(hull);
    return hull;
}

bool too_flat(const HullSurface& hull, double largest_extent_m) {
    return hull.triangles.empty() ||
           hull.width_m < std::max(limits::kSizeMin_m, kFlatShare * largest_extent_m);
}

FlatBox flat_box_around(const std::vector<Vec3>& points_m) {
    const std::vector<Vec3d> points(points_m.begin(), points_m.end());
    const Vec3d normal = normal_of_flat(points);
    const Vec3d helper = std::abs(normal.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    const Vec3d u = glm::normalize(glm::cross(helper, normal));
    const Vec3d v = glm::cross(normal, u);

    // Turning in steps of a quarter degree finds the tightest rectangle within 0.5 % of its side.
    constexpr int kSteps = 360;
    FlatBox best;
    double best_area = std::numeric_limits<double>::max();
    for (int i = 0; i < kSteps; ++i) {
        const double angle = radians_from_degrees(90.0 * i / kSteps);
        const Vec3d x = portable_cos(angle) * u + portable_sin(angle) * v;
        const Vec3d z = glm::cross(x, normal);
        const Mat3d box_from_outer = glm::transpose(Mat3d{x, normal, z});
        Vec3d low{std::numeric_limits<double>::max()};
        Vec3d high{std::numeric_limits<double>::lowest()};
        for (const Vec3d& point : points) {
            low = glm::min(low, box_from_outer * point);
            high = glm::max(high, box_from_outer * point);
        }
        const Vec3d size = high - low;
        if (size.x * size.z >= best_area * (1.0 - 1e-9)) continue;
        best_area = size.x * size.z;
        best.size_m = size;
        best.center_m = glm::transpose(box_from_outer) * (0.5 * (low + high));
        best.orientation = glm::normalize(glm::quat_cast(glm::transpose(box_from_outer)));
    }
    const double largest = std::max({best.size_m.x, best.size_m.y, best.size_m.z});
    // Thinner boxes would let small things through within one step.
    best.size_m = glm::max(best.size_m,
                           Vec3d{std::max(2.0 * limits::kSizeMin_m, 2.0 * kFlatShare * largest)});
    return best;
}

}  // namespace plumbline::physics
