// A triangle mesh's corners, faces and edges, made once when its shape is made.
#pragma once

#include "engine/physics/collision/shape/box_tree.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::physics {

/// What two triangles make at the edge between them, seen from the front of one of them.
enum class EdgeKind : std::uint8_t {
    Flat,     ///< they go on in one plane
    Convex,   ///< the other falls away: the edge sticks out
    Concave,  ///< the other rises: the edge lies in a valley
    Rim,      ///< no other triangle, or more than one
};

/// Its corners are counter-clockwise from the front.
struct MeshTriangle {
    std::array<std::uint32_t, 3> corners{};  ///< of MeshGeometry::corners_m
    std::array<EdgeKind, 3>
        edges{};                 ///< from corner i to the next; whichever way the other is wound
    bool has_two_fronts{false};  ///< it was there once more, wound the other way
    std::uint32_t source{0};     ///< its index among those the mesh was made from
};

struct MeshGeometry {
    std::vector<Vec3> corners_m;  ///< no two at one place
    std::vector<MeshTriangle> triangles;
    BoxTree tree;  ///< of the triangles

    Vec3d corner_m(const MeshTriangle& triangle, std::size_t i) const {
        return Vec3d(corners_m[triangle.corners[i]]);
    }
};

/// Triangles that lie within this angle of each other go on in one plane.
inline constexpr double kFlatEdge_rad = 1e-3;
/// Triangles lower than this share of their longest edge have no area.
inline constexpr double kNoHeight = 1e-6;

/// Triangles without area are left out, and those that repeat an earlier one. Corners are finite.
MeshGeometry mesh_geometry(std::span<const Vec3> corners_m,
                           std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace plumbline::physics
