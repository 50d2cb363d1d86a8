#include "tests/engine/physics/collision/narrow_phase/convex_rig.h"

#include <algorithm>
#include <limits>

namespace plumbline::physics::convex_rig {
namespace {

/// The core's reach from the shape's own centre, in its own frame.
double local_reach(const ConvexShape& shape, const Vec3d& d) {
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    const double ring = std::hypot(d.x, d.z);
    switch (shape.kind) {
        case Kind::Box:
            return glm::dot(Vec3d{shape.half_m}, glm::abs(d));
        case Kind::Capsule:
            return half * std::abs(d.y);
        case Kind::Cylinder:
            return radius * ring + half * std::abs(d.y);
        case Kind::Cone:
            return std::max(half * d.y, radius * ring - half * d.y);
        case Kind::Hull: {
            double most = std::numeric_limits<double>::lowest();
            for (const Vec3d& corner : shape.hull->corners_m)
                most = std::max(most, glm::dot(corner, d));
            return most;
        }
        case Kind::Sphere:
        case Kind::None:
            break;
    }
    return 0;
}

/// Of a rectangle in the half plane of the axis, `ring` from it.
double height_over_cylinder(double radius, double half, double ring, double y) {
    const double out = ring - radius;
    const double up = std::abs(y) - half;
    if (out <= 0 || up <= 0) return std::max(out, up);
    return std::hypot(out, up);
}

double height_over_cone(double radius, double half, double ring, double y) {
    const double slant = std::hypot(radius, 2 * half);
    const double off_side = (ring * 2 * half + (y - half) * radius) / slant;
    const double off_base = -half - y;
    return std::max(off_side, off_base);
}

double local_height(const ConvexShape& shape, const Vec3d& p) {
    const auto radius = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    const double ring = std::hypot(p.x, p.z);
    switch (shape.kind) {
        case Kind::Sphere:
            return glm::length(p) - radius;
        case Kind::Capsule:
            return std::hypot(ring, p.y - std::clamp(p.y, -half, half)) - radius;
        case Kind::Box: {
            const Vec3d out = glm::abs(p) - Vec3d{shape.half_m};
            const double inside = std::max({out.x, out.y, out.z});
            return inside <= 0 ? inside : glm::length(glm::max(out, 0.0));
        }
        case Kind::Cylinder:
            return height_over_cylinder(radius, half, ring, p.y);
        case Kind::Cone:
            return height_over_cone(radius, half, ring, p.y);
        case Kind::Hull: {
            double most = std::numeric_limits<double>::lowest();
            for (const HullFace& face : shape.hull->faces)
                most = std::max(most, glm::dot(face.normal, p) - face.offset_m);
            return most;
        }
        case Kind::None:
            break;
    }
    return 0;
}

}  // namespace

double reach_along(const PlacedConvex& convex, const Vec3d& direction) {
    if (convex.shape == nullptr) {
        double most = std::numeric_limits<double>::lowest();
        for (const Vec3d& corner : convex.triangle)
            most = std::max(most, glm::dot(corner, direction));
        return most;
    }
    return glm::dot(convex.center_m, direction) +
           local_reach(*convex.shape, glm::transpose(convex.axes) * direction) +
           convex.radius_m * glm::length(direction);
}

double gap_along(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& normal) {
    return -reach_along(a, -normal) - reach_along(b, normal);
}

double height_over(const PlacedConvex& convex, const Vec3d& point) {
    return local_height(*convex.shape, glm::inverse(convex.axes) * (point - convex.center_m));
}

/// Nelder and Mead's simplex of three directions in the plane across `start`, begun anew where it has shrunk.
Direction climbed(const PlacedConvex& a, const PlacedConvex& b, const Vec3d& start, double step) {
    const Vec3d helper = std::abs(start.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = glm::normalize(glm::cross(start, helper));
    const Vec3d v = glm::cross(start, u);
    struct Try {
        glm::dvec2 at;
        double gap_m;
    };
    const auto normal_at = [&](const glm::dvec2& at) {
        return glm::normalize(start + u * at.x + v * at.y);
    };
    const auto tried = [&](const glm::dvec2& at) {
        return Try{at, gap_along(a, b, normal_at(at))};
    };
    Try best = tried({0, 0});
    for (double size = step; size > 1e-9; size *= 0.05) {
        std::array<Try, 3> corners{
            best, tried(best.at + glm::dvec2{size, 0}), tried(best.at + glm::dvec2{0, size})};
        for (int round = 0; round < 60; ++round) {
            std::ranges::sort(corners,
                              [](const Try& x, const Try& y) { return x.gap_m > y.gap_m; });
            const glm::dvec2 middle = (corners[0].at + corners[1].at) * 0.5;
            const glm::dvec2 out = middle - corners[2].at;
            if (glm::dot(out, out) < 1e-6 * size * size) break;
            const Try reflected = tried(middle + out);
            if (reflected.gap_m > corners[0].gap_m) {
                const Try farther = tried(middle + out * 2.0);
                corners[2] = farther.gap_m > reflected.gap_m ? farther : reflected;
            } else if (reflected.gap_m > corners[1].gap_m) {
                corners[2] = reflected;
            } else {
                const Try nearer = tried(middle - out * 0.5);
                if (nearer.gap_m > corners[2].gap_m) {
                    corners[2] = nearer;
                } else {
                    for (std::size_t i = 1; i < 3; ++i)
                        corners[i] = tried((corners[i].at + corners[0].at) * 0.5);
                }
            }
        }
        for (const Try& corner : corners) {
            if (corner.gap_m > best.gap_m) best = corner;
        }
    }
    return {normal_at(best.at), best.gap_m};
}

Direction widest_gap(const PlacedConvex& a, const PlacedConvex& b, int samples, int climbs) {
    std::vector<Direction> tried;
    for (const Vec3d& direction : hull_rig::sphere_corners(samples, 1))
        tried.push_back({direction, gap_along(a, b, direction)});
    std::ranges::sort(tried,
                      [](const Direction& x, const Direction& y) { return x.gap_m > y.gap_m; });
    Direction best = tried.front();
    const double step = 2 / std::sqrt(static_cast<double>(samples));
    std::vector<Vec3d> begun;
    for (const Direction& from : tried) {
        if (static_cast<int>(begun.size()) == climbs) break;
        if (std::ranges::any_of(begun, [&](const Vec3d& other) {
                return glm::dot(other, from.normal) > 1 - step * step;
            }))
            continue;
        begun.push_back(from.normal);
        const Direction found = climbed(a, b, from.normal, step);
        if (found.gap_m > best.gap_m) best = found;
    }
    return best;
}

}  // namespace plumbline::physics::convex_rig
