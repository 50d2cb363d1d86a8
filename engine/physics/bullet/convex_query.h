// Distances and casts of convex shapes against whatever the world holds.
//
// Bullet's own casts stop 1 mm short and answer by shape type; these advance by exact distances and
// treat boxes, triangles and children of compounds alike.
#pragma once

#include <btBulletCollisionCommon.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;

/// Closest points of two convex shapes. The normal is unit and points from b to a.
struct ClosestPoints {
    btVector3 normal{0, 1, 0};
    btVector3 point_on_b{0, 0, 0};
    btScalar distance{0};  ///< negative: overlap
};

/// What a cast met first.
struct CastHit {
    btScalar fraction{1};
    btVector3 normal{0, 1, 0};  ///< from the body hit to the moving shape
    btVector3 point{0, 0, 0};
    const BodyRecord* record{nullptr};
};

/// Bodies that a cast or overlap sees. Groups must agree both ways.
struct BodyFilter {
    std::uint32_t group{~0U};
    std::uint32_t collides_with{~0U};
    const BodyRecord* ignored{nullptr};  ///< and what joints keep it from touching
    const BodyRecord* also_ignored{nullptr};
    std::uint32_t unseen_group{0};  ///< BodyRecord::sweep_group; 0: none

    bool sees(const BodyRecord& record) const;
};

/// None when they are farther apart than max_distance.
std::optional<ClosestPoints> closest_points(const btConvexShape& a,
                                            const btTransform& world_from_a,
                                            const btConvexShape& b,
                                            const btTransform& world_from_b,
                                            btScalar max_distance);

/// Bodies whose boxes touch the given box, in the order of their ids.
std::vector<const BodyRecord*> bodies_in_box(const btCollisionWorld& world,
                                             const btVector3& box_min,
                                             const btVector3& box_max,
                                             const BodyFilter& filter);

/// The first thing met by `moving` on its way. A shape that overlaps at the start is stopped at
/// fraction 0 only if the motion goes deeper.
std::optional<CastHit> cast_among(const btCollisionWorld& world,
                                  const btConvexShape& moving,
                                  const btTransform& from,
                                  const btVector3& motion,
                                  const BodyFilter& filter);

/// The first thing a ray meets from outside; what it starts in is not met.
std::optional<CastHit> ray_among(const btCollisionWorld& world,
                                 const btVector3& from,
                                 const btVector3& to,
                                 const BodyFilter& filter);

/// Every convex piece of `shape` within the box, as (piece, world_from_piece): the shape itself, a
/// compound's children, a mesh's triangles.
template <class Fn>
void each_convex(const btCollisionShape& shape,
                 const btTransform& world_from_shape,
                 const btVector3& box_min,
                 const btVector3& box_max,
                 Fn&& fn);

}  // namespace plumbline::physics

#include "engine/physics/bullet/convex_pieces.h"
