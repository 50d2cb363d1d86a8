// Constraints that small_step lacks, solved by Bullet's own solver before a step.
#pragma once

#include "engine/bullet_world/mirrored_bodies.h"

#include <set>
#include <vector>

namespace plumbline::bullet_world {

class LeftConstraints {
public:
    LeftConstraints(MirroredBodies& bodies, Notes& notes) : bodies_(bodies), notes_(notes) {}

    /// Pushes the bodies so that the constraints hold at the end of the coming step of `info` under its other
    /// forces. Contacts of that step know nothing of the constraints. The bodies have been read.
    void solve(physics::PhysicsWorld& world,
               btConstraintSolver& solver,
               const std::vector<btTypedConstraint*>& constraints,
               const btContactSolverInfo& info,
               btDispatcher& dispatcher);

private:
    void list_bodies(const std::vector<btTypedConstraint*>& constraints);

    MirroredBodies& bodies_;
    Notes& notes_;
    std::set<btTypedConstraintType> said_;
    std::vector<Mirror*> mirrors_;
    std::vector<btCollisionObject*> objects_;
};

}  // namespace plumbline::bullet_world
