#include "engine/physics/fracture/polyhedron.h"

#include "engine/physics/collision/shape/convex_shape.h"
#include "engine/physics/collision/shape/hull_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace plumbline::physics {
namespace {

constexpr int kSides = 24;  ///< of what stands for a circle
constexpr int kRings = 8;   ///< of half a ball
constexpr int kStretchRounds = 60;
constexpr double kEnough = 1 + 1e-12;
/// Of the solid's extent: nearer to a plane is on it.
constexpr double kOnPlane = 1e-9;

Polyhedron facets_of_box(const Vec3d& half_m) {
    Polyhedron solid;
    for (int i = 0; i < 8; ++i)
        solid.corners_m.push_back(
            half_m * Vec3d{(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1});
    for (const auto& corners : {std::array{0U, 4U, 6U, 2U},
                                std::array{1U, 3U, 7U, 5U},
                                std::array{0U, 1U, 5U, 4U},
                                std::array{2U, 6U, 7U, 3U},
                                std::array{0U, 2U, 3U, 1U},
                                std::array{4U, 5U, 7U, 6U}})
        solid.faces.push_back({.corners = {corners.begin(), corners.end()}});
    return solid;
}

/// Corners round +Y.
std::vector<Vec3d> ring_at(double radius_m, double y_m) {
    std::vector<Vec3d> points;
    for (int i = 0; i < kSides; ++i) {
        const double turn_rad = 2 * glm::pi<double>() * i / kSides;
        points.emplace_back(
            radius_m * portable_cos(turn_rad), y_m, radius_m * portable_sin(turn_rad));
    }
    return points;
}

/// Between two levels or points, from the bottom up: rings of one corner are points.
Polyhedron lathed(const std::vector<std::vector<Vec3d>>& rings) {
    Polyhedron solid;
    std::vector<std::vector<std::uint32_t>> at;
    for (const std::vector<Vec3d>& points : rings) {
        auto& numbers = at.emplace_back();
        for (const Vec3d& point : points) {
            numbers.push_back(static_cast<std::uint32_t>(solid.corners_m.size()));
            solid.corners_m.push_back(point);
        }
    }
    for (std::size_t r = 0; r + 1 < at.size(); ++r) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(kSides); ++i) {
            const std::size_t next = (i + 1) % kSides;
            std::vector<std::uint32_t> corners{at[r][i % at[r].size()]};
            if (at[r + 1].size() > 1) corners.push_back(at[r + 1][i]);
            corners.push_back(at[r + 1][next % at[r + 1].size()]);
            if (at[r].size() > 1) corners.push_back(at[r][next]);
            solid.faces.push_back({.corners = std::move(corners)});
        }
    }
    if (at.front().size() > 1) solid.faces.push_back({.corners = at.front()});
    if (at.back().size() > 1)
        solid.faces.push_back({.corners = {at.back().rbegin(), at.back().rend()}});
    return solid;
}

/// A ball cut in half, its halves so far from the middle.
Polyhedron facets_of_capsule(double radius_m, double half_height_m) {
    std::vector<std::vector<Vec3d>> rings{{{0, -half_height_m - radius_m, 0}}};
    for (const double side : {-1.0, 1.0}) {
        for (int i = 0; i < kRings; ++i) {
            const double up_rad = glm::half_pi<double>() * (side < 0 ? i - kRings + 1 : i) / kRings;
            if (half_height_m == 0 && side > 0 && i == 0) continue;
            rings.push_back(ring_at(radius_m * portable_cos(up_rad),
                                    side * half_height_m + radius_m * portable_sin(up_rad)));
        }
    }
    rings.push_back({{0, half_height_m + radius_m, 0}});
    return lathed(rings);
}

Polyhedron facets_of_hull(const HullGeometry& hull) {
    Polyhedron solid{.corners_m = {hull.corners_m.begin(), hull.corners_m.end()}};
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.corners_of(face);
        solid.faces.push_back({.corners = {corners.begin(), corners.end()}});
    }
    return solid;
}

/// The face without what is above the plane. `crossings`: corners made on edges, by their ends.
void clip_face(Polyhedron& solid,
               PolyhedronFace& face,
               const std::vector<double>& above_m,
               double on_m,
               std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& crossings) {
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const std::uint32_t a = face.corners[i];
        const std::uint32_t b = face.corners[(i + 1) % face.corners.size()];
        if (above_m[a] <= on_m) kept.push_back(a);
        if (!((above_m[a] < -on_m && above_m[b] > on_m) ||
              (above_m[a] > on_m && above_m[b] < -on_m)))
            continue;
        const auto [low, high] = std::minmax(a, b);
        const auto next = static_cast<std::uint32_t>(solid.corners_m.size());
        const auto [known, is_new] = crossings.emplace(std::pair{low, high}, next);
        if (is_new) {
            const double share = above_m[low] / (above_m[low] - above_m[high]);
            solid.corners_m.push_back(glm::mix(solid.corners_m[low], solid.corners_m[high], share));
        }
        kept.push_back(known->second);
    }
    face.corners = std::move(kept);
}

