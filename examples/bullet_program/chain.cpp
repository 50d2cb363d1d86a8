// A program for Bullet: a chain of ten links with a load a hundred times as heavy. How far it stretches in
// Bullet's own world and in ours, which differ in one line. docs/LIBRARY.md.
#include "engine/bullet_world/small_step_dynamics_world.h"

#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <memory>
#include <vector>

constexpr int kLinks = 10;
constexpr btScalar kLength_m = btScalar(0.5);

/// By how much the chain is longer than its links after 5 s, in percent.
template <class World>
double stretch_percent() {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    World world(&dispatcher, &broadphase, &solver, &configuration);  // the line
    world.setGravity({0, btScalar(-9.81), 0});

    btBoxShape box({btScalar(0.05), kLength_m / 2, btScalar(0.05)});
    std::vector<std::unique_ptr<btRigidBody>> links;
    std::vector<std::unique_ptr<btTypedConstraint>> joints;
    const btVector3 top(0, kLength_m / 2, 0);
    for (int i = 0; i < kLinks; ++i) {
        const btScalar mass_kg = i + 1 == kLinks ? 100 : 1;
        btVector3 inertia;
        box.calculateLocalInertia(mass_kg, inertia);
        links.push_back(std::make_unique<btRigidBody>(mass_kg, nullptr, &box, inertia));
        btRigidBody& link = *links.back();
        link.setWorldTransform(btTransform(btQuaternion::getIdentity(),
                                           {0, -kLength_m * (btScalar(i) + btScalar(0.5)), 0}));
        world.addRigidBody(&link);
        if (i == 0)
            joints.push_back(std::make_unique<btPoint2PointConstraint>(link, top));
        else
            joints.push_back(
                std::make_unique<btPoint2PointConstraint>(*links[i - 1], link, -top, top));
        world.addConstraint(joints.back().get(), true);
    }
    for (int step = 0; step < 300; ++step) world.stepSimulation(btScalar(1) / 60);

    const double length_m = -static_cast<double>((links.back()->getWorldTransform() * -top).y());
    for (const auto& joint : joints) world.removeConstraint(joint.get());
    for (const auto& link : links) world.removeRigidBody(link.get());
    return (length_m / (kLinks * kLength_m) - 1) * 100;
}

int main() {
    std::printf("btDiscreteDynamicsWorld   %8.4f %%\n", stretch_percent<btDiscreteDynamicsWorld>());
    std::printf("SmallStepDynamicsWorld    %8.4f %%\n",
                stretch_percent<plumbline::SmallStepDynamicsWorld>());
}
