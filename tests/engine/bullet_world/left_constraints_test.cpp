// Constraints that small_step lacks hold none the less.
#include "engine/bullet_world/left_constraints.h"

#include "tests/engine/bullet_world/bullet_rig.h"

namespace plumbline::bullet_world {
namespace {

/// How high a load of 2 kg comes to rest on a spring of 200 N/m.
template <class AnyRig>
double hangs_at_m(AnyRig& rig) {
    btRigidBody& base = rig.box({0, 0, 0}, 0);
    btRigidBody& load = rig.box({0, -2, 0}, 2);
    btTransform below(btQuaternion::getIdentity(), {0, -2, 0});
    auto& spring = rig.template join<btGeneric6DofSpring2Constraint>(
        false, base, load, below, btTransform::getIdentity());
    spring.setLinearLowerLimit({0, -10, 0});
    spring.setLinearUpperLimit({0, 10, 0});
    spring.enableSpring(1, true);
    spring.setStiffness(1, 200);
    spring.setDamping(1, 30);
    rig.run(5);
    return static_cast<double>(place(load).y());
}

TEST(LeftConstraints, ASpringCarriesItsLoad) {
    OurRig ours;
    const double hangs = hangs_at_m(ours);
    EXPECT_NEAR(hangs, -2 - 2 * 9.81 / 200, 1e-3);
    StockRig stock;
    EXPECT_NEAR(hangs, hangs_at_m(stock), 1e-3);
    ASSERT_EQ(ours.world.notes().size(), 1U);
    EXPECT_NE(ours.world.notes().front().find("solved by Bullet"), std::string::npos);
}

TEST(LeftConstraints, ADraggedBodyComesAlong) {
    OurRig rig;
    rig.floor();
    btRigidBody& body = rig.box({0, 0.5, 0}, 1);
    auto& drag = rig.join<btPoint2PointConstraint>(true, body, btVector3(0, 0.5, 0));
    drag.m_setting.m_impulseClamp = 1;
    drag.m_setting.m_tau = btScalar(0.1);
    for (int i = 0; i < 120; ++i) {
        drag.setPivotB({btScalar(i) / 60, 2, 0});
        rig.world.stepSimulation(kStep_s, 1, kStep_s);
    }
    EXPECT_NEAR((body.getWorldTransform() * btVector3(0, 0.5, 0)).distance({2, 2, 0}), 0, 0.5);
}

TEST(LeftConstraints, WhatTheyHoldMayRestOnTheFloor) {
    OurRig rig;
    rig.floor();
    btRigidBody& a = rig.box({0, 0.5, 0}, 1);
    btRigidBody& b = rig.box({2, 0.5, 0}, 1);
    const btTransform right(btQuaternion::getIdentity(), {1, 0, 0});
    const btTransform left(btQuaternion::getIdentity(), {-1, 0, 0});
    auto& uneven = rig.join<btConeTwistConstraint>(false, a, b, right, left);
    uneven.setLimit(btScalar(0.3), btScalar(0.9), btScalar(0.1));
    rig.run(3);
    EXPECT_NEAR(place(a).y(), 0.5, 2e-3);
    EXPECT_NEAR(place(b).y(), 0.5, 2e-3);
    EXPECT_NEAR((place(b) - place(a)).length(), 2, 5e-3);
}

}  // namespace
}  // namespace plumbline::bullet_world
