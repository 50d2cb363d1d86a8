// Bullet's shapes as primitives.
#pragma once

#include "engine/physics/collision/narrow_phase/primitive.h"

#include <btBulletCollisionCommon.h>

namespace plumbline::physics {

/// Of kind None where the shape is neither a box nor a sphere nor a capsule.
Primitive primitive_of(const btCollisionShape& shape);

}  // namespace plumbline::physics
