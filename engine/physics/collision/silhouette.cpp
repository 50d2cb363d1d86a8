#include "engine/physics/collision/silhouette.h"

#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/collision/shape/hull_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kTurn_rad = 2 * 3.14159265358979323846;
constexpr int kLines = 256;
constexpr int kOutlinePoints = 96;

double hull_silhouette_m2(const HullGeometry& hull, const Vec3d& direction) {
    double sum = 0;
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.corners_of(face);
        const Vec3d first = hull.corners_m[corners.front()];
        Vec3d area{0, 0, 0};
        for (std::size_t i = 2; i < corners.size(); ++i)
            area += glm::cross(hull.corners_m[corners[i - 1]] - first,
                               hull.corners_m[corners[i]] - first) *
                    0.5;
        sum += std::abs(glm::dot(area, direction));
    }
    return sum / 2;
}

/// A disc, and beside it the tip where it sticks out.
double cone_silhouette_m2(double radius_m, double height_m, double along, double across) {
    const double disc_m2 = kTurn_rad / 2 * radius_m * radius_m * along;
    const double tip_m = height_m * across;
    if (tip_m <= radius_m * along) return disc_m2;
    // Stretched so that the disc is round, the tip lies tip_m / along from its middle.
    const double cosine = radius_m * along / tip_m;
    const double rest =
        std::sqrt(std::max(tip_m * tip_m - radius_m * radius_m * along * along, 0.0));
    return disc_m2 - radius_m * radius_m * along * portable_acos(cosine) + radius_m * rest;
}

/// Two unit vectors across a direction.
std::array<Vec3d, 2> across(const Vec3d& direction) {
    const Vec3d other = std::abs(direction.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
    const Vec3d first = glm::normalize(glm::cross(other, direction));
    return {first, glm::cross(direction, first)};
}

/// Where a convex part's shadow lies along one line, for `kLines` lines `x`.
struct Outline {
    std::array<glm::dvec2, kOutlinePoints> points;  ///< round it
};

Outline outline_of(const PlacedConvex& convex, const std::array<Vec3d, 2>& axes) {
    Outline outline;
    for (int i = 0; i < kOutlinePoints; ++i) {
        const double angle = kTurn_rad * i / kOutlinePoints;
        const Vec3d towards = axes[0] * portable_cos(angle) + axes[1] * portable_sin(angle);
        const Vec3d at = support(convex, towards) + convex.radius_m * towards;
        outline.points[static_cast<std::size_t>(i)] = {glm::dot(at, axes[0]),
                                                       glm::dot(at, axes[1])};
    }
    return outline;
}

using Interval = std::pair<double, double>;

/// Nothing where the line passes by.
Interval interval_at(const Outline& outline, double x) {
    Interval found{1, 0};
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const glm::dvec2& a = outline.points[i];
        const glm::dvec2& b = outline.points[(i + 1) % outline.points.size()];
        if ((a.x < x) == (b.x < x)) continue;
        const double y = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
        if (found.first > found.second)
            found = {y, y};
        else
            found = {std::min(found.first, y), std::max(found.second, y)};
    }
    return found;
}

double covered_m(std::vector<Interval>& intervals) {
    std::ranges::sort(intervals);
    double sum = 0;
    double end = -HUGE_VAL;
    for (const auto& [from, to] : intervals) {
        if (to <= end) continue;
        sum += to - std::max(from, end);
        end = to;
    }
    return sum;
}

}  // namespace

double silhouette_m2(const ConvexShape& shape, const Vec3d& direction) {
    const auto r = static_cast<double>(shape.radius_m);
    const double height_m = 2 * static_cast<double>(shape.half_height_m);
    const double along = std::abs(direction.y);
    const double across = std::sqrt(std::max(1 - along * along, 0.0));
    const double disc_m2 = kTurn_rad / 2 * r * r;
    const Vec3d size = 2.0 * Vec3d(shape.half_m);
    switch (shape.kind) {
        case ConvexShape::Kind::None:
            return 0;
        case ConvexShape::Kind::Sphere:
            return disc_m2;
        case ConvexShape::Kind::Capsule:
            return disc_m2 + 2 * r * height_m * across;
        case ConvexShape::Kind::Box:
            return glm::dot(Vec3d{size.y * size.z, size.z * size.x, size.x * size.y},
                            glm::abs(direction));
        case ConvexShape::Kind::Cylinder:
            return disc_m2 * along + 2 * r * height_m * across;
        case ConvexShape::Kind::Cone:
            return cone_silhouette_m2(r, height_m, along, across);
        case ConvexShape::Kind::Hull:
            return hull_silhouette_m2(*shape.hull, direction);
    }
    return 0;
}

double silhouette_m2(const BodyGeometry& geometry, const Vec3d& direction_mass) {
    if (geometry.parts.empty()) return 0;
    if (geometry.parts.size() == 1) {
        const GeometryPart& part = geometry.parts.front();
        return silhouette_m2(
            part.shape, glm::transpose(glm::dmat3(part.mass_from_part.rotation)) * direction_mass);
    }
    const std::array<Vec3d, 2> axes = across(direction_mass);
    std::vector<Outline> outlines;
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const GeometryPart& part : geometry.parts) {
        outlines.push_back(
            outline_of(placed_convex({part.shape, part.mass_from_part}, {0, 0, 0}), axes));
        for (const glm::dvec2& point : outlines.back().points) {
            low = std::min(low, point.x);
            high = std::max(high, point.x);
        }
    }
    const double width_m = (high - low) / kLines;
    double sum_m2 = 0;
    std::vector<Interval> intervals;
    for (int i = 0; i < kLines; ++i) {
        intervals.clear();
        for (const Outline& outline : outlines) {
            const Interval found = interval_at(outline, low + (i + 0.5) * width_m);
            if (found.first < found.second) intervals.push_back(found);
        }
        sum_m2 += width_m * covered_m(intervals);
    }
    return sum_m2;
}

}  // namespace plumbline::physics
