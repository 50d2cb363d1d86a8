// Distances and casts of convex shapes against whatever the world holds.
//
// Bullet's own casts stop 1 mm short and answer by shape type; these advance by exact distances and
// treat boxes, triangles and children of compounds alike.
#pragma once

#include "engine/physics/bullet/cast.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <btBulletCollisionCommon.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::physics {

/// Closest points of two convex shapes. The normal is unit and points from b to a.
struct ClosestPoints {
    btVector3 normal{0, 1, 0};
    btVector3 point_on_b{0, 0, 0};
    btScalar distance{0};  ///< negative: penetration
};

/// What a cast hit first.
struct CastHit {
    btScalar fraction{1};
    btVector3 normal{0, 1, 0};  ///< from the body hit to the moving shape
    btVector3 point{0, 0, 0};
    const BodyRecord* record{nullptr};
};

/// The expanding polytope gives up on shapes that stand in each other by kilometres and says nothing of
/// use; trying directions, which is slower, does not.
enum class AtDepth : std::uint8_t { Usual, Any };

/// None when they are farther apart than max_distance.
std::optional<ClosestPoints> closest_points(const btConvexShape& a,
                                            const btTransform& world_from_a,
                                            const btConvexShape& b,
                                            const btTransform& world_from_b,
                                            btScalar max_distance,
                                            AtDepth at_depth = AtDepth::Usual);

/// Bodies whose boxes touch the given box, in the order of their ids.
std::vector<const BodyRecord*> bodies_in_box(const btCollisionWorld& world,
                                             const btVector3& box_min,
                                             const btVector3& box_max,
                                             const BodyFilter& filter);

/// The first body hit by `moving` on its way. A shape that overlaps at the start is stopped at
/// fraction 0 only if the motion goes deeper.
std::optional<CastHit> cast_among(const btCollisionWorld& world,
                                  const btConvexShape& moving,
                                  const btTransform& from,
                                  const btVector3& motion,
                                  const BodyFilter& filter);

/// The first body that a ray hits from outside; one that it starts in is not hit.
std::optional<CastHit> ray_among(const btCollisionWorld& world,
                                 const btVector3& from,
                                 const btVector3& to,
                                 const BodyFilter& filter);

template <class Fn>
class TrianglePieces final : public btTriangleCallback {
public:
    TrianglePieces(const btTransform& world_from_shape, Fn& fn)
        : world_from_shape_(world_from_shape), fn_(fn) {}

    void processTriangle(btVector3* corners, int, int) override {
        btTriangleShape triangle(corners[0], corners[1], corners[2]);
        triangle.setMargin(0);
        fn_(static_cast<const btConvexShape&>(triangle), world_from_shape_);
    }

private:
    const btTransform& world_from_shape_;
    Fn& fn_;
};

/// Every convex piece of `shape` within the box, as (piece, world_from_piece): the shape itself, a
/// compound's children, a mesh's triangles.
template <class Fn>
void each_convex(const btCollisionShape& shape,
                 const btTransform& world_from_shape,
                 const btVector3& box_min,
                 const btVector3& box_max,
                 Fn&& fn) {
    btVector3 shape_min;
    btVector3 shape_max;
    shape.getAabb(world_from_shape, shape_min, shape_max);
    if (!TestAabbAgainstAabb2(box_min, box_max, shape_min, shape_max)) return;
    if (shape.isConvex()) {
        fn(static_cast<const btConvexShape&>(shape), world_from_shape);
    } else if (shape.isCompound()) {
        const auto& compound = static_cast<const btCompoundShape&>(shape);
        for (int i = 0; i < compound.getNumChildShapes(); ++i) {
            each_convex(*compound.getChildShape(i),
                        world_from_shape * compound.getChildTransform(i),
                        box_min,
                        box_max,
                        fn);
        }
    } else if (shape.isConcave()) {
        // The box seen from the mesh: its half extents through the rotation's absolute values.
        const btTransform shape_from_world = world_from_shape.inverse();
        const btVector3 half = (box_max - box_min) * btScalar(0.5);
        const btVector3 middle = shape_from_world((box_max + box_min) * btScalar(0.5));
        const btVector3 extent = half.dot3(shape_from_world.getBasis()[0].absolute(),
                                           shape_from_world.getBasis()[1].absolute(),
                                           shape_from_world.getBasis()[2].absolute());
        TrianglePieces<Fn> pieces(world_from_shape, fn);
        static_cast<const btConcaveShape&>(shape).processAllTriangles(
            &pieces, middle - extent, middle + extent);
    }
}

}  // namespace plumbline::physics
