// Bullet's dynamics world with small_step in the place of its contact solver.
//
// A program that makes a btDiscreteDynamicsWorld makes this instead; everything else of it stays. Each
// step copies what the program did to its bodies and constraints into a PhysicsWorld, steps that, and
// writes poses, velocities, activation, contact manifolds and broken constraints back. Objects without
// contact response (ghosts), ray and sweep tests, actions, callbacks and motion states are Bullet's own.
// docs/LIBRARY.md says what differs.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <string>
#include <vector>

namespace plumbline {

namespace physics {
class PhysicsWorld;
}

/// How much accuracy a step pays for; see physics::WorldDef.
struct SubstepRange {
    int least{2};
    int most{16};  ///< that an island gets when it asks for more; at most `least`: always `least`
};

/// Not thread-safe, as its base. The four parts outlive it and are not owned, as in its base.
class SmallStepDynamicsWorld : public btDiscreteDynamicsWorld {
public:
    SmallStepDynamicsWorld(btDispatcher* dispatcher,
                           btBroadphaseInterface* broadphase,
                           btConstraintSolver* solver,  ///< of constraints that small_step lacks
                           btCollisionConfiguration* configuration);
    ~SmallStepDynamicsWorld() override;
    SmallStepDynamicsWorld(const SmallStepDynamicsWorld&) = delete;
    SmallStepDynamicsWorld& operator=(const SmallStepDynamicsWorld&) = delete;

    /// From the next step on. Both at least 1.
    void set_substeps(const SubstepRange& range);
    /// The world behind: its report tells what the latest step cost and did. Its bodies are not for
    /// callers to change.
    const physics::PhysicsWorld& physics() const;
    /// What could not be done as Bullet does it, a sentence each, each once.
    const std::vector<std::string>& notes() const;

    void removeRigidBody(btRigidBody* body) override;
    void removeCollisionObject(btCollisionObject* object) override;
    void removeConstraint(btTypedConstraint* constraint) override;
    void performDiscreteCollisionDetection() override;
    void applyGravity() override;

protected:
    void internalSingleStepSimulation(btScalar step_s) override;

private:
    struct Parts;

    void detect_left_pairs();
    void forget(btCollisionObject& object);

    std::unique_ptr<Parts> parts_;
};

}  // namespace plumbline
