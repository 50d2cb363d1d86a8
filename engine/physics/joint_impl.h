// A joint as the world keeps it from step to step. Private to the physics module.
#pragma once

#include "engine/physics/joint.h"
#include "engine/physics/small_step/joint_system.h"

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
    std::unique_ptr<btTypedConstraint> bullet;  ///< only with bullet_* solvers
};

}  // namespace plumbline::physics
