// How large a body looks from a direction: what a stream along it pushes against.
#pragma once

#include "engine/physics/collision/body_geometry.h"

namespace plumbline::physics {

/// m2, of the shape's parallel projection along the unit `direction` (the shape's frame; either way round). Round shapes in
/// closed form, hulls by half the sum of their faces' areas (Cauchy).
double silhouette_m2(const ConvexShape& shape, const Vec3d& direction);

/// Of all parts together, what lies behind another one counted once: by 256 lines across, within half a per cent. Of a mesh: 0.
double silhouette_m2(const BodyGeometry& geometry, const Vec3d& direction_mass);

}  // namespace plumbline::physics
