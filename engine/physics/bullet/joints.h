// Joints as Bullet's constraints, for the bullet_* solvers.
//
// Ball: btPoint2PointConstraint. Cone: btConeTwistConstraint. Hinge, slider, fixed:
// btGeneric6DofSpring2Constraint with most axes locked. Distance and spring, which Bullet does not
// have: one row of our own. Stiffness is Bullet's: a fifth of an error is taken back per substep.
//
// Does not hold cones narrower than a thousandth of a radian: they are as good as fixed there.
#pragma once

#include "engine/core/math.h"

#include <memory>
#include <optional>

class btTypedConstraint;

namespace plumbline {
class Archive;
}

namespace plumbline::physics {

class StepWorld;
struct JointRecord;

/// What a joint carried, as means over the time in which Bullet solved it.
struct JointMeanLoad {
    double force_N{0};
    double torque_Nm{0};
};

/// The constraint of a joint, in Bullet's world for as long as this lives. Both outlive it.
class BulletJoint {
public:
    BulletJoint(JointRecord& joint, StepWorld& world);
    ~BulletJoint();
    BulletJoint(const BulletJoint&) = delete;
    BulletJoint& operator=(const BulletJoint&) = delete;

    /// After the motor of a hinge or slider changed.
    void drive();
    /// Before the first substep of a step.
    void begin_step();
    /// After a substep: adds what the joint carried in it.
    void gather(double substep_s);
    /// Of the step; none where its bodies slept all along.
    std::optional<JointMeanLoad> mean_load() const;

    /// What the latest substep carried.
    void serialize(Archive& archive);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Whose constraint it is; every one in Bullet's world is a joint's.
JointRecord& joint_of(btTypedConstraint& constraint);

}  // namespace plumbline::physics
