#include "engine/physics/medium.h"

#include "engine/physics/collision/silhouette.h"
#include "engine/physics/world/world_state.h"

namespace plumbline::physics {

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

Vec3d half_extent_m(const PhysicsWorld& world, BodyId id) {
    Vec3d half{0, 0, 0};
    for (const GeometryPart& part : internals(world).body(id).traits.geometry->parts)
        half = glm::max(half, glm::max(glm::abs(part.bounds.low), glm::abs(part.bounds.high)));
    return half;
}

}  // namespace plumbline::physics
