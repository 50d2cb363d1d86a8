// Constraints that change, break and go.
#include "engine/bullet_world/mirrored_joints.h"

#include "tests/engine/bullet_world/bullet_rig.h"

namespace plumbline::bullet_world {
namespace {

constexpr double kWeight_N = 9.81;  // of 1 kg

TEST(MirroredJoints, AConstraintCarriesAndSaysWhat) {
    OurRig rig;
    btRigidBody& body = rig.box({0, 0, 0}, 1);
    auto& point = rig.join<btPoint2PointConstraint>(true, body, btVector3(0, 0.5, 0));
    rig.run(1);
    EXPECT_NEAR(place(body).y(), 0, 1e-3);
    EXPECT_NEAR(point.getAppliedImpulse(), kWeight_N / 60, 1e-3);
}

// A bar held level at one end by a hinge at its limit: the force is its weight, the moment its weight times half its length.
TEST(MirroredJoints, FeedbackIsWhatTheConstraintDoesToBothBodies) {
    OurRig rig;
    btRigidBody& post = rig.box({-1, 0, 0}, 0);
    btRigidBody& bar = rig.box({1, 0, 0}, 2);
    auto& weld = rig.join<btFixedConstraint>(true,
                                             bar,
                                             post,
                                             btTransform(btQuaternion::getIdentity(), {-1, 0, 0}),
                                             btTransform(btQuaternion::getIdentity(), {1, 0, 0}));
    btJointFeedback feedback{};
    weld.setJointFeedback(&feedback);
    rig.run(0.5);
    EXPECT_NEAR(feedback.m_appliedForceBodyA.y(), 2 * kWeight_N, 1e-2);
    EXPECT_NEAR(feedback.m_appliedForceBodyB.y(), -2 * kWeight_N, 1e-2);
    EXPECT_NEAR(feedback.m_appliedTorqueBodyA.length(), 0, 1e-2) << "about its own centre it rests";
    EXPECT_NEAR(feedback.m_appliedTorqueBodyB.z(), -2 * kWeight_N * 2, 1e-2)
        << "the weight on an arm of 2 m";
}

TEST(MirroredJoints, OneThatBreaksIsDisabled) {
    OurRig rig;
    btRigidBody& body = rig.box({0, 0, 0}, 1);
    body.setActivationState(DISABLE_DEACTIVATION);
    auto& point = rig.join<btPoint2PointConstraint>(true, body, btVector3(0, 0.5, 0));
    point.setBreakingImpulseThreshold(static_cast<btScalar>(1.5 * kWeight_N / 60));
    rig.run(1);
    ASSERT_TRUE(point.isEnabled());
    for (int i = 0; i < 5; ++i) {
        body.applyCentralForce({0, -kGravity_mps2, 0});
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
    }
    EXPECT_FALSE(point.isEnabled());
    rig.run(1);
    EXPECT_LT(place(body).y(), -3);
}

TEST(MirroredJoints, DisabledAndTakenOutTheyLetGo) {
    OurRig rig;
    btRigidBody& a = rig.box({0, 0, 0}, 1);
    btRigidBody& b = rig.box({5, 0, 0}, 1);
    auto& first = rig.join<btPoint2PointConstraint>(true, a, btVector3(0, 0.5, 0));
    auto& second = rig.join<btPoint2PointConstraint>(true, b, btVector3(0, 0.5, 0));
    rig.run(0.5);
    first.setEnabled(false);
    rig.world.removeConstraint(&second);
    rig.run(1);
    EXPECT_NEAR(place(a).y(), -kWeight_N / 2, 0.02);
    EXPECT_NEAR(place(b).y(), -kWeight_N / 2, 0.02);
    a.setLinearVelocity({0, 0, 0});
    first.setEnabled(true);  // holds again, where its frames say
    rig.run(2);
    EXPECT_NEAR((a.getWorldTransform() * btVector3(0, 0.5, 0)).distance({0, 0.5, 0}), 0, 0.02);
}

TEST(MirroredJoints, MotorsAndLimitsMayChangeWhileItRuns) {
    OurRig rig;
    rig.world.setGravity({0, 0, 0});
    btRigidBody& body = rig.box({0, 0, 0}, 1);
    body.setActivationState(DISABLE_DEACTIVATION);
    auto& hinge =
        rig.join<btHingeConstraint>(true, body, btVector3(0, 0, 0), btVector3(0, 0, 1), false);
    hinge.enableAngularMotor(true, 1, 100);
    rig.run(0.5);
    const btScalar first = body.getAngularVelocity().z();
    EXPECT_NEAR(std::abs(first), 1, 1e-3);
    hinge.setMotorTargetVelocity(-2);
    rig.run(0.5);
    EXPECT_NEAR(body.getAngularVelocity().z(), -2 * first, 1e-2);
    hinge.setLimit(btScalar(-0.1), btScalar(0.1));
    rig.run(3);
    EXPECT_NEAR(std::abs(hinge.getHingeAngle()), 0.1, 0.02);
}

TEST(MirroredJoints, LinkedBodiesTouchOnlyWhenToldTo) {
    for (const bool collide : {false, true}) {
        OurRig rig;
        rig.floor();
        btRigidBody& post = rig.box({0, 2, 0}, 0);
        btRigidBody& arm = rig.box({btScalar(1.2), 2, 0}, 1);
        rig.join<btHingeConstraint>(collide,
                                    post,
                                    arm,
                                    btVector3(0, 0, 0),
                                    btVector3(-btScalar(1.2), 0, 0),
                                    btVector3(0, 0, 1),
                                    btVector3(0, 0, 1));
        rig.run(0.8);
        // Swinging down, its side would meet a corner of the post at 0.65.
        const auto turned_rad = static_cast<double>(arm.getOrientation().getAngle());
        EXPECT_EQ(turned_rad > 0.9, !collide) << turned_rad;
    }
}

TEST(MirroredJoints, ABodyThatComesLaterIsHeldFromThen) {
    OurRig rig;
    btRigidBody& body = rig.loose(rig.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5)), {0, 0, 0}, 1);
    rig.join<btPoint2PointConstraint>(true, body, btVector3(0, 0.5, 0));
    rig.run(0.5);
    rig.world.addRigidBody(&body);
    rig.run(1);
    EXPECT_NEAR(place(body).y(), 0, 1e-3);
    body.setMassProps(3, btVector3(1, 1, 1));  // made anew, and held again
    rig.run(1);
    EXPECT_NEAR(place(body).y(), 0, 1e-3);
}

}  // namespace
}  // namespace plumbline::bullet_world
