// A Bullet program in small: the same calls make a stock world or ours.
#pragma once

#include "engine/bullet_world/small_step_dynamics_world.h"

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace plumbline::bullet_world {

inline constexpr btScalar kStep_s = btScalar(1) / 60;
inline constexpr btScalar kGravity_mps2 = btScalar(9.81);

template <class World>
class Rig {
public:
    Rig() : world(&dispatcher, &broadphase, &solver, &configuration) {
        world.setGravity({0, -kGravity_mps2, 0});
    }
    ~Rig() {
        for (const auto& constraint : constraints_) world.removeConstraint(constraint.get());
        for (const auto& body : bodies_) {
            if (body->getWorldArrayIndex() >= 0) world.removeRigidBody(body.get());
        }
    }

    template <class Shape, class... Args>
    Shape& shape(Args&&... args) {
        auto made = std::make_unique<Shape>(std::forward<Args>(args)...);
        Shape& kept = *made;
        shapes_.push_back(std::move(made));
        return kept;
    }

    /// Not yet in the world. Mass 0: static.
    btRigidBody& loose(btCollisionShape& collision, const btVector3& at, btScalar mass_kg) {
        btVector3 inertia(0, 0, 0);
        if (mass_kg > 0) collision.calculateLocalInertia(mass_kg, inertia);
        btRigidBody::btRigidBodyConstructionInfo info(mass_kg, nullptr, &collision, inertia);
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), at);
        info.m_friction = 1;
        bodies_.push_back(std::make_unique<btRigidBody>(info));
        return *bodies_.back();
    }
    btRigidBody& add(btCollisionShape& collision, const btVector3& at, btScalar mass_kg) {
        btRigidBody& body = loose(collision, at, mass_kg);
        world.addRigidBody(&body);
        return body;
    }
    btRigidBody& box(const btVector3& at, btScalar mass_kg, btScalar half_m = btScalar(0.5)) {
        return add(shape<btBoxShape>(btVector3(half_m, half_m, half_m)), at, mass_kg);
    }
    /// Its upper side at y = 0.
    btRigidBody& floor() { return add(shape<btBoxShape>(btVector3(20, 1, 20)), {0, -1, 0}, 0); }

    template <class Constraint, class... Args>
    Constraint& join(bool linked_collide, Args&&... args) {
        auto made = std::make_unique<Constraint>(std::forward<Args>(args)...);
        Constraint& kept = *made;
        world.addConstraint(&kept, !linked_collide);
        constraints_.push_back(std::move(made));
        return kept;
    }

    void run(double time_s, btScalar step_s = kStep_s) {
        const int steps = static_cast<int>(std::lround(time_s / static_cast<double>(step_s)));
        for (int i = 0; i < steps; ++i) world.stepSimulation(step_s, 1, step_s);
    }

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    World world;

private:
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> constraints_;
};

using OurRig = Rig<SmallStepDynamicsWorld>;
using StockRig = Rig<btDiscreteDynamicsWorld>;

inline btVector3 place(const btRigidBody& body) {
    return body.getCenterOfMassPosition();
}

}  // namespace plumbline::bullet_world
