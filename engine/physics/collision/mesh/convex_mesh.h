// Contact points of a convex shape and a triangle mesh, also of such as do not touch yet.
#pragma once

#include "engine/physics/collision/narrow_phase/point_choice.h"
#include "engine/physics/collision/shape/convex_shape.h"
#include "engine/physics/collision/shape/mesh_geometry.h"

#include <array>
#include <cstddef>
#include <vector>

namespace plumbline::physics {

struct MeshPatchPoint {
    Vec3 on_mesh{0, 0, 0};  ///< world
    Real distance_m{0};     ///< along the normal; negative: penetration
};

/// What a shape has with one face of a mesh, of however many triangles, or with one edge or corner.
struct MeshPatch {
    static constexpr std::size_t kMostPoints = PointChoice::kMost;

    Vec3 normal{0, 1, 0};  ///< unit, from the mesh to the shape
    std::array<MeshPatchPoint, kMostPoints> points{};
    std::size_t count{0};
};

/// Faces that one body can press on at once: a corner of a room has three.
inline constexpr std::size_t kMostMeshPatches = 4;

/// Replaces `patches` by those with points nearer than `reach_m`, the deepest first, at most kMostMeshPatches.
///
/// Triangles can be touched from both sides: a shape is on the one where its centre is, or in front where its
/// centre has only just sunk in. Edges and corners press only where they stick out, and only with normals
/// between those of the faces round them; edges within a surface are never felt.
void collide_with_mesh(const PlacedShape& convex,
                       const MeshGeometry& mesh,
                       const Transform& world_from_mesh,
                       Real reach_m,
                       std::vector<MeshPatch>& patches);

}  // namespace plumbline::physics
