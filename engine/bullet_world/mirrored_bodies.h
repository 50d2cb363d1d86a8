// The bodies of a PhysicsWorld that stand for the objects of a Bullet world.
#pragma once

#include "engine/bullet_world/mirror.h"

#include <map>
#include <memory>
#include <vector>

namespace plumbline::bullet_world {

class MirroredBodies {
public:
    /// Both outlive it.
    MirroredBodies(btCollisionWorld& objects, Notes& notes) : objects_(objects), notes_(notes) {}

    /// Bullet adds gravity to the forces of the bodies that are awake now.
    void note_gravity();
    /// Before a step: makes the bodies what the objects are. A body of which more changed than its motion is
    /// made anew.
    void read(physics::PhysicsWorld& world);
    /// After it: moves the objects as the bodies moved.
    void write(const physics::PhysicsWorld& world);
    /// The object leaves Bullet's world after this call.
    void remove(physics::PhysicsWorld& world, const btCollisionObject& object);

    /// Of an object of Bullet's world; null: not seen by a read() yet.
    Mirror* find(const btCollisionObject& object) const;
    /// Whether contacts of the two are ours to find. `a` and `b`: of Bullet's world.
    bool are_ours(const btCollisionObject& a, const btCollisionObject& b) const;
    /// Some objects have no body: Bullet finds what they touch.
    bool some_left() const { return left_ > 0; }

private:
    void list_new();
    void make(physics::PhysicsWorld& world, Mirror& mirror, const BodyTraits& traits);
    void destroy(physics::PhysicsWorld& world, Mirror& mirror);
    physics::ShapeId shape_of(physics::PhysicsWorld& world,
                              const btCollisionShape& shape,
                              bool dynamic,
                              Pose& object_from_shape);
    void read_motion(physics::PhysicsWorld& world, Mirror& mirror);
    void read_activation(physics::PhysicsWorld& world, Mirror& mirror);
    void read_forces(physics::PhysicsWorld& world, const Mirror& mirror);
    void write_motion(const physics::PhysicsWorld& world, Mirror& mirror);

    btCollisionWorld& objects_;
    Notes& notes_;
    std::vector<std::unique_ptr<Mirror>> mirrors_;      ///< as the world lists its objects
    std::map<std::uint64_t, physics::ShapeId> shapes_;  ///< by a hash of their numbers
    std::size_t left_{0};
};

}  // namespace plumbline::bullet_world
