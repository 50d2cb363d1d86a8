// Bullet's collision shapes as our descriptions of them.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/shape.h"

class btCollisionShape;

namespace plumbline::bullet_world {

/// A plane of Bullet's has no end; ours ends so far from its origin.
inline constexpr Real kPlaneHalf_m = 1000;

struct ForeignShape {
    physics::ShapeDef def;
    Pose object_from_shape{};  ///< not the identity for planes only, which are static
    bool is_mesh{false};       ///< or a plane: for bodies that are not dynamic
};

/// The shape in the frame of its object, without Bullet's margin where that is around the shape (hulls,
/// meshes). What has no description of ours becomes the hull of its outermost points. `dynamic`: a mesh
/// becomes a hull too. Refused: shapes without a surface.
Result<ForeignShape> foreign_shape(const btCollisionShape& shape, bool dynamic);

/// False: it touches nothing; bodies of such shapes are ends of constraints.
bool has_surface(const btCollisionShape& shape);

/// Of all its numbers: equal shapes have equal ones.
std::uint64_t shape_hash(const physics::ShapeDef& def);

}  // namespace plumbline::bullet_world
