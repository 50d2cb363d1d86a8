// What of a body lies below a water level.
#pragma once

#include "engine/physics/collision/body_geometry.h"
#include "engine/physics/medium.h"

namespace plumbline::physics {

/// `center_m`, `world_from_mass`: where the body's mass frame is. `direction` is unit, world.
Submersion submersion(const BodyGeometry& geometry,
                      const Vec3d& center_m,
                      const Quatd& world_from_mass,
                      double level_m,
                      const Vec3d& direction);

}  // namespace plumbline::physics
