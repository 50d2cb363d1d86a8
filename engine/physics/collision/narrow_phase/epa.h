// How two convex cores that overlap part most easily.
#pragma once

#include "engine/physics/collision/narrow_phase/gjk.h"

namespace plumbline::physics {

/// Where two cores that overlap part most easily.
struct Penetration {
    Vec3d normal{0, 1, 0};  ///< unit, from b to a
    double depth_m{0};
    Vec3d on_a{0, 0, 0};
    Vec3d on_b{0, 0, 0};
};

/// By the expanding polytope (van den Bergen 2003, "Collision Detection in Interactive 3D Environments",
/// 4.3.8), from the simplex in which closest_points() found the origin.
Penetration penetration_of(const PlacedConvex& a, const PlacedConvex& b, const Simplex& simplex);

}  // namespace plumbline::physics
