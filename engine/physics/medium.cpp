#include "engine/physics/medium.h"

#include "engine/physics/collision/shape/hull_geometry.h"
#include "engine/physics/collision/silhouette.h"
#include "engine/physics/collision/submersion.h"
#include "engine/physics/world/world_state.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

/// Of the farthest point from the shape's origin.
double reach_m(const ConvexShape& shape) {
    const auto r = static_cast<double>(shape.radius_m);
    const auto half = static_cast<double>(shape.half_height_m);
    switch (shape.kind) {
        case ConvexShape::Kind::None:
            return 0;
        case ConvexShape::Kind::Sphere:
            return r;
        case ConvexShape::Kind::Capsule:
            return half + r;
        case ConvexShape::Kind::Box:
            return glm::length(Vec3d(shape.half_m));
        case ConvexShape::Kind::Cylinder:
        case ConvexShape::Kind::Cone:
            return std::sqrt(r * r + half * half);
        case ConvexShape::Kind::Hull: {
            double most = 0;
            for (const Vec3d& corner : shape.hull->corners_m)
                most = std::max(most, glm::length(corner));
            return most;
        }
    }
    return 0;
}

}  // namespace

double silhouette_m2(const PhysicsWorld& world, BodyId id, const Vec3d& direction_mass) {
    return silhouette_m2(*internals(world).body(id).traits.geometry, direction_mass);
}

Submersion submersion(const PhysicsWorld& world,
                      BodyId id,
                      const Vec3d& center_m,
                      const Quatd& world_from_mass,
                      double level_m,
                      const Vec3d& direction) {
    return submersion(
        *internals(world).body(id).traits.geometry, center_m, world_from_mass, level_m, direction);
}

Quatd mass_from_body(const PhysicsWorld& world, BodyId id) {
    return glm::conjugate(Quatd(internals(world).body(id).traits.body_from_mass.orientation));
}

std::size_t part_count(const PhysicsWorld& world, BodyId id) {
    return internals(world).body(id).traits.geometry->parts.size();
}

double radius_m(const PhysicsWorld& world, BodyId id) {
    double radius = 0;
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts) {
        const double away = glm::length(Vec3d(part.mass_from_part.position_m));
        radius = std::max(radius, away + reach_m(part.shape));
    }
    return radius;
}

Vec3d half_extent_m(const PhysicsWorld& world, BodyId id) {
    Vec3d half{0, 0, 0};
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts)
        half = glm::max(half, glm::max(glm::abs(part.bounds.low), glm::abs(part.bounds.high)));
    return half;
}

}  // namespace plumbline::physics
