// Joints as Bullet solves them.
#include "tests/engine/physics/joint_bench.h"

#include <optional>

namespace plumbline::physics {
namespace {

WorldDef bullet_joints_world(const Vec3& gravity_mps2) {
    return {.gravity_mps2 = gravity_mps2, .iterations = 10, .solver = Solver::BulletSi};
}

TEST(BulletJoints, WhatSleepsStillCarriesItsLoad) {
    TestWorld test(bullet_joints_world({0, -9.81_r, 0}));
    const BodyId rod = test.add(
        BoxShape{{0.1_r, 1, 0.1_r}}, {0, -0.5_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 2});
    const JointId pivot = join(test, {.a = rod});
    test.run(4);
    ASSERT_FALSE(test.world.state(rod).awake);
    EXPECT_NEAR(force_N(test, pivot), 2 * kG, 1e-2);
    EXPECT_NEAR(torque_Nm(test, pivot), 0, 1e-3);
}

// Bullet measures its second body against its first, ours are the other way: both signs must agree.
TEST(BulletJoints, MotorsAndPositionsHaveOneSign) {
    for (const JointKind kind : {JointKind::Hinge, JointKind::Slider}) {
        TestWorld test(bullet_joints_world({0, 0, 0}));
        const BodyId a = test.add(BoxShape{}, {0, 0, 0});
        const JointId joint = join(test,
                                   {.kind = kind,
                                    .a = a,
                                    .axis_world = {0, 1, 0},
                                    .motor = JointMotor{.target = 2, .max = 1000}});
        test.run(1);
        EXPECT_NEAR(position(test, joint), 2, 0.05);
        EXPECT_NEAR(kind == JointKind::Hinge ? test.spin(a).y : test.velocity(a).y, 2, 1e-3);
        test.world.set_joint_motor(joint, JointMotor{.target = -2, .max = 1000});
        test.run(2);
        EXPECT_NEAR(position(test, joint), -2, 0.1);
        test.world.set_joint_motor(joint, std::nullopt);
        test.run(1);
        EXPECT_NEAR(position(test, joint), -4, 0.15) << "let go, it goes on by itself";
    }
}

}  // namespace
}  // namespace plumbline::physics
