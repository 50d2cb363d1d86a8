// Bullet's world with our clock, our integration and our phases.
//
// One advance() is one whole step of Bullet's pipeline. What differs from the stock world:
// - nothing interpolates: a pose is where the body is, not where a motion state thinks it is
// - bodies that nothing touches fly on the exact path of constant acceleration and linear damping
// - damping is exp(-k t), gyroscopic torque conserves angular momentum
// - swept bodies stop at what they would have passed and keep their velocity
// - boxes around bodies are brought up to date after moving, so that queries see the new poses
#pragma once

#include "engine/core/time/stopwatch.h"
#include "engine/physics/dynamics/body_motion.h"

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;
class NearestPairs;

class StepWorld final : public btDiscreteDynamicsWorld {
public:
    StepWorld(btDispatcher* dispatcher,
              btBroadphaseInterface* pairs,
              btConstraintSolver* solver,
              btCollisionConfiguration* configuration,
              NearestPairs& nearest,
              StepReport& report);

    void set_gravity(const Vec3& gravity_mps2);
    /// In this order from now on; all that are listed, each once.
    void list_moving(const std::vector<BodyRecord*>& records);
    /// One substep. The report is added to.
    void advance(btScalar step_s);

    WorldFeatures features{};
    bool last_substep{true};
    std::function<void()> after_solve;  ///< none: nobody asks; velocities before are in the records

protected:
    void predictUnconstraintMotion(btScalar step_s) override;
    void createPredictiveContacts(btScalar step_s) override;
    void performDiscreteCollisionDetection() override;
    void solveConstraints(btContactSolverInfo& info) override;
    void integrateTransforms(btScalar step_s) override;
    void updateActivationState(btScalar step_s) override;

private:
    bool flew_free(const BodyRecord& record, btScalar step_s) const;
    void slide(BodyRecord& record, btScalar step_s);
    void move(BodyRecord& record, btScalar step_s);

    void thin_crowds();

    NearestPairs& nearest_;
    StepReport& report_;
    Vec3d gravity_mps2_{0, 0, 0};
    std::vector<BodyRecord*> turning_;
    std::vector<BodyRecord*> swept_;
    LapTimer laps_;
};

}  // namespace plumbline::physics
