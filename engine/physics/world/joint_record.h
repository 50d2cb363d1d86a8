// A joint as the world keeps it from step to step.
#pragma once

#include "engine/physics/dynamics/joint/joint_system.h"
#include "engine/physics/joint.h"

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace plumbline::physics {

struct BodyRecord;

struct JointRecord {
    JointId id{};
    BodyRecord* a{nullptr};
    BodyRecord* b{nullptr};  ///< null: the world
    JointDef def{};
    SolverJoint solver{};  ///< geometry and warm start; `a` and `b` are filled in every step
    JointState state{};

    // Only with bullet_* solvers.
    std::unique_ptr<btTypedConstraint> bullet;
    btJointFeedback feedback{};  ///< what the latest substep carried
    Vec3d carried_Ns{0, 0, 0};   ///< on a, so far in the running step
    Vec3d carried_Nms{0, 0, 0};  ///< about a's anchor
    double solved_s{0};  ///< for how much of the running step; less where sleep cut it short
};

}  // namespace plumbline::physics
