// What a Bullet program sees of its world.
#include "engine/bullet_world/small_step_dynamics_world.h"

#include "tests/engine/bullet_world/bullet_rig.h"

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <BulletDynamics/Vehicle/btRaycastVehicle.h>

namespace plumbline::bullet_world {
namespace {

TEST(SmallStepDynamicsWorld, ABoxComesToRestAndSleeps) {
    OurRig rig;
    rig.floor();
    btRigidBody& box = rig.box({0, 1, 0}, 3);
    rig.run(5);
    EXPECT_NEAR(place(box).y(), 0.5, 5e-4);
    EXPECT_EQ(box.getActivationState(), ISLAND_SLEEPING);
    EXPECT_TRUE(rig.world.notes().empty());
}

TEST(SmallStepDynamicsWorld, MaterialsCombineAsBulletsDo) {
    const btScalar slope_rad = btScalar(0.5);
    OurRig rig;
    rig.world.setGravity(
        {kGravity_mps2 * std::sin(slope_rad), -kGravity_mps2 * std::cos(slope_rad), 0});
    rig.floor().setFriction(btScalar(0.5));
    btRigidBody& box = rig.box({-10, 0.5, 0}, 1);
    box.setFriction(btScalar(0.8));
    rig.run(1);
    // 0.5 times 0.8; ours would be the root of it.
    const double expected = 9.81 * (std::sin(0.5) - 0.4 * std::cos(0.5));
    EXPECT_NEAR(box.getLinearVelocity().x(), expected, 0.01 * expected);
}

TEST(SmallStepDynamicsWorld, ABallBouncesWithTheProductOfRestitutions) {
    OurRig rig;
    rig.floor().setRestitution(btScalar(0.8));
    btRigidBody& ball = rig.add(rig.shape<btSphereShape>(btScalar(0.5)), {0, 1.5, 0}, 1);
    ball.setRestitution(btScalar(0.5));
    double highest = 0;
    bool bounced = false;
    for (int i = 0; i < 120; ++i) {
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
        bounced = bounced || ball.getLinearVelocity().y() > 0;
        if (bounced) highest = std::max(highest, static_cast<double>(place(ball).y()));
    }
    EXPECT_NEAR(highest - 0.5, 0.4 * 0.4, 0.01);
}

TEST(SmallStepDynamicsWorld, FiltersAndIgnoredObjectsAreLetThrough) {
    OurRig rig;
    btRigidBody& floor = rig.loose(rig.shape<btBoxShape>(btVector3(20, 1, 20)), {0, -1, 0}, 0);
    rig.world.addRigidBody(&floor, 1, 2);
    btBoxShape& box = rig.shape<btBoxShape>(btVector3(0.5, 0.5, 0.5));
    btRigidBody& held = rig.loose(box, {0, 0.5, 0}, 1);
    rig.world.addRigidBody(&held, 2, 1);
    btRigidBody& other_group = rig.loose(box, {3, 0.5, 0}, 1);
    rig.world.addRigidBody(&other_group, 4, 1);
    btRigidBody& ignored = rig.loose(box, {6, 0.5, 0}, 1);
    rig.world.addRigidBody(&ignored, 2, 1);
    rig.run(0.5);
    ignored.setIgnoreCollisionCheck(&floor, true);
    rig.run(1);
    EXPECT_NEAR(place(held).y(), 0.5, 1e-3);
    EXPECT_LT(place(other_group).y(), -5);
    EXPECT_LT(place(ignored).y(), -3);
}

TEST(SmallStepDynamicsWorld, MotionStatesAreInterpolated) {
    OurRig rig;
    btDefaultMotionState state(btTransform(btQuaternion::getIdentity(), {0, 0, 0}));
    btRigidBody& box = rig.box({0, 0, 0}, 1);
    box.setMotionState(&state);
    rig.world.setGravity({0, 0, 0});
    box.setLinearVelocity({6, 0, 0});
    // After two steps and a half Bullet shows the middle of the second one.
    rig.world.stepSimulation(kStep_s * btScalar(2.5), 10, kStep_s);
    btTransform seen;
    state.getWorldTransform(seen);
    EXPECT_NEAR(seen.getOrigin().x(), 6 * 1.5 / 60, 1e-4);
    EXPECT_NEAR(place(box).x(), 6 * 2.0 / 60, 1e-4);
    box.setMotionState(nullptr);
}

TEST(SmallStepDynamicsWorld, AGhostKnowsWhatIsInIt) {
    OurRig rig;
    btGhostPairCallback pairs;
    rig.broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&pairs);
    btGhostObject ghost;
    ghost.setCollisionShape(&rig.shape<btBoxShape>(btVector3(1, 1, 1)));
    ghost.setCollisionFlags(ghost.getCollisionFlags() | btCollisionObject::CF_NO_CONTACT_RESPONSE);
    ghost.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, -3, 0}));
    rig.world.addCollisionObject(
        &ghost, btBroadphaseProxy::SensorTrigger, btBroadphaseProxy::AllFilter);
    btRigidBody& box = rig.box({0, 0, 0}, 1);
    EXPECT_EQ(ghost.getNumOverlappingObjects(), 0);
    rig.run(0.8);  // 3.1 m: through it, not stopped
    EXPECT_NEAR(place(box).y(), -9.81 * 0.8 * 0.8 / 2, 0.05);
    EXPECT_EQ(ghost.getNumOverlappingObjects(), 1);
    rig.run(1);
    EXPECT_EQ(ghost.getNumOverlappingObjects(), 0);
    rig.world.removeCollisionObject(&ghost);
}

