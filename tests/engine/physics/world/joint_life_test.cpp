// Joints come, break and go, and wake what they hold; bad ones are refused.
#include "engine/physics/totals.h"
#include "tests/engine/physics/joint_bench.h"

#include <algorithm>
#include <array>
#include <limits>

namespace plumbline::physics {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
const BodyDef kSleepyBody{.kind = BodyKind::Dynamic, .mass_kg = 2};
const BoxShape kRod{.size_m = {0.1_r, 1, 0.1_r}};

class JointLife : public JointTest {};
INSTANTIATE_TEST_SUITE_P(Solvers, JointLife, testing::ValuesIn(kJointBars), name_of);

TEST_P(JointLife, BreaksAtItsLoadOnceAndForGood) {
    TestWorld test(bar().world());
    const BodyId rod = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const JointId pivot = join(test, {.a = rod, .break_N = 50, .user = 7});
    const JointId other = join(test,
                               {.a = test.add(kRod, {5, -0.5_r, 0}, kSleepyBody),
                                .anchor_a_world = {5, 0, 0},
                                .break_N = 50});
    test.run(1);
    EXPECT_TRUE(test.world.report().broken_joints.empty());
    // 1 N more with every step: 2 kg weigh 19.62 N, so the 31st is too much.
    int steps = 0;
    while (test.world.report().broken_joints.empty() && steps < 100) {
        test.world.apply_force(rod, {0, -static_cast<Real>(++steps), 0});
        test.world.step();
    }
    EXPECT_EQ(steps, 31);
    ASSERT_EQ(test.world.report().broken_joints.size(), 1U);
    EXPECT_EQ(test.world.report().broken_joints[0], pivot);
    EXPECT_TRUE(test.world.joint(pivot).state.broken);
    EXPECT_NEAR(force_N(test, pivot), 2 * kG + 31, 0.01);
    EXPECT_EQ(test.world.joint(pivot).def.user, 7U);
    EXPECT_FALSE(test.world.joint(other).state.broken);

    const double start_m = test.at(rod).y;
    test.run(1);
    EXPECT_TRUE(test.world.report().broken_joints.empty()) << "said once";
    EXPECT_EQ(force_N(test, pivot) + torque_Nm(test, pivot), 0) << "it carries nothing";
    EXPECT_TRUE(test.world.contains(pivot)) << "and kept";
    EXPECT_NEAR(test.at(rod).y, start_m - 0.5 * kG, 0.01);
    EXPECT_EQ(joint_count(test.world), 2U);
}

TEST_P(JointLife, KeepsItsBodiesFromTouchingUnlessAsked) {
    for (const bool collide : {false, true}) {
        TestWorld test(bar().world({0, 0, 0}));
        const BodyId a = test.add(BoxShape{}, {0, 0, 0}, kSleepyBody);
        const BodyId b = test.add(BoxShape{}, {0.9_r, 0, 0}, kSleepyBody);
        join(test,
             {.kind = JointKind::Hinge,
              .a = a,
              .b = b,
              .anchor_a_world = {0.45_r, 0, 0},
              .collide = collide});
        test.run(0.1);
        EXPECT_EQ(all_contacts(test.world).size(), collide ? 1U : 0U);
    }
}

TEST_P(JointLife, TouchingEndsAndReturnsWithTheJoint) {
    TestWorld test(bar().world());
    test.ground();
    const BodyId low = test.add(BoxShape{}, {0, 0.5_r, 0}, kSleepyBody);
    const BodyId high = test.add(BoxShape{}, {0, 1.5_r, 0}, kSleepyBody);
    test.run(1);
    EXPECT_EQ(all_contacts(test.world).size(), 2U);
    const JointDef def{
        .kind = JointKind::Fixed, .a = high, .b = low, .anchor_a_world = {0, 1, 0}, .break_N = 100};
    JointDef weak = def;
    weak.break_N = 5;
    const JointId lasting = join(test, def);
    const JointId passing = join(test, weak);
    test.world.step();
    EXPECT_EQ(all_contacts(test.world).size(), 1U) << "no stale points between the two";
    test.run(0.2);
    ASSERT_TRUE(test.world.joint(passing).state.broken);
    EXPECT_NEAR(force_N(test, lasting), 2 * kG, 0.5) << "it carries the upper one";
    EXPECT_EQ(all_contacts(test.world).size(), 1U) << "the other still forbids it";
    // Torn off sideways: broken joints let the bodies touch again.
    test.world.apply_impulse(high, {0, -30, 0});
    test.world.step();
    EXPECT_TRUE(test.world.joint(lasting).state.broken);
    test.run(0.5);
    EXPECT_EQ(all_contacts(test.world).size(), 2U);
    EXPECT_NEAR(test.at(high).y, 1.5, 0.05);
}

TEST_P(JointLife, SleepersWakeWithTheirJoints) {
    TestWorld test(bar().world());
    const BodyId upper = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const BodyId lower = test.add(kRod, {0, -1.5_r, 0}, kSleepyBody);
    const JointId top = join(test, {.kind = JointKind::Hinge, .a = upper});
    const JointId middle = join(
        test, {.kind = JointKind::Hinge, .a = lower, .b = upper, .anchor_a_world = {0, -1, 0}});
    const auto sleep = [&] {
        test.run(6);
        EXPECT_EQ(awake_count(test.world), 0U);
    };
    sleep();
    EXPECT_NEAR(force_N(test, top), 4 * kG, 0.01) << "as it last was";
    test.world.set_joint_motor(middle, JointMotor{.target = 0, .max = 1});
    EXPECT_EQ(awake_count(test.world), 2U);
    sleep();
    join(test,
         {.kind = JointKind::Distance,
          .a = upper,
          .anchor_a_world = {0, -1, 0},
          .anchor_b_world = {2, -1, 0}});
    EXPECT_GE(awake_count(test.world), 1U);
    sleep();
    test.world.destroy_body(upper);
    const double start_m = test.at(lower).y;
    test.run(0.5);
    EXPECT_NEAR(test.at(lower).y, start_m - 0.5 * kG * 0.25, 0.1) << "falls at once";
}

TEST_P(JointLife, ASleeperFollowsWhatCarriesIt) {
    TestWorld test(bar().world());
    const BodyId hook = test.add(BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Kinematic});
    const BodyId rod = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const JointId pivot = join(test, {.kind = JointKind::Fixed, .a = rod, .b = hook});
    test.run(6);
    ASSERT_EQ(awake_count(test.world), 0U);
    for (int i = 1; i <= 60; ++i) {
        test.world.move_kinematic(hook,
                                  {.position = {0, 0.5_r + static_cast<Real>(i) / 60.0_r, 0}});
        test.world.step();
    }
    EXPECT_NEAR(test.at(rod).y, 0.5, 0.1);
    EXPECT_LE(test.world.joint(pivot).state.error_m, 0.1);
}

