// Convex solids by their faces, cut by planes.
#pragma once

#include "engine/physics/collision/shape/mass.h"
#include "engine/physics/fracture.h"

namespace plumbline::physics {

struct ConvexShape;

/// Round shapes become prisms and balls of facets. Empty for Kind::None.
Polyhedron polyhedron_of(const ConvexShape& shape);

/// Leaves what is below the plane (dot(normal, x) <= offset_m), with a new face there that has `beyond`.
void cut(Polyhedron& solid, const Vec3d& normal, double offset_m, int beyond);

SolidMass mass_of(const Polyhedron& solid);

}  // namespace plumbline::physics
