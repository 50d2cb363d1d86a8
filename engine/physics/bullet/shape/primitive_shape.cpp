#include "engine/physics/bullet/shape/primitive_shape.h"

#include "engine/physics/bullet/convert.h"

namespace plumbline::physics {

Primitive primitive_of(const btCollisionShape& shape) {
    switch (shape.getShapeType()) {
        case BOX_SHAPE_PROXYTYPE: {
            const auto& box = static_cast<const btBoxShape&>(shape);
            return {.kind = Primitive::Kind::Box,
                    .half_m = from_bullet(box.getHalfExtentsWithMargin())};
        }
        case SPHERE_SHAPE_PROXYTYPE: {
            const auto& sphere = static_cast<const btSphereShape&>(shape);
            return {.kind = Primitive::Kind::Sphere, .radius_m = sphere.getRadius()};
        }
        case CAPSULE_SHAPE_PROXYTYPE: {
            const auto& capsule = static_cast<const btCapsuleShape&>(shape);
            return {.kind = Primitive::Kind::Capsule,
                    .radius_m = capsule.getRadius(),
                    .half_height_m = capsule.getHalfHeight()};
        }
        default:
            return {};
    }
}

}  // namespace plumbline::physics
