// What of a model with animations collides, part by part: hulls of what its nodes carry, boxes of what
// bones carry.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/pose.h"
#include "engine/physics/shape.h"

#include <cstdint>
#include <string>
#include <vector>

namespace plumbline::scene {

struct PartShape {
    std::uint32_t node{0};
    std::string name;         ///< the node's; its number, where it has none or another has it too
    physics::HullShape hull;  ///< in the part's frame: see part_pose
};

/// At rest; `scale` is the entity's. Parts without extent are left out.
std::vector<PartShape> part_shapes_of(const assets::MovingModel& model, const Vec3& scale);

/// Where a part's frame is: the node's place, and its turn without stretch or shear.
Pose part_pose(const Mat4f& model_from_node, const Vec3& scale, const Pose& world_from_body);

}  // namespace plumbline::scene
