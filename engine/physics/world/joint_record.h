// A joint as the world keeps it from step to step.
#pragma once

#include "engine/physics/bullet/joints.h"
#include "engine/physics/dynamics/joint/joint_system.h"
#include "engine/physics/joint.h"

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

    std::unique_ptr<BulletJoint> bullet;  ///< only with bullet_* solvers
};

}  // namespace plumbline::physics
