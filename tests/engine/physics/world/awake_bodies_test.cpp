// What comes to a sleeper, and wakes it or does not.
#include "engine/physics/totals.h"
#include "tests/engine/physics/world/asleep.h"

#include <algorithm>

namespace plumbline::physics {
namespace {

TEST(Waking, ByAVisitorAndByAKinematicBodyButNotByOneThatStands) {
    Asleep asleep;
    const BodyId ram = asleep.test.add(BoxShape{}, {3, 0.5_r, 0}, {.kind = BodyKind::Kinematic});
    EXPECT_EQ(asleep.awake_after_a_step(), 0U);
    asleep.test.world.set_velocity(ram, {-1, 0, 0}, {0, 0, 0});
    asleep.test.run(1.5);
    EXPECT_EQ(awake_count(asleep.test.world), 0U) << "half a metre off";
    asleep.test.run(1.0);
    EXPECT_EQ(awake_count(asleep.test.world), 3U);
    EXPECT_LT(asleep.test.at(asleep.tower[0]).x, -0.3);

    Asleep visited;
    const BodyId ball =
        visited.test.add(SphereShape{.radius_m = 0.2_r},
                         {3, 0.5_r, 0},
                         {.kind = BodyKind::Dynamic, .velocity_mps = {-8, 1.6_r, 0}});
    static_cast<void>(ball);
    visited.test.run(0.5);
    EXPECT_EQ(awake_count(visited.test.world), 4U);
}

TEST(Waking, ByAWallPutIntoIt) {
    Asleep asleep;
    asleep.test.add(BoxShape{.size_m = {1, 3, 1}}, {0.9_r, 1.5_r, 0}, {.kind = BodyKind::Static});
    EXPECT_EQ(asleep.awake_after_a_step(), 3U);
}

TEST(Waking, ByJoints) {
    Asleep asleep;
    const auto joint = asleep.test.world.create_joint({.kind = JointKind::BallAndSocket,
                                                       .a = asleep.tower[2],
                                                       .anchor_a_world = {0, 3, 0},
                                                       .anchor_b_world = {0, 3, 0}});
    ASSERT_TRUE(joint.ok());
    EXPECT_EQ(asleep.awake_after_a_step(), 3U);
}

TEST(Waking, DoesNotMakeAPileJump) {
    TestWorld test(in_small_steps());
    test.ground();
    std::vector<BodyId> pile;
    for (int i = 0; i < 27; ++i) {
        const Vec3 at{static_cast<Real>(i % 3),
                      0.5_r + static_cast<Real>(i / 9),
                      static_cast<Real>(i / 3 % 3)};
        pile.push_back(
            test.add(BoxShape{}, 1.02_r * at, {.kind = BodyKind::Dynamic, .mass_kg = 50}));
    }
    test.run(4.0);
    ASSERT_EQ(awake_count(test.world), 0U);
    for (const BodyId id : pile) test.world.wake(id);
    double fastest = 0;
    for (int i = 0; i < 30; ++i) {
        test.world.step();
        for (const BodyId id : pile) fastest = std::max(fastest, glm::length(test.velocity(id)));
    }
    EXPECT_LT(fastest, 2e-3);
}

}  // namespace
}  // namespace plumbline::physics
