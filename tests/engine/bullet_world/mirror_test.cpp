// What of an object makes its body, and what does not.
#include "engine/bullet_world/mirror.h"

#include "tests/engine/bullet_world/bullet_rig.h"

namespace plumbline::bullet_world {
namespace {

TEST(Mirror, APoseComesBack) {
    const btTransform there(btQuaternion(btVector3(1, 2, 3).normalized(), 1), {4, 5, 6});
    const btTransform back = transform_of(pose_of(there));
    EXPECT_NEAR((back.getOrigin() - there.getOrigin()).length(), 0, 1e-6);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR((back.getBasis()[i] - there.getBasis()[i]).length(), 0, 1e-6);
}

TEST(Mirror, TraitsSayTheKind) {
    StockRig rig;
    btRigidBody& body = rig.box({0, 0, 0}, 2);
    EXPECT_EQ(traits_of(body).kind, physics::BodyKind::Dynamic);
    EXPECT_EQ(traits_of(rig.box({3, 0, 0}, 0)).kind, physics::BodyKind::Static);
    EXPECT_EQ(traits_of(rig.box({6, 0, 0}, -2)).kind, physics::BodyKind::Static);
    body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    EXPECT_EQ(traits_of(body).kind, physics::BodyKind::Kinematic);
}

TEST(Mirror, MotionIsNoTraitAndAnythingElseIs) {
    StockRig rig;
    btRigidBody& body = rig.box({0, 0, 0}, 2);
    const BodyTraits before = traits_of(body);
    body.setLinearVelocity({1, 2, 3});
    body.setWorldTransform(btTransform(btQuaternion::getIdentity(), {9, 9, 9}));
    body.applyCentralForce({1, 0, 0});
    EXPECT_EQ(traits_of(body), before);
    body.setFriction(btScalar(0.1));
    EXPECT_NE(traits_of(body), before);
    body.setFriction(1);
    body.getCollisionShape()->setLocalScaling({2, 1, 1});
    EXPECT_NE(traits_of(body), before);
}

TEST(Mirror, ANoteIsKeptOnce) {
    Notes notes;
    notes.add("one");
    notes.add("two");
    notes.add("one");
    EXPECT_EQ(notes.all(), (std::vector<std::string>{"one", "two"}));
}

}  // namespace
}  // namespace plumbline::bullet_world