/// Counter-clockwise about the normal.
void sort_around(const std::vector<Vec3d>& corners_m,
                 const Vec3d& normal,
                 std::vector<std::uint32_t>& corners) {
    Vec3d middle_m{0, 0, 0};
    for (const std::uint32_t corner : corners) middle_m += corners_m[corner];
    middle_m /= static_cast<double>(corners.size());
    const Vec3d x = glm::normalize(
        glm::cross(std::abs(normal.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal));
    const Vec3d y = glm::cross(normal, x);
    // Rises with the angle, from 0 to 4.
    const auto turn = [&](std::uint32_t corner) {
        const Vec3d arm_m = corners_m[corner] - middle_m;
        const double along = glm::dot(arm_m, x);
        const double across = glm::dot(arm_m, y);
        const double share = along / (std::abs(along) + std::abs(across));
        return across >= 0 ? 1 - share : 3 + share;
    };
    std::ranges::sort(corners, {}, turn);
}

/// Only the corners that faces have.
void drop_unused(Polyhedron& solid) {
    std::vector<std::uint32_t> number(solid.corners_m.size(), ~0U);
    std::vector<Vec3d> kept_m;
    for (PolyhedronFace& face : solid.faces) {
        for (std::uint32_t& corner : face.corners) {
            if (number[corner] == ~0U) {
                number[corner] = static_cast<std::uint32_t>(kept_m.size());
                kept_m.push_back(solid.corners_m[corner]);
            }
            corner = number[corner];
        }
    }
    solid.corners_m = std::move(kept_m);
}

/// Along the axes where `grows` is 1, until no moment for its volume is below that of `round`: what spins gains nothing as it falls
/// into facets.
Polyhedron stretched(Polyhedron solid, const SolidMass& round, const Vec3d& grows) {
    const auto most = [&] {
        const SolidMass mass = mass_of(solid);
        double share = 0;
        for (int axis = 0; axis < 3; ++axis)
            share = std::max(share,
                             round.inertia[axis][axis] / round.volume_m3 /
                                 (mass.inertia[axis][axis] / mass.volume_m3));
        return share;
    };
    for (int i = 0; i < kStretchRounds; ++i) {
        const Vec3d by = Vec3d{1.0} + grows * ((most() * kEnough - 1) / 2);
        for (Vec3d& corner : solid.corners_m) corner *= by;
    }
    return solid;
}

}  // namespace

Polyhedron polyhedron_of(const ConvexShape& shape) {
    const auto radius_m = static_cast<double>(shape.radius_m);
    const auto half_m = static_cast<double>(shape.half_height_m);
    switch (shape.kind) {
        case ConvexShape::Kind::None:
            return {};
        case ConvexShape::Kind::Box:
            return facets_of_box(Vec3d(shape.half_m));
        case ConvexShape::Kind::Sphere:
            return stretched(facets_of_capsule(radius_m, 0), mass_of_sphere(radius_m), {1, 1, 1});
        case ConvexShape::Kind::Capsule:
            return stretched(facets_of_capsule(radius_m, half_m),
                             mass_of_capsule(radius_m, 2 * half_m),
                             {1, 1, 1});
        case ConvexShape::Kind::Cylinder:
            return stretched(lathed({ring_at(radius_m, -half_m), ring_at(radius_m, half_m)}),
                             mass_of_cylinder(radius_m, 2 * half_m),
                             {1, 0, 1});
        case ConvexShape::Kind::Cone:
            return stretched(lathed({ring_at(radius_m, -half_m), {{0, half_m, 0}}}),
                             mass_of_cone(radius_m, 2 * half_m),
                             {1, 0, 1});
        case ConvexShape::Kind::Hull:
            return facets_of_hull(*shape.hull);
    }
    return {};
}

void cut(Polyhedron& solid, const Vec3d& normal, double offset_m, int beyond) {
    std::vector<double> above_m;
    double least_m = 0;
    double most_m = 0;
    for (const Vec3d& corner : solid.corners_m) {
        above_m.push_back(glm::dot(normal, corner) - offset_m);
        least_m = std::min(least_m, above_m.back());
        most_m = std::max(most_m, above_m.back());
    }
    const double on_m = kOnPlane * (most_m - least_m);
    if (most_m <= on_m) return;
    if (least_m >= -on_m) {
        solid = {};
        return;
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
    for (PolyhedronFace& face : solid.faces) clip_face(solid, face, above_m, on_m, crossings);
    std::erase_if(solid.faces, [](const PolyhedronFace& face) { return face.corners.size() < 3; });
    PolyhedronFace lid{.beyond = beyond};
    for (const auto& [edge, corner] : crossings) lid.corners.push_back(corner);
    for (std::uint32_t corner = 0; corner < above_m.size(); ++corner) {
        if (std::abs(above_m[corner]) <= on_m) lid.corners.push_back(corner);
    }
    if (lid.corners.size() >= 3) {
        sort_around(solid.corners_m, normal, lid.corners);
        solid.faces.push_back(std::move(lid));
    }
    drop_unused(solid);
}

SolidMass mass_of(const Polyhedron& solid) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const PolyhedronFace& face : solid.faces) {
        for (std::size_t i = 2; i < face.corners.size(); ++i)
            triangles.push_back({face.corners[0], face.corners[i - 1], face.corners[i]});
    }
    return mass_of_triangles(solid.corners_m, triangles);
}

}  // namespace plumbline::physics