TEST_P(JointLife, HoldsOnToWhatStandsStill) {
    TestWorld test(bar().world());
    BodyDef post{.world_from_body = {.orientation = quat_from_euler_deg({20, 30, 40})}};
    const BodyId stand = test.add(BoxShape{}, {3, 2, 1}, post);
    const BodyId rod = test.add(kRod, {3, 0.5_r, 1}, kSleepyBody);
    const JointId pivot =
        join(test, {.kind = JointKind::Hinge, .a = rod, .b = stand, .anchor_a_world = {3, 1, 1}});
    test.run(3);
    EXPECT_NEAR(force_N(test, pivot), 2 * kG, 0.01);
    EXPECT_NEAR(test.at(rod).y, 0.5, 0.01);
    EXPECT_NEAR(test.at(rod).x, 3, 0.01);
}

TEST_P(JointLife, GoesWithEitherBody) {
    TestWorld test(bar().world());
    const BodyId a = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const BodyId b = test.add(kRod, {0, -1.5_r, 0}, kSleepyBody);
    const BodyId c = test.add(kRod, {0, -2.5_r, 0}, kSleepyBody);
    const JointId top = join(test, {.a = a});
    const JointId upper = join(test, {.a = b, .b = a, .anchor_a_world = {0, -1, 0}});
    const JointId lower = join(test, {.a = c, .b = b, .anchor_a_world = {0, -2, 0}});
    test.run(6);
    test.world.destroy_body(b);
    EXPECT_TRUE(test.world.contains(top));
    EXPECT_FALSE(test.world.contains(upper));
    EXPECT_FALSE(test.world.contains(lower));
    EXPECT_EQ(awake_count(test.world), 2U) << "both neighbours wake";
    test.run(0.5);
    EXPECT_NEAR(test.at(c).y, -2.5 - 0.5 * kG * 0.25, 0.01);
    EXPECT_NEAR(force_N(test, top), 2 * kG, 0.01);
    EXPECT_EQ(joint_count(test.world), 1U);
}

TEST_P(JointLife, APoisonedBodyTakesItsJointsAndNoMore) {
    TestWorld test(bar().world());
    const BodyId a = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const BodyId b = test.add(kRod, {0, -1.5_r, 0}, kSleepyBody);
    const JointId top = join(test, {.a = a});
    const JointId between = join(test, {.a = b, .b = a, .anchor_a_world = {0, -1, 0}});
    test.run(0.5);
    test.world.set_velocity(b, {kNan, 0, 0}, {0, 0, 0});
    test.run(1);
    ASSERT_EQ(test.world.report().isolated.size(), 1U);
    EXPECT_FALSE(test.world.contains(between));
    EXPECT_NEAR(force_N(test, top), 2 * kG, 0.01);
    EXPECT_FALSE(test.world.create_joint({.a = b}).ok());
}

