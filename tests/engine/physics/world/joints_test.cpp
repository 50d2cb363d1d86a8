// Joints that cannot be, and motors that are none.
#include "engine/physics/totals.h"
#include "tests/engine/physics/joint_bench.h"

#include <functional>
#include <limits>

namespace plumbline::physics {
namespace {

const BodyDef kHeldBody{.kind = BodyKind::Dynamic, .mass_kg = 2};

struct BadJoint {
    const char* says;
    std::function<void(JointDef&)> spoil;
};

TEST(JointFaults, AreRefusedByWhatIsWrong) {
    TestWorld test;
    const BodyId body = test.add(BoxShape{}, {0, 5, 0}, kHeldBody);
    const BodyId wall = test.ground();
    const BodyId cart = test.add(BoxShape{}, {0, 9, 0}, {.kind = BodyKind::Kinematic});
    const BodyId gone = test.add(BoxShape{}, {0, 9, 0}, kHeldBody);
    test.world.destroy_body(gone);
    const BadJoint cases[] = {
        {"a is no body", [](JointDef& def) { def.a = {}; }},
        {"a is no body", [&](JointDef& def) { def.a = gone; }},
        {"b is no body", [&](JointDef& def) { def.b = gone; }},
        {"joined to itself", [&](JointDef& def) { def.b = body; }},
        {"neither body can move", [&](JointDef& def) { def.a = wall; }},
        {"neither body can move",
         [&](JointDef& def) {
             def.a = wall;
             def.b = cart;
         }},
        {"anchors must be finite", [](JointDef& def) { def.anchor_a_world.x = kNan; }},
        {"anchors must be finite",
         [](JointDef& def) { def.anchor_b_world.z = std::numeric_limits<Real>::infinity(); }},
        {"axis has no direction",
         [](JointDef& def) {
             def.axis_world = {0, 0, 0};
         }},
        {"axis must be finite", [](JointDef& def) { def.axis_world.y = kNan; }},
        {"limits cross",
         [](JointDef& def) {
             def.limits = {{1, 0.5_r}};
         }},
        {"limits must be finite",
         [](JointDef& def) {
             def.limits = {{kNan, 1}};
         }},
        {"twist limits cross",
         [](JointDef& def) {
             def.twist_limits = {{1, -1}};
         }},
        {"motor needs", [](JointDef& def) { def.motor = JointMotor{.target = 1, .max = -1}; }},
        {"motor needs", [](JointDef& def) { def.motor = JointMotor{.target = kNan, .max = 1}; }},
        {"stiffness and damping", [](JointDef& def) { def.stiffness_Npm = -1; }},
        {"stiffness and damping",
         [](JointDef& def) { def.damping_Nspm = std::numeric_limits<Real>::infinity(); }},
        {"rest length", [](JointDef& def) { def.rest_length_m = -1.0_r; }},
        {"breaking force", [](JointDef& def) { def.break_N = kNan; }},
        {"use a ball-and-socket joint", [](JointDef& def) { def.kind = JointKind::Distance; }},
        {"below 0",
         [](JointDef& def) {
             def.kind = JointKind::Distance;
             def.limits = {{-1, 1}};
         }},
    };
    for (const BadJoint& bad : cases) {
        JointDef def{.kind = JointKind::Hinge, .a = body};
        bad.spoil(def);
        const Result<JointId> made = test.world.create_joint(def);
        ASSERT_FALSE(made.ok()) << bad.says;
        EXPECT_NE(made.error().message.find(bad.says), std::string::npos) << made.error().message;
    }
    EXPECT_EQ(joint_count(test.world), 0U);
    // The axis of a joint that has none may be anything.
    EXPECT_TRUE(test.world.create_joint({.a = body, .axis_world = {0, 0, 0}}).ok());
}

TEST(JointFaults, AMotorThatIsNoneChangesNothing) {
    TestWorld test(weightless());
    const BodyId wheel = test.add(CylinderShape{}, {0, 0, 0}, kHeldBody);
    const JointId hinge =
        join(test, {.kind = JointKind::Hinge, .a = wheel, .motor = JointMotor{1, 5}});
    const JointId ball = join(test, {.a = wheel});
    test.world.set_joint_motor(hinge, JointMotor{.target = kNan, .max = 1});
    test.world.set_joint_motor(hinge, JointMotor{.target = 1, .max = -1});
    test.world.set_joint_motor(ball, JointMotor{.target = 1, .max = 1});
    ASSERT_TRUE(test.world.joint(hinge).def.motor.has_value());
    EXPECT_EQ(test.world.joint(hinge).def.motor->max, Real{5});
    EXPECT_FALSE(test.world.joint(ball).def.motor.has_value());
    test.run(2);
    EXPECT_NEAR(test.spin(wheel).y, 1, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
