// What programs read from the dispatcher's manifolds after a step.
#include "engine/bullet_world/contact_copies.h"

#include "tests/engine/bullet_world/bullet_rig.h"

#include <set>

namespace plumbline::bullet_world {
namespace {

double impulse_on_Ns(OurRig& rig, const btRigidBody& body) {
    double sum = 0;
    for (int i = 0; i < rig.dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *rig.dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getBody0() != &body && manifold.getBody1() != &body) continue;
        for (int j = 0; j < manifold.getNumContacts(); ++j)
            sum += static_cast<double>(manifold.getContactPoint(j).getAppliedImpulse());
    }
    return sum;
}

TEST(ContactCopies, ARestingBoxIsCarriedByFourPoints) {
    OurRig rig;
    rig.floor();
    btRigidBody& box = rig.box({0, 0.5, 0}, 3);
    rig.run(1);
    ASSERT_EQ(rig.dispatcher.getNumManifolds(), 1);
    const btPersistentManifold& manifold = *rig.dispatcher.getManifoldByIndexInternal(0);
    ASSERT_EQ(manifold.getNumContacts(), 4);
    EXPECT_NEAR(impulse_on_Ns(rig, box), 3 * 9.81 / 60, 1e-3);
    const btScalar up = manifold.getBody0() == &box ? 1 : -1;  // the normal leads to body 0
    for (int i = 0; i < 4; ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        EXPECT_NEAR(point.m_normalWorldOnB.y(), up, 1e-4);
        EXPECT_NEAR(point.getPositionWorldOnA().y(), 0, 1e-3);
        EXPECT_NEAR(std::abs(point.getPositionWorldOnB().x()), 0.5, 1e-3);
        EXPECT_GT(point.getLifeTime(), 20);
        EXPECT_NEAR(point.m_combinedFriction, 1, 1e-6);
    }
}

TEST(ContactCopies, MorePointsThanFourGoIntoMoreManifolds) {
    OurRig rig;
    rig.floor();
    auto& compound = rig.shape<btCompoundShape>();
    auto& part = rig.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5));
    for (const btScalar x : {btScalar(-2), btScalar(0), btScalar(2)})
        compound.addChildShape(btTransform(btQuaternion::getIdentity(), {x, 0, 0}), &part);
    btRigidBody& body = rig.add(compound, {0, 0.5, 0}, 6);
    rig.run(1);
    EXPECT_GE(rig.dispatcher.getNumManifolds(), 3);
    EXPECT_NEAR(impulse_on_Ns(rig, body), 6 * 9.81 / 60, 1e-2);
}

TEST(ContactCopies, TheyGoWithTheContactAndWithTheBody) {
    OurRig rig;
    rig.floor();
    btRigidBody& box = rig.box({0, 0.5, 0}, 3);
    rig.box({3, 0.5, 0}, 3);
    rig.run(0.5);
    ASSERT_EQ(rig.dispatcher.getNumManifolds(), 2);
    box.setLinearVelocity({0, 20, 0});
    rig.run(0.5);
    EXPECT_EQ(rig.dispatcher.getNumManifolds(), 1);
    rig.run(4);
    ASSERT_EQ(rig.dispatcher.getNumManifolds(), 2);
    rig.world.removeRigidBody(&box);
    EXPECT_EQ(rig.dispatcher.getNumManifolds(), 1);
}

TEST(ContactCopies, DetectionWithoutAStepIsBulletsAndLeavesNothingBehind) {
    OurRig rig;
    rig.floor();
    rig.box({0, 0.5, 0}, 3);
    rig.run(0.5);
    rig.world.performDiscreteCollisionDetection();
    ASSERT_EQ(rig.dispatcher.getNumManifolds(), 1);
    EXPECT_LE(rig.dispatcher.getManifoldByIndexInternal(0)->getContactPoint(0).getLifeTime(), 1);
    rig.run(0.5);
    ASSERT_EQ(rig.dispatcher.getNumManifolds(), 1);
    EXPECT_GT(rig.dispatcher.getManifoldByIndexInternal(0)->getContactPoint(0).getLifeTime(), 10);
}

