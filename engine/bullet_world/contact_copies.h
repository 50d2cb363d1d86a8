// Contacts of a PhysicsWorld as Bullet's manifolds, where programs look for them.
#pragma once

#include "engine/bullet_world/mirrored_bodies.h"
#include "engine/physics/contact.h"

#include <unordered_map>
#include <utility>
#include <vector>

namespace plumbline::bullet_world {

class ContactCopies {
public:
    /// Both outlive it.
    ContactCopies(btCollisionWorld& world, const MirroredBodies& bodies)
        : world_(world), bodies_(bodies) {}

    /// After a step: a manifold of the dispatcher for each four points of a pair. Bullet's callbacks for contacts
    /// are called as Bullet does; they may take objects out of the world.
    void write(const physics::PhysicsWorld& world);
    /// The object leaves the world.
    void forget(const btCollisionObject& object);
    void clear();

private:
    using Pair = std::pair<physics::BodyId, physics::BodyId>;
    struct Copies {
        std::vector<btPersistentManifold*> manifolds;
        std::uint64_t found{0};  ///< in that step
    };

    void fill(const Mirror& a, const Mirror& b, std::size_t first, std::size_t end);
    void call_back(std::size_t place);
    void release(Copies& copies, std::size_t kept);

    btCollisionWorld& world_;
    const MirroredBodies& bodies_;
    struct PairHash {
        std::size_t operator()(const Pair& pair) const {
            return (std::size_t{pair.first.index} << 32U) ^ pair.second.index;
        }
    };
    std::unordered_map<Pair, Copies, PairHash> copies_;
    std::uint64_t step_{0};
    std::vector<physics::ContactPoint> points_;  ///< of the latest step
    std::vector<btPersistentManifold*> filled_;  ///< in their order; null: gone since
};

}  // namespace plumbline::bullet_world
