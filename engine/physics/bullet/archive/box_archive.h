// The broad phase as fields of an archive.
#pragma once

#include "engine/core/io/archive.h"

#include <btBulletDynamicsCommon.h>

#include <vector>

namespace plumbline::physics {

struct BodyRecord;

/// Boxes as the broad phase holds them, and which of its lists each body is in. `in_world` are the
/// bodies behind its proxies; when read, they have proxies with no pairs yet.
void serialize_boxes(Archive& archive,
                     btDbvtBroadphase& broadphase,
                     const std::vector<BodyRecord*>& in_world);

}  // namespace plumbline::physics
