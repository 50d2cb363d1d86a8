// Each of Bullet's constraints in both worlds: what Bullet makes of it in short steps is what ours does at
// 60 Hz.
#include "engine/bullet_world/foreign_constraints.h"

#include "tests/engine/bullet_world/bullet_rig.h"

#include <functional>
#include <string>

namespace plumbline::bullet_world {
namespace {

/// Makes a scene and names the body to watch; the constraint joins it to a second body or to the world.
struct Scene {
    std::string name;
    std::function<btRigidBody&(OurRig&)> in_ours;
    std::function<btRigidBody&(StockRig&)> in_stock;
    double tolerance_m{0.01};
    bool moves{true};
};

template <class Make>
Scene scene(std::string name, const Make& make, double tolerance_m = 0.01, bool moves = true) {
    return {std::move(name),
            [make](OurRig& rig) -> btRigidBody& { return make(rig); },
            [make](StockRig& rig) -> btRigidBody& { return make(rig); },
            tolerance_m,
            moves};
}

btTransform turned(const btVector3& axis, btScalar angle_rad, const btVector3& at = {0, 0, 0}) {
    return btTransform(btQuaternion(axis, angle_rad), at);
}
const btVector3 kX(1, 0, 0);
const btVector3 kY(0, 1, 0);
const btVector3 kZ(0, 0, 1);

void no_gravity(auto& rig) {
    rig.world.setGravity({0, 0, 0});
}

auto& pendulum(auto& rig) {
    auto& body = rig.box({1, 0, 0}, 2);
    rig.template join<btPoint2PointConstraint>(true, body, btVector3(-1, 0, 0));
    return body;
}

auto& pulled_together(auto& rig) {
    no_gravity(rig);
    auto& a = rig.box({0, 0, 0}, 2);
    auto& b = rig.box({2, 0, 0}, 2);
    // 0.2 m apart when the constraint is made.
    rig.template join<btPoint2PointConstraint>(
        false, a, b, btVector3(btScalar(0.9), 0, 0), btVector3(btScalar(-0.9), 0, 0));
    return b;
}

/// A body that hangs beside a fixed one.
template <bool kReferenceIsA>
btHingeConstraint& hinge_beside(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({1, 1, 0}, 2);
    return rig.template join<btHingeConstraint>(
        false, a, b, btVector3(0, 1, 0), btVector3(-1, 0, 0), kZ, kZ, kReferenceIsA);
}

template <bool kReferenceIsA>
auto& limited_hinge(auto& rig) {
    auto& hinge = hinge_beside<kReferenceIsA>(rig);
    hinge.setLimit(btScalar(-0.3), btScalar(0.8));
    return hinge.getRigidBodyB();
}

template <bool kReferenceIsA>
auto& driven_hinge(auto& rig) {
    no_gravity(rig);
    auto& hinge = hinge_beside<kReferenceIsA>(rig);
    hinge.enableAngularMotor(true, btScalar(0.7), 1000);
    return hinge.getRigidBodyB();
}

/// A body that slides up and down beside a fixed one.
template <bool kReferenceIsA>
btSliderConstraint& slider_beside(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({3, 0, 0}, 2);
    const btTransform along_y = turned(kZ, SIMD_HALF_PI);
    auto& slider = rig.template join<btSliderConstraint>(
        false, a, b, btTransform(along_y.getBasis(), {3, 0, 0}), along_y, kReferenceIsA);
    slider.setLowerLinLimit(btScalar(-0.5));
    slider.setUpperLinLimit(btScalar(0.8));
    return slider;
}

template <bool kReferenceIsA>
auto& driven_slider(auto& rig) {
    no_gravity(rig);
    auto& slider = slider_beside<kReferenceIsA>(rig);
    slider.setPoweredLinMotor(true);
    slider.setMaxLinMotorForce(500);
    slider.setTargetLinMotorVelocity(btScalar(0.4));
    return static_cast<btTypedConstraint&>(slider).getRigidBodyB();
}

template <bool kReferenceIsA>
auto& falling_slider(auto& rig) {
    return static_cast<btTypedConstraint&>(slider_beside<kReferenceIsA>(rig)).getRigidBodyB();
}

auto& cone(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({2, 0, 0}, 2);
    auto& cone_twist = rig.template join<btConeTwistConstraint>(
        false, a, b, turned(kX, 0, {1, 0, 0}), turned(kX, 0, {-1, 0, 0}));
    cone_twist.setLimit(btScalar(0.6), btScalar(0.6), btScalar(0.4));
    cone_twist.setDamping(btScalar(0.2));
    return b;
}

auto& glued(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({2, 0, 0}, 2);
    rig.template join<btFixedConstraint>(
        false, a, b, turned(kX, 0, {1, 0, 0}), turned(kX, 0, {-1, 0, 0}));
    return b;
}

template <class Six, int kAxis>
auto& six_hinge(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({1, 1, 1}, 2);
    auto& six = [&]() -> auto& {
        const btTransform in_a = turned(kX, 0, {0, 1, 0});
        const btTransform in_b = turned(kX, 0, {-1, 0, -1});
        if constexpr (std::is_same_v<Six, btGeneric6DofConstraint>)
            return rig.template join<Six>(false, a, b, in_a, in_b, true);
        else
            return rig.template join<Six>(false, a, b, in_a, in_b);
    }
    ();
    six.setLinearLowerLimit({0, 0, 0});
    six.setLinearUpperLimit({0, 0, 0});
    six.setAngularLowerLimit({0, 0, 0});
    six.setAngularUpperLimit({0, 0, 0});
    six.setLimit(3 + kAxis, btScalar(-0.4), btScalar(0.7));
    return b;
}

auto& six_slider(auto& rig) {
    auto& a = rig.box({0, 0, 0}, 0);
    auto& b = rig.box({3, 0, 0}, 2);
    auto& six = rig.template join<btGeneric6DofConstraint>(
        false, a, b, turned(kX, 0, {3, 0, 0}), turned(kX, 0), true);
    six.setLinearLowerLimit({0, btScalar(-0.5), 0});
    six.setLinearUpperLimit({0, btScalar(0.8), 0});
    six.setAngularLowerLimit({0, 0, 0});
    six.setAngularUpperLimit({0, 0, 0});
    return b;
}

/// Solved by Bullet in both worlds.
auto& geared(auto& rig) {
    no_gravity(rig);
    auto& a = rig.box({0, 0, 0}, 1);
    auto& b = rig.box({3, 0, 0}, 1);
    rig.template join<btHingeConstraint>(true, a, btVector3(0, 0, 0), kZ);
    rig.template join<btHingeConstraint>(true, b, btVector3(0, 0, 0), kZ);
    rig.template join<btGearConstraint>(true, a, b, kZ, kZ, btScalar(2));
    a.setAngularVelocity({0, 0, 3});
    return b;
}

class AgainstBullet : public testing::TestWithParam<Scene> {};

TEST_P(AgainstBullet, BodiesEndWhereBulletLeadsThemInShortSteps) {
    OurRig ours;
    StockRig stock;
    btRigidBody& our_body = GetParam().in_ours(ours);
    btRigidBody& stock_body = GetParam().in_stock(stock);
    our_body.setActivationState(DISABLE_DEACTIVATION);
    stock_body.setActivationState(DISABLE_DEACTIVATION);
    stock.world.getSolverInfo().m_numIterations = 50;
    const btTransform began = our_body.getWorldTransform();
    for (const double time_s : {0.5, 1.5}) {
        ours.run(time_s);
        stock.run(time_s, btScalar(1) / 1920);
        // A corner tells of the turn too.
        for (const btVector3& point : {btVector3(0, 0, 0), btVector3(0.5, 0.5, 0.5)}) {
            const btVector3 here = our_body.getWorldTransform() * point;
            const btVector3 there = stock_body.getWorldTransform() * point;
            EXPECT_NEAR(here.distance(there), 0, GetParam().tolerance_m)
                << here.x() << ' ' << here.y() << ' ' << here.z() << " and " << there.x() << ' '
                << there.y() << ' ' << there.z();
        }
    }
    const double moved_m = static_cast<double>(place(our_body).distance(began.getOrigin()));
    EXPECT_EQ(moved_m > 1e-3, GetParam().moves) << moved_m;
}

#define PL_SCENE(name, make, ...) \
    scene(name, [](auto& rig) -> btRigidBody& { return make(rig); } __VA_OPT__(, ) __VA_ARGS__)

INSTANTIATE_TEST_SUITE_P(
    Constraints,
    AgainstBullet,
    testing::Values(
        PL_SCENE("Pendulum", pendulum, 0.03),
        PL_SCENE("PulledTogether", pulled_together, 0.02),
        PL_SCENE("LimitedHinge", limited_hinge<false>, 0.03),
        PL_SCENE("LimitedHingeOfA", limited_hinge<true>, 0.03),
        PL_SCENE("DrivenHinge", driven_hinge<false>),
        PL_SCENE("DrivenHingeOfA", driven_hinge<true>),
        PL_SCENE("DrivenSlider", driven_slider<false>),
        PL_SCENE("DrivenSliderOfA", driven_slider<true>),
        PL_SCENE("FallingSlider", falling_slider<false>),
        PL_SCENE("FallingSliderOfA", falling_slider<true>),
        PL_SCENE("Cone", cone, 0.06),
        PL_SCENE("Glued", glued, 0.01, false),
        PL_SCENE("SixHingeX", (six_hinge<btGeneric6DofConstraint, 0>), 0.02),
        PL_SCENE("SixHingeZ", (six_hinge<btGeneric6DofConstraint, 2>), 0.02),
        PL_SCENE("SpringSixHingeX", (six_hinge<btGeneric6DofSpring2Constraint, 0>), 0.02),
        PL_SCENE("SpringSixHingeZ", (six_hinge<btGeneric6DofSpring2Constraint, 2>), 0.02),
        PL_SCENE("SixSlider", six_slider),
        PL_SCENE("Geared", geared, 0.05, false)),
    [](const auto& scene_info) { return scene_info.param.name; });

TEST(ForeignJoint, WhatOursLackIsLeft) {
    StockRig rig;
    btRigidBody& a = rig.box({0, 0, 0}, 1);
    btRigidBody& b = rig.box({2, 0, 0}, 1);
    const btTransform here = btTransform::getIdentity();
    btPoint2PointConstraint dragged(a, {0, 0, 0});
    dragged.m_setting.m_impulseClamp = 30;
    EXPECT_FALSE(foreign_joint(dragged, kStep_s));
    btConeTwistConstraint uneven(a, b, here, here);
    uneven.setLimit(btScalar(0.5), btScalar(1), btScalar(0));
    EXPECT_FALSE(foreign_joint(uneven, kStep_s));
    btGearConstraint gear(a, b, kZ, kZ);
    EXPECT_FALSE(foreign_joint(gear, kStep_s));
    btGeneric6DofSpring2Constraint spring(a, b, here, here);
    spring.enableSpring(1, true);
    EXPECT_FALSE(foreign_joint(spring, kStep_s));
    btSliderConstraint turning(a, b, here, here, true);
    turning.setLowerAngLimit(-1);
    turning.setUpperAngLimit(1);
    EXPECT_FALSE(foreign_joint(turning, kStep_s));
}

TEST(ForeignJoint, ABreakingImpulseIsAForceOverTheStep) {
    StockRig rig;
    btRigidBody& a = rig.box({0, 0, 0}, 1);
    btPoint2PointConstraint point(a, {0, 0, 0});
    EXPECT_EQ(foreign_joint(point, kStep_s)->break_N, 0);
    point.setBreakingImpulseThreshold(2);
    EXPECT_NEAR(foreign_joint(point, kStep_s)->break_N, 120, 1e-3);
}

}  // namespace
}  // namespace plumbline::bullet_world
