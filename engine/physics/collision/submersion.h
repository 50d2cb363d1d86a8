// What of a body lies below a water level.
#pragma once

#include "engine/physics/collision/body_geometry.h"

namespace plumbline::physics {

/// The part of a body below a level plane. Volumes of boxes and hulls by Catto, "Exact Buoyancy for Polyhedra" (Game Programming
/// Gems 6, 2.5); of a sphere by the cap's formula; of other round shapes by discs along their axis, within 1e-6 of the volume.
/// Parts that overlap count twice. Areas of round shapes are those of facets, within 3 %.
struct Submersion {
    double volume_m3{0};
    Vec3d center_m{0, 0, 0};  ///< of the volume, world; of no meaning without one
    double whole_m3{0};       ///< of the body
    double waterline_m2{0};   ///< of the cut at the level
    double silhouette_m2{0};  ///< of what is below, along the direction that was asked for
};

/// `center_m`, `world_from_mass`: where the body's mass frame is. `direction` is unit, world.
Submersion submersion(const BodyGeometry& geometry,
                      const Vec3d& center_m,
                      const Quatd& world_from_mass,
                      double level_m,
                      const Vec3d& direction);

}  // namespace plumbline::physics
