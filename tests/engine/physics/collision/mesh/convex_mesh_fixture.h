// Meshes, shapes and checks for the tests of convex_mesh.
#pragma once

#include "engine/physics/collision/mesh/convex_mesh.h"
#include "engine/physics/collision/shape/hull_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace plumbline::physics {

using Kind = ConvexShape::Kind;
using Triangle = std::array<std::uint32_t, 3>;
using Patches = std::vector<MeshPatch>;

inline constexpr bool kIsFloat = sizeof(Real) == sizeof(float);
/// What places a few metres from the origin are known to.
inline constexpr double kNear_m = kIsFloat ? 2e-6 : 1e-12;
inline constexpr Real kMeshReach_m = 0.02_r;

inline const ConvexShape kBall{.kind = Kind::Sphere, .radius_m = 0.25_r};
inline const ConvexShape kBox{.kind = Kind::Box, .half_m = {0.5_r, 0.2_r, 0.3_r}};
inline const ConvexShape kRod{.kind = Kind::Capsule, .radius_m = 0.1_r, .half_height_m = 0.4_r};
inline const ConvexShape kDrum{.kind = Kind::Cylinder, .radius_m = 0.3_r, .half_height_m = 0.2_r};

struct Soup {
    std::vector<Vec3> corners;
    std::vector<Triangle> triangles;

    MeshGeometry mesh() const { return mesh_geometry(corners, triangles); }
    /// Counter-clockwise from the front.
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        corners.insert(corners.end(), {a, b, c});
        triangles.push_back({first, first + 1, first + 2});
    }
    void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        add(a, b, c);
        add(a, c, d);
    }
};

/// `cells` squared, round the origin, its front up.
inline Soup grid(std::uint32_t cells,
                 Real cell_m,
                 const std::function<Real(Real, Real)>& height_m) {
    Soup soup;
    const Real half_m = static_cast<Real>(cells) * cell_m / 2;
    for (std::uint32_t z = 0; z <= cells; ++z) {
        for (std::uint32_t x = 0; x <= cells; ++x) {
            const Real at_x = static_cast<Real>(x) * cell_m - half_m;
            const Real at_z = static_cast<Real>(z) * cell_m - half_m;
            soup.corners.push_back({at_x, height_m(at_x, at_z), at_z});
        }
    }
    for (std::uint32_t z = 0; z < cells; ++z) {
        for (std::uint32_t x = 0; x < cells; ++x) {
            const std::uint32_t i = z * (cells + 1) + x;
            const std::uint32_t below = i + cells + 1;
            soup.triangles.push_back({i, below, i + 1});
            soup.triangles.push_back({i + 1, below, below + 1});
        }
    }
    return soup;
}

inline Soup flat_grid(std::uint32_t cells, Real cell_m) {
    return grid(cells, cell_m, [](Real, Real) { return Real{0}; });
}

/// A roof or a gutter along z: `slope` up or down from x = 0 to both sides.
inline Soup fold(Real slope) {
    return grid(4, 1, [slope](Real x, Real) { return slope * std::abs(x); });
}

/// A closed box, its fronts outward.
inline Soup block(const Vec3& half) {
    Soup soup;
    for (int axis = 0; axis < 3; ++axis) {
        for (const Real side : {-1.0_r, 1.0_r}) {
            const auto corner = [&](Real u, Real v) {
                Vec3 at{0, 0, 0};
                at[axis] = side * half[axis];
                at[(axis + 1) % 3] = u * half[(axis + 1) % 3];
                at[(axis + 2) % 3] = v * half[(axis + 2) % 3] * side;
                return at;
            };
            soup.add_quad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
        }
    }
    return soup;
}

inline Mat3 turned(const Vec3& axis, Real angle_rad) {
    return glm::mat3_cast(portable_angle_axis(angle_rad, glm::normalize(axis)));
}

inline Patches meet(const ConvexShape& shape,
                    const Transform& at,
                    const MeshGeometry& mesh,
                    const Transform& world_from_mesh = {},
                    Real reach_m = kMeshReach_m) {
    Patches patches;
    collide_with_mesh({shape, at}, mesh, world_from_mesh, reach_m, patches);
    for (const MeshPatch& patch : patches) {
        EXPECT_NEAR(glm::length(patch.normal), 1, 1e-6);
        EXPECT_GT(patch.count, 0U);
        for (std::size_t i = 0; i < patch.count; ++i) {
            EXPECT_TRUE(is_finite(patch.points[i].on_mesh));
            EXPECT_LE(patch.points[i].distance_m, reach_m);
        }
    }
    return patches;
}

inline double deepest(const Patches& patches) {
    double least = std::numeric_limits<double>::max();
    for (const MeshPatch& patch : patches) {
        for (std::size_t i = 0; i < patch.count; ++i)
            least = std::min(least, static_cast<double>(patch.points[i].distance_m));
    }
    return least;
}

inline void expect_near(const Vec3& found, const Vec3& wanted, double near) {
    EXPECT_NEAR(glm::distance(found, wanted), 0, near)
        << found.x << ' ' << found.y << ' ' << found.z << " is not " << wanted.x << ' ' << wanted.y
        << ' ' << wanted.z;
}

inline std::string text_of(const Patches& patches) {
    std::ostringstream text;
    for (const MeshPatch& patch : patches) {
        text << "\nnormal " << patch.normal.x << ' ' << patch.normal.y << ' ' << patch.normal.z;
        for (std::size_t i = 0; i < patch.count; ++i) {
            const MeshPatchPoint& point = patch.points[i];
            text << "\n  " << point.on_mesh.x << ' ' << point.on_mesh.y << ' ' << point.on_mesh.z
                 << " at " << point.distance_m;
        }
    }
    return text.str();
}

struct Octagon {
    static constexpr Real kRadius_m = 0.4_r;
    static constexpr Real kHalf_m = 0.15_r;
    HullGeometry hull;
    ConvexShape shape{.kind = Kind::Hull};

    Octagon() {
        std::vector<Vec3d> corners;
        std::vector<Triangle> triangles;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const double angle = i * std::acos(-1.0) / 4;
            const double radius = static_cast<double>(kRadius_m);
            const double half = static_cast<double>(kHalf_m);
            corners.push_back({radius * std::cos(angle), -half, radius * std::sin(angle)});
            corners.push_back({radius * std::cos(angle), half, radius * std::sin(angle)});
            const std::uint32_t low = 2 * i;
            const std::uint32_t next = 2 * ((i + 1) % 8);
            triangles.push_back({low, low + 1, next});
            triangles.push_back({next, low + 1, next + 1});
            if (i == 0 || i == 7) continue;
            triangles.push_back({0, low, next});
            triangles.push_back({1, next + 1, low + 1});
        }
        hull = hull_geometry(corners, triangles);
        shape.hull = &hull;
    }
    Octagon(const Octagon&) = delete;
    Octagon& operator=(const Octagon&) = delete;
};

}  // namespace plumbline::physics
