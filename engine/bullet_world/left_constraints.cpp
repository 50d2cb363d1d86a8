#include "engine/bullet_world/left_constraints.h"

#include <fmt/core.h>

#include <algorithm>

namespace plumbline::bullet_world {
namespace {

constexpr int kGyroscopicFlags = BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD |
                                 BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;

const char* name_of(btTypedConstraintType type) {
    switch (type) {
        case POINT2POINT_CONSTRAINT_TYPE:
            return "point to point (clamped)";
        case HINGE_CONSTRAINT_TYPE:
            return "hinge (angular only)";
        case CONETWIST_CONSTRAINT_TYPE:
            return "cone twist (with a motor or unequal swings)";
        case SLIDER_CONSTRAINT_TYPE:
            return "slider (that turns)";
        case GEAR_CONSTRAINT_TYPE:
            return "gear";
        case D6_CONSTRAINT_TYPE:
        case D6_SPRING_CONSTRAINT_TYPE:
        case D6_SPRING_2_CONSTRAINT_TYPE:
            return "six degrees of freedom (with springs, motors or several freedoms)";
        default:
            return "of another kind";
    }
}

/// Torque that gives the body so much spin.
btVector3 torque_for(const btRigidBody& rigid, const btVector3& spin_per_s) {
    const btMatrix3x3& world_from_body = rigid.getWorldTransform().getBasis();
    btVector3 along_axes = spin_per_s * world_from_body;  // its transpose times the vector
    for (int i = 0; i < 3; ++i) {
        const btScalar inverse = rigid.getInvInertiaDiagLocal()[i];
        along_axes[i] = inverse > 0 ? along_axes[i] / inverse : 0;
    }
    return world_from_body * along_axes;
}

/// What the solver changed beside the forces of the step acts as a force all through it: as an impulse at
/// its start it would move what hangs at rest.
void hand_on(physics::PhysicsWorld& world, const Mirror& mirror, btScalar step_s) {
    if (mirror.body == physics::BodyId{}) return;
    btRigidBody& rigid = *mirror.rigid;
    const btVector3 force =
        (rigid.getLinearVelocity() - mirror.velocity) / (rigid.getInvMass() * step_s) -
        rigid.getTotalForce();
    const btVector3 torque =
        torque_for(rigid, (rigid.getAngularVelocity() - mirror.spin) / step_s) -
        rigid.getTotalTorque();
    rigid.setLinearVelocity(mirror.velocity);
    rigid.setAngularVelocity(mirror.spin);
    world.apply_force(mirror.body, vec_of(force));
    world.apply_torque(mirror.body, vec_of(torque));
}

}  // namespace

void LeftConstraints::list_bodies(const std::vector<btTypedConstraint*>& constraints) {
    mirrors_.clear();
    objects_.clear();
    for (btTypedConstraint* constraint : constraints) {
        if (const auto type = constraint->getConstraintType(); said_.insert(type).second) {
            notes_.add(
                fmt::format("constraints of this kind are solved by Bullet, before contacts: {}",
                            name_of(type)));
        }
        for (btRigidBody* rigid : {&constraint->getRigidBodyA(), &constraint->getRigidBodyB()}) {
            Mirror* mirror = bodies_.find(*rigid);
            if (mirror == nullptr || mirror->traits.kind != physics::BodyKind::Dynamic ||
                std::ranges::find(mirrors_, mirror) != mirrors_.end())
                continue;
            mirrors_.push_back(mirror);
            objects_.push_back(rigid);
        }
    }
}

void LeftConstraints::solve(physics::PhysicsWorld& world,
                            btConstraintSolver& solver,
                            const std::vector<btTypedConstraint*>& constraints,
                            const btContactSolverInfo& info,
                            btDispatcher& dispatcher) {
    if (constraints.empty()) return;
    list_bodies(constraints);
    const auto any_awake = [](const Mirror* mirror) { return mirror->rigid->isActive(); };
    if (std::ranges::none_of(mirrors_, any_awake)) return;

    std::vector<int> flags;
    for (const Mirror* mirror : mirrors_) {
        flags.push_back(mirror->rigid->getFlags());
        mirror->rigid->setFlags(flags.back() & ~kGyroscopicFlags);
    }
    auto list = constraints;  // Bullet takes them by a pointer that is not const
    const int bodies = static_cast<int>(objects_.size());
    solver.prepareSolve(bodies, 0);
    solver.solveGroup(objects_.data(),
                      bodies,
                      nullptr,
                      0,
                      list.data(),
                      static_cast<int>(list.size()),
                      info,
                      nullptr,
                      &dispatcher);
    solver.allSolved(info, nullptr);

    for (std::size_t i = 0; i < mirrors_.size(); ++i) {
        mirrors_[i]->rigid->setFlags(flags[i]);
        hand_on(world, *mirrors_[i], info.m_timeStep);
    }
}

}  // namespace plumbline::bullet_world