TEST(SmallStepDynamicsWorld, AVehicleDrives) {
    OurRig rig;
    rig.floor();
    btRigidBody& chassis = rig.add(
        rig.shape<btBoxShape>(btVector3(1, btScalar(0.3), 2)), {0, btScalar(1.5), -15}, 800);
    chassis.setActivationState(DISABLE_DEACTIVATION);
    btDefaultVehicleRaycaster raycaster(&rig.world);
    btRaycastVehicle::btVehicleTuning tuning;
    btRaycastVehicle vehicle(tuning, &chassis, &raycaster);
    vehicle.setCoordinateSystem(0, 1, 2);
    rig.world.addVehicle(&vehicle);
    for (const btScalar z : {btScalar(1.5), btScalar(-1.5)}) {
        for (const btScalar x : {btScalar(0.9), btScalar(-0.9)})
            vehicle.addWheel(
                {x, 0, z}, {0, -1, 0}, {-1, 0, 0}, btScalar(0.6), btScalar(0.4), tuning, z > 0);
    }
    rig.run(2);
    for (int wheel : {2, 3}) vehicle.applyEngineForce(1000, wheel);
    const btScalar z_before = place(chassis).z();
    rig.run(3);
    EXPECT_GT(place(chassis).z() - z_before, 5);
    EXPECT_NEAR(place(chassis).x(), 0, 0.1);
    EXPECT_GT(place(chassis).y(), 0.5);
    rig.world.removeVehicle(&vehicle);
}

template <class AnyRig>
btVector3 where_a_character_walks() {
    AnyRig rig;
    rig.floor();
    btGhostPairCallback pairs;
    rig.broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&pairs);
    btPairCachingGhostObject ghost;
    auto& capsule = rig.template shape<btCapsuleShape>(btScalar(0.4), btScalar(1));
    ghost.setCollisionShape(&capsule);
    ghost.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
    ghost.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 2, 0}));
    btKinematicCharacterController character(&ghost, &capsule, btScalar(0.3), {0, 1, 0});
    rig.world.addCollisionObject(
        &ghost,
        btBroadphaseProxy::CharacterFilter,
        btBroadphaseProxy::StaticFilter | btBroadphaseProxy::DefaultFilter);
    rig.world.addAction(&character);
    rig.run(1.5);
    character.setWalkDirection({btScalar(0.05), 0, 0});
    rig.run(1);
    rig.world.removeAction(&character);
    rig.world.removeCollisionObject(&ghost);
    return ghost.getWorldTransform().getOrigin();
}

TEST(SmallStepDynamicsWorld, ACharacterWalksAsInBulletsWorld) {
    const btVector3 ours = where_a_character_walks<OurRig>();
    const btVector3 stock = where_a_character_walks<StockRig>();
    EXPECT_NEAR(ours.x(), stock.x(), 1e-3);
    EXPECT_NEAR(ours.y(), stock.y(), 1e-3);
    EXPECT_NEAR(ours.x(), 3, 0.1);
}

TEST(SmallStepDynamicsWorld, TickCallbacksMayAddAndTakeAway) {
    OurRig rig;
    rig.floor();
    struct Change {
        OurRig& rig;
        btCollisionShape& shape;
        std::vector<btRigidBody*> boxes{};
        int ticks{0};
    } change{rig, rig.shape<btBoxShape>(btVector3(btScalar(0.2), btScalar(0.2), btScalar(0.2)))};
    rig.world.setInternalTickCallback(
        [](btDynamicsWorld* world, btScalar) {
            auto& to = *static_cast<Change*>(world->getWorldUserInfo());
            if (++to.ticks % 10 == 0) to.boxes.push_back(&to.rig.add(to.shape, {0, 1, 0}, 1));
            if (to.ticks % 25 == 0) {
                world->removeRigidBody(to.boxes.front());
                to.boxes.erase(to.boxes.begin());
            }
        },
        &change);
    rig.run(5);
    EXPECT_EQ(change.ticks, 300);
    EXPECT_EQ(rig.world.getNumCollisionObjects(), 1 + 30 - 12);
    for (const btRigidBody* box : change.boxes) EXPECT_GT(place(*box).y(), 0.19);
}

TEST(SmallStepDynamicsWorld, TheSameCallsGiveTheSameBits) {
    const auto end_of = [] {
        OurRig rig;
        rig.floor();
        btRigidBody* last = nullptr;
        for (int i = 0; i < 10; ++i)
            last = &rig.box({btScalar(0.1) * btScalar(i), 1 + btScalar(1.1) * btScalar(i), 0}, 1);
        rig.run(3);
        return place(*last);
    };
    EXPECT_EQ(end_of(), end_of());
}

}  // namespace
}  // namespace plumbline::bullet_world
