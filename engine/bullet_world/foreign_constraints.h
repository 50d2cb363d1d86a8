// Bullet's constraints as our joints.
#pragma once

#include "engine/core/pose.h"
#include "engine/physics/joint.h"

#include <array>
#include <optional>

class btTypedConstraint;
class btRigidBody;

namespace plumbline::bullet_world {

/// A joint in the frames of its bodies. What it holds coincides where the two frames do: there angles and
/// displacements are 0. Its axis is z of both frames.
struct ForeignJoint {
    physics::JointKind kind{physics::JointKind::BallAndSocket};
    const btRigidBody* a{nullptr};
    const btRigidBody* b{nullptr};
    Pose a_from_joint{};
    Pose b_from_joint{};
    std::optional<std::array<Real, 2>> limits{};
    std::optional<std::array<Real, 2>> twist_limits{};
    std::optional<physics::JointMotor> motor{};
    Real break_N{0};
};

/// None: of a kind, or with springs, motors or limits, that our joints lack. `step_s`: of Bullet's impulses.
std::optional<ForeignJoint> foreign_joint(btTypedConstraint& constraint, Real step_s);

/// The same joint with its bodies in the other order.
void exchange(ForeignJoint& joint);

}  // namespace plumbline::bullet_world
