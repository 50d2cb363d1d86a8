#include "engine/physics/collision/body_geometry.h"

#include "engine/physics/collision/narrow_phase/placed_convex.h"
#include "engine/physics/transform.h"

namespace plumbline::physics {

Bounds bounds_of(const PlacedConvex& convex) {
    Bounds bounds;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d direction{0, 0, 0};
        direction[axis] = 1;
        bounds.high[axis] = support(convex, direction)[axis] + convex.radius_m;
        bounds.low[axis] = support(convex, -direction)[axis] - convex.radius_m;
    }
    return bounds;
}

Bounds bounds_of(const ConvexShape& shape, const Transform& at) {
    return bounds_of(placed_convex({shape, at}, Vec3d{0, 0, 0}));
}

Bounds moved(const Bounds& bounds, const Transform& at) {
    const glm::dmat3 r(at.rotation);
    const Vec3d middle = r * ((bounds.low + bounds.high) * 0.5) + Vec3d(at.position_m);
    const Vec3d half = (bounds.high - bounds.low) * 0.5;
    const Vec3d reach =
        magnitudes_of(r[0]) * half.x + magnitudes_of(r[1]) * half.y + magnitudes_of(r[2]) * half.z;
    return {middle - reach, middle + reach};
}

BodyGeometry moved(const BodyGeometry& geometry, const Transform& to_from_mass) {
    BodyGeometry result = geometry;
    for (GeometryPart& part : result.parts) {
        part.mass_from_part = to_from_mass * part.mass_from_part;
        part.bounds = bounds_of(part.shape, part.mass_from_part);
    }
    return result;
}

}  // namespace plumbline::physics
