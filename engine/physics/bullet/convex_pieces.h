// each_convex() of convex_query.h: include that one.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleShape.h>

namespace plumbline::physics {

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
