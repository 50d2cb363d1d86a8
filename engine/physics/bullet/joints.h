// Joints as Bullet's constraints, for the bullet_* solvers.
//
// Ball: btPoint2PointConstraint. Cone: btConeTwistConstraint. Hinge, slider, fixed:
// btGeneric6DofSpring2Constraint with most axes locked. Distance and spring, which Bullet does not
// have: one row of our own. Stiffness is Bullet's: a fifth of an error is taken back per substep.
//
// Does not hold cones narrower than a thousandth of a radian: they are as good as fixed there.
#pragma once

#include "engine/physics/dynamics/joint/joint_geometry.h"
#include "engine/physics/world/world_state.h"

#include <memory>

namespace plumbline::physics {

/// The joint's constraint, in no world yet; it looks at joint.solver and writes joint.feedback.
std::unique_ptr<btTypedConstraint> make_bullet_joint(JointRecord& joint);
/// After the motor of a hinge or slider changed.
void drive_bullet_joint(JointRecord& joint);
/// Before the first substep of a step.
void prepare_bullet_joint(JointRecord& joint);
/// After a substep: adds what the joint carried in it.
void gather_bullet_joint(JointRecord& joint, double substep_s);

}  // namespace plumbline::physics