TEST_P(JointLife, HoldsWhileABodyIsFrozen) {
    TestWorld test(bar().world());
    const BodyId a = test.add(kRod, {0, -0.5_r, 0}, kSleepyBody);
    const BodyId b = test.add(kRod, {0, -1.5_r, 0}, kSleepyBody);
    join(test, {.kind = JointKind::Fixed, .a = a});
    const JointId between = join(test, {.a = b, .b = a, .anchor_a_world = {0, -1, 0}});
    test.run(0.5);
    test.world.set_frozen(a, true);
    test.run(1);
    EXPECT_NEAR(force_N(test, between), 2 * kG, 0.01);
    EXPECT_NEAR(test.at(b).y, -1.5, 1e-3);
    test.world.set_frozen(b, true);
    test.run(0.1);
    EXPECT_NEAR(test.at(b).y, -1.5, 1e-3);
    test.world.set_frozen(a, false);
    test.world.set_frozen(b, false);
    test.run(1);
    EXPECT_NEAR(force_N(test, between), 2 * kG, 0.01);
    EXPECT_NEAR(test.at(b).y, -1.5, 1e-2);
}

TEST_P(JointLife, ATeleportedBodyIsPulledBack) {
    TestWorld test(bar().world());
    BodyDef damped = kSleepyBody;
    damped.linear_damping_per_s = 2;
    damped.angular_damping_per_s = 2;
    const BodyId a = test.add(kRod, {0, -0.5_r, 0}, damped);
    const BodyId b = test.add(kRod, {0, -1.5_r, 0}, damped);
    join(test, {.a = a});
    join(test, {.a = b, .b = a, .anchor_a_world = {0, -1, 0}});
    test.run(6);
    test.world.set_pose(b, {.position = {3, -1.5_r, 0}});
    EXPECT_EQ(awake_count(test.world), 2U) << "both ends wake";
    test.world.step();
    EXPECT_GT(max_joint_error_m(test.world), 0.1);
    double fastest_mps = 0;
    for (int i = 0; i < 600; ++i) {
        test.world.step();
        fastest_mps = std::max(fastest_mps, glm::length(test.velocity(b)));
    }
    EXPECT_LT(max_joint_error_m(test.world), 0.01);
    EXPECT_LT(fastest_mps, 200);
    EXPECT_TRUE(test.world.report().isolated.empty());
}

TEST_P(JointLife, SameCallsSameBits) {
    const auto run = [&](std::size_t ballast) {
        std::vector<std::vector<char>> junk(ballast, std::vector<char>(555));
        TestWorld test(bar().world());
        test.ground();
        std::vector<BodyId> ids;
        BodyId last{};
        for (int i = 0; i < 6; ++i) {
            const Real x = static_cast<Real>(i);
            ids.push_back(
                test.add(BoxShape{.size_m = {0.9_r, 0.2_r, 0.4_r}}, {x, 3, 0}, kSleepyBody));
            const auto kind = static_cast<JointKind>(i);
            const Vec3 anchor{x - 0.5_r, 3, 0};
            join(test,
                 {.kind = kind,
                  .a = ids.back(),
                  .b = last,
                  .anchor_a_world = anchor,
                  .anchor_b_world = anchor - Vec3{0.4_r, 0, 0},
                  .break_N = 150});
            last = ids.back();
        }
        test.run(4);
        return test.hash(ids);
    };
    EXPECT_EQ(run(0), run(0));
    EXPECT_EQ(run(0), run(1000));
}

TEST_P(JointLife, OneThatIsDestroyedLetsGo) {
    TestWorld test(bar().world());
    test.ground();
    const BodyId rod = test.add(kRod, {0, 3, 0}, kSleepyBody);
    const BodyId below = test.add(kRod, {0, 2, 0}, kSleepyBody);
    const JointId top = join(test, {.a = rod, .anchor_a_world = {0, 3.5_r, 0}});
    const JointId between = join(test, {.a = rod, .b = below, .anchor_a_world = {0, 2.5_r, 0}});
    test.run(3);
    EXPECT_NEAR(test.at(below).y, 2, 0.01);
    destroy_joint(test.world, between);
    EXPECT_FALSE(test.world.contains(between));
    EXPECT_TRUE(test.world.contains(top));
    test.run(1);
    EXPECT_NEAR(test.at(below).y, 0.5, 0.05);
    destroy_joint(test.world, top);
    test.run(0.3);
    EXPECT_NEAR(test.at(rod).y, 3 - kG * 0.09 / 2, 0.05);
}

}  // namespace
}  // namespace plumbline::physics
