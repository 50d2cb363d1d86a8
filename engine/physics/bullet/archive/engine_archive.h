// Bullet's side of a world as fields of an archive, in plain types.
#pragma once

#include "engine/physics/world/body_scope.h"

namespace plumbline::physics {

class BulletEngine;

/// A body's sleep; mass, materials and shape are those of its definition, its motion has been read.
void serialize_rigid(Archive& archive, BodyRecord& record);
/// Who is in the world, in which order, the constraints of joints, boxes, pairs and contacts. When
/// read, the engine is new and empty, and bodies and joints have been read.
void serialize_engine(Archive& archive,
                      BulletEngine& engine,
                      const BodyScope& scope,
                      const JointTable& joints);

}  // namespace plumbline::physics
