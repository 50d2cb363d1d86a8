// A mesh as the narrow phase sees it: in the frame of one call, in double precision.
#pragma once

#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/collision/shape/mesh_geometry.h"

#include <array>
#include <cstdint>

namespace plumbline::physics {

/// The frame's axes are the world's, its origin is the convex shape's centre.
struct PlacedMesh {
    const MeshGeometry& mesh;
    glm::dmat3 axes{1.0};
    Vec3d origin_m{0, 0, 0};  ///< the mesh's own
    glm::dmat3 mesh_from_frame{1.0};

    PlacedMesh(const MeshGeometry& geometry,
               const Transform& world_from_mesh,
               const Vec3d& origin_world)
        : mesh(geometry),
          axes(world_from_mesh.rotation),
          origin_m(Vec3d(world_from_mesh.position_m) - origin_world),
          mesh_from_frame(glm::inverse(axes)) {}

    Vec3d corner_m(std::uint32_t corner) const {
        return axes * Vec3d(mesh.corners_m[corner]) + origin_m;
    }
    std::array<Vec3d, 3> corners_m(std::uint32_t triangle) const {
        const auto& [a, b, c] = mesh.triangles[triangle].corners;
        return {corner_m(a), corner_m(b), corner_m(c)};
    }
    /// Calls `on_triangle(index)` for each that may be as near to the place as said.
    template <class OnTriangle>
    void visit_round(const Vec3d& place, double near_m, const OnTriangle& on_triangle) const {
        const Vec3d center = mesh_from_frame * (place - origin_m);
        mesh.tree.visit({center - near_m, center + near_m}, on_triangle);
    }
    /// A box in the mesh's own frame round all that is nearer than `reach_m` to the shape.
    Bounds bounds_round(const PlacedConvex& convex, double reach_m) const {
        const Vec3d center = mesh_from_frame * -origin_m;
        Bounds bounds{center, center};
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3d along = glm::transpose(mesh_from_frame)[axis];
            const double round_m = convex.radius_m + reach_m;
            bounds.low[axis] += glm::dot(support(convex, -along), along) - round_m;
            bounds.high[axis] += glm::dot(support(convex, along), along) + round_m;
        }
        return bounds;
    }
};

/// A place where a convex shape is near a mesh.
struct MeshPoint {
    enum class Kind : std::uint8_t {
        Face,
        Seam,  ///< inside a face of several triangles: only the deepest say more than the face's corners
        Edge,  ///< an edge or a corner that sticks out
    };

    Vec3d normal{0, 1, 0};  ///< unit, from the mesh to the shape
    Vec3d on_mesh{0, 0, 0};
    double distance_m{0};
    std::uint32_t triangle{0};
    Kind kind{Kind::Face};
    bool is_behind{false};  ///< at the back of its triangle
};

}  // namespace plumbline::physics
