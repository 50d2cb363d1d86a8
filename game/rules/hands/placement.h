// Finding room for something that is about to appear.
#pragma once

#include "engine/physics/physics_world.h"
#include "game/rules/hands/aim.h"

#include <optional>

namespace plumbline::game {

/// What is to appear: a box around it, turned by the person's yaw.
struct Room {
    physics::ShapeId box{};
    Vec3 size_m{1, 1, 1};
    physics::BodyId itself{};  ///< already in the world, not seen
};

/// The centre of the free place nearest to where the person looks, at most reach_m (and the thing's
/// own radius) away, in sight of the eye. None: there is no room.
std::optional<Vec3> free_place(const physics::PhysicsWorld& world,
                               const Aim& aim,
                               const Room& room,
                               Real reach_m);

}  // namespace plumbline::game