/// Bullet's callbacks are plain functions.
struct Calls {
    int started{0};
    int ended{0};
    int added{0};
    int processed{0};
    btDynamicsWorld* world{nullptr};
    btRigidBody* to_remove{nullptr};             ///< by the callback for processed points
    btRigidBody* to_remove_when_added{nullptr};  ///< ... for added ones
    bool detects{false};                         ///< the former asks for contacts without a step

    void remove(btRigidBody*& body) const {
        if (body != nullptr) world->removeRigidBody(std::exchange(body, nullptr));
    }
};
Calls calls;

class ContactCallbacks : public testing::Test {
protected:
    ContactCallbacks() {
        calls = {};
        gContactStartedCallback = [](btPersistentManifold* const&) { ++calls.started; };
        gContactEndedCallback = [](btPersistentManifold* const&) { ++calls.ended; };
        gContactAddedCallback = [](btManifoldPoint&,
                                   const btCollisionObjectWrapper*,
                                   int,
                                   int,
                                   const btCollisionObjectWrapper*,
                                   int,
                                   int) {
            ++calls.added;
            calls.remove(calls.to_remove_when_added);
            return false;
        };
        gContactProcessedCallback = [](btManifoldPoint&, void*, void*) {
            ++calls.processed;
            calls.remove(calls.to_remove);
            if (std::exchange(calls.detects, false))
                calls.world->performDiscreteCollisionDetection();
            return false;
        };
    }
    ~ContactCallbacks() override {
        gContactStartedCallback = nullptr;
        gContactEndedCallback = nullptr;
        gContactAddedCallback = nullptr;
        gContactProcessedCallback = nullptr;
    }
};

TEST_F(ContactCallbacks, AreCalledAsBulletCallsThem) {
    OurRig rig;
    rig.floor();
    btRigidBody& box = rig.box({0, 0.5, 0}, 3);
    rig.run(1);
    EXPECT_EQ(calls.started, 1);
    EXPECT_EQ(calls.ended, 0);
    EXPECT_EQ(calls.added, 0);  // nobody asked by CF_CUSTOM_MATERIAL_CALLBACK
    EXPECT_GE(calls.processed, 4 * 59);
    box.setCollisionFlags(box.getCollisionFlags() | btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    box.setLinearVelocity({0, 4, 0});
    rig.run(0.4);
    EXPECT_EQ(calls.ended, 1);
    rig.run(1);
    EXPECT_GE(calls.started, 2);
    EXPECT_GE(calls.added, 4);
}

TEST_F(ContactCallbacks, MayTakeABodyOutOfTheWorld) {
    OurRig rig;
    rig.floor();
    btRigidBody& first = rig.box({0, 0.5, 0}, 3);
    btRigidBody& second = rig.box({3, 0.5, 0}, 3);
    calls.world = &rig.world;
    calls.to_remove = &first;
    rig.run(1);
    EXPECT_EQ(first.getWorldArrayIndex(), -1);
    EXPECT_EQ(rig.dispatcher.getNumManifolds(), 1);
    EXPECT_NEAR(impulse_on_Ns(rig, second), 3 * 9.81 / 60, 1e-3);
}

TEST_F(ContactCallbacks, MayTakeAwayTheManifoldThatTheyAreToldOf) {
    OurRig rig;
    rig.floor();
    btRigidBody& body = rig.box({0, btScalar(0.5), 0}, 3);
    rig.box({3, btScalar(0.5), 0}, 3);
    body.setCollisionFlags(body.getCollisionFlags() |
                           btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    calls.world = &rig.world;
    calls.to_remove_when_added = &body;
    rig.run(0.1);
    EXPECT_EQ(body.getWorldArrayIndex(), -1);
    EXPECT_EQ(calls.added, 1);
    calls.detects = true;
    rig.run(1);
    EXPECT_FALSE(calls.detects);
    EXPECT_EQ(rig.dispatcher.getNumManifolds(), 1);
}

}  // namespace
}  // namespace plumbline::bullet_world
