// What a program does to its bodies reaches the step, and what the step does reaches them.
#include "engine/bullet_world/mirrored_bodies.h"

#include "tests/engine/bullet_world/bullet_rig.h"

#include <limits>

namespace plumbline::bullet_world {
namespace {

TEST(MirroredBodies, AFallIsThatOfConstantAcceleration) {
    OurRig rig;
    btRigidBody& ball = rig.add(rig.shape<btSphereShape>(btScalar(0.5)), {0, 100, 0}, 2);
    rig.run(1);
    EXPECT_NEAR(place(ball).y(), 100 - 9.81 / 2, 1e-3);
    EXPECT_NEAR(ball.getLinearVelocity().y(), -9.81, 1e-4);
}

TEST(MirroredBodies, WhatSleepsWakesByActivationAndByImpulses) {
    OurRig rig;
    rig.floor();
    btRigidBody& box = rig.box({0, 0.5, 0}, 3);
    rig.run(4);
    ASSERT_FALSE(box.isActive());
    box.activate();
    rig.run(0.1);
    EXPECT_TRUE(box.isActive());
    rig.run(4);
    ASSERT_FALSE(box.isActive());
    box.applyCentralImpulse({0, 9, 0});
    box.activate();
    rig.run(kStep_s);
    EXPECT_NEAR(box.getLinearVelocity().y(), 3 - 9.81 / 60, 1e-3);
}

TEST(MirroredBodies, ForcesActOnceAndGravityIsNotAddedTwice) {
    OurRig rig;
    btRigidBody& box = rig.box({0, 0, 0}, 2);
    btRigidBody& floating = rig.box({5, 0, 0}, 2);
    floating.setGravity({0, 0, 0});
    for (int i = 0; i < 60; ++i) {
        box.applyCentralForce({4, 2 * kGravity_mps2, 0});
        box.applyTorque({0, 0, 1});
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
    }
    EXPECT_NEAR(box.getLinearVelocity().x(), 2, 1e-4);
    EXPECT_NEAR(box.getLinearVelocity().y(), 0, 1e-4);
    EXPECT_NEAR(box.getAngularVelocity().z(), 3, 1e-3);  // m a^2 / 6 = 1/3 kg m2
    EXPECT_NEAR(place(floating).y(), 0, 1e-4);
}

TEST(MirroredBodies, KinematicBodiesCarryAndStaticOnesCanBeMoved) {
    OurRig rig;
    btRigidBody& belt = rig.loose(rig.shape<btBoxShape>(btVector3(5, 0.5, 5)), {0, -0.5, 0}, 0);
    belt.setCollisionFlags(belt.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    belt.setActivationState(DISABLE_DEACTIVATION);
    rig.world.addRigidBody(&belt);
    btRigidBody& rider = rig.box({0, 0.5, 0}, 1);
    btScalar x = 0;
    for (int i = 0; i < 120; ++i) {
        x += kStep_s * std::min(btScalar(i) / 60, btScalar(1));
        belt.setWorldTransform(btTransform(btQuaternion::getIdentity(), {x, -0.5, 0}));
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
    }
    EXPECT_NEAR(place(rider).x(), x, 0.02);
    EXPECT_NEAR(rider.getLinearVelocity().x(), 1, 1e-2);
}

TEST(MirroredBodies, BodiesThatTurnAboutOneAxisOnlyDo) {
    OurRig rig;
    rig.world.setGravity({0, 0, 0});
    btRigidBody& box = rig.box({0, 0, 0}, 1);
    box.setAngularFactor({0, 0, 1});
    box.setLinearFactor({1, 1, 0});
    box.applyImpulse({1, 1, 1}, {btScalar(0.5), btScalar(-0.5), btScalar(0.25)});
    rig.run(2);
    EXPECT_NEAR(place(box).z(), 0, 1e-5);
    EXPECT_NEAR(box.getAngularVelocity().z(), 6, 1e-3);
    EXPECT_NEAR(box.getAngularVelocity().x(), 0, 1e-6);
    EXPECT_NEAR(box.getAngularVelocity().y(), 0, 1e-6);
}

TEST(MirroredBodies, DampingKeepsTheShareThatBulletKeeps) {
    OurRig rig;
    rig.world.setGravity({0, 0, 0});
    btRigidBody& box = rig.box({0, 0, 0}, 1);
    box.setDamping(btScalar(0.3), btScalar(0.6));
    box.setLinearVelocity({10, 0, 0});
    box.setAngularVelocity({0, 5, 0});
    rig.run(2);
    EXPECT_NEAR(box.getLinearVelocity().x(), 10 * 0.7 * 0.7, 1e-3);
    EXPECT_NEAR(box.getAngularVelocity().y(), 5 * 0.4 * 0.4, 1e-3);
}

TEST(MirroredBodies, ChangesOfGravityRateAndMassAreFollowed) {
    OurRig rig;
    btRigidBody& box = rig.box({0, 0, 0}, 1);
    rig.run(1);
    rig.world.setGravity({0, 0, 0});
    const btScalar speed = box.getLinearVelocity().y();
    rig.run(1, btScalar(1) / 100);
    EXPECT_NEAR(box.getLinearVelocity().y(), speed, 1e-5);
    box.setMassProps(4, btVector3(1, 1, 1));
    box.applyCentralImpulse({8, 0, 0});
    rig.run(1);
    EXPECT_NEAR(box.getLinearVelocity().x(), 2, 1e-5);
    EXPECT_NEAR(place(box).x(), 2, 1e-3);
}

TEST(MirroredBodies, BadMassesAndNumbersAreSurvived) {
    OurRig rig;
    rig.floor();
    btRigidBody& negative = rig.box({0, 3, 0}, -1);
    btRigidBody& lost = rig.box({3, 3, 0}, 1);
    btRigidBody& sound = rig.box({6, 0.5, 0}, 1);
    rig.run(0.1);
    lost.setLinearVelocity({0, std::numeric_limits<btScalar>::quiet_NaN(), 0});
    rig.run(1);
    EXPECT_NEAR(place(sound).y(), 0.5, 1e-3);
    EXPECT_NEAR(place(negative).y(), 3, 1e-6);
    EXPECT_TRUE(std::isfinite(place(lost).y()));
}

TEST(MirroredBodies, WithoutSimulationTheyStandStillAndCarry) {
    OurRig rig;
    btRigidBody& shelf = rig.box({0, 5, 0}, 1);
    shelf.forceActivationState(DISABLE_SIMULATION);
    btRigidBody& load = rig.box({0, 6, 0}, 1);
    rig.run(1);
    EXPECT_EQ(place(shelf).y(), 5);
    EXPECT_NEAR(place(load).y(), 6, 1e-3);
    shelf.forceActivationState(ACTIVE_TAG);
    rig.run(1);
    EXPECT_NEAR(place(shelf).y(), 5 - 9.81 / 2, 0.02);
}

TEST(MirroredBodies, WhatHasNoSurfaceFallsThroughEverything) {
    OurRig rig;
    rig.floor();
    btRigidBody& empty = rig.box({0, 3, 0}, 1);
    empty.setCollisionShape(&rig.shape<btEmptyShape>());
    btRigidBody& without_parts = rig.box({3, 3, 0}, 1);
    without_parts.setCollisionShape(&rig.shape<btCompoundShape>());
    rig.add(rig.shape<btEmptyShape>(), {6, 3, 0}, 0);
    rig.run(1);
    EXPECT_TRUE(rig.world.notes().empty());
    EXPECT_NEAR(place(empty).y(), 3 - 9.81 / 2, 0.01);
    EXPECT_NEAR(place(without_parts).y(), 3 - 9.81 / 2, 0.01);
}

TEST(MirroredBodies, AShapeThatCannotBeTakenOverIsSaidAndLeftOut) {
    OurRig rig;
    rig.floor();
    btRigidBody& huge = rig.box({0, 3, 0}, 1, btScalar(1e6));
    btRigidBody& box = rig.box({3, btScalar(0.5), 0}, 1);
    rig.run(1);
    EXPECT_EQ(rig.world.notes().size(), 1U);
    EXPECT_NEAR(place(box).y(), 0.5, 1e-3);
    EXPECT_EQ(place(huge).y(), 3);
}

}  // namespace
}  // namespace plumbline::bullet_world
