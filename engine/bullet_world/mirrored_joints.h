// The joints of a PhysicsWorld that stand for the constraints of a Bullet world.
#pragma once

#include "engine/bullet_world/foreign_constraints.h"
#include "engine/bullet_world/mirrored_bodies.h"

#include <map>
#include <vector>

namespace plumbline::bullet_world {

class MirroredJoints {
public:
    MirroredJoints(const MirroredBodies& bodies, Notes& notes) : bodies_(bodies), notes_(notes) {}

    /// Before a step, after the bodies: makes the joints what the constraints are. `left` gets the enabled
    /// ones that no joint stands for.
    void read(physics::PhysicsWorld& world,
              const btDiscreteDynamicsWorld& constraints,
              std::vector<btTypedConstraint*>& left);
    /// After it: the impulses that constraints carried. Those that broke are disabled.
    void write(const physics::PhysicsWorld& world);
    void remove(physics::PhysicsWorld& world, btTypedConstraint& constraint);

private:
    struct Entry {
        physics::JointId joint{};
        physics::BodyId a{};
        physics::BodyId b{};
        ForeignJoint made_from{};
    };

    bool stands(const physics::PhysicsWorld& world,
                const Entry& entry,
                const ForeignJoint& wanted) const;
    void make(physics::PhysicsWorld& world, Entry& entry, const ForeignJoint& wanted);
    physics::BodyId body_of(const btRigidBody& rigid) const;

    const MirroredBodies& bodies_;
    Notes& notes_;
    std::map<btTypedConstraint*, Entry> entries_;
};

}  // namespace plumbline::bullet_world
