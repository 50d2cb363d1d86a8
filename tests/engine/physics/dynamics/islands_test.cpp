// Which bodies are solved together, and that only ids decide in what order.
#include "tests/engine/physics/dynamics/island_heap.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(Islands, TheGroundDividesThem) {
    TestWorld test(in_small_steps());
    test.ground();
    // Two towers of two and three boxes, built by turns.
    test.add(BoxShape{}, {0, 0.5_r, 0}, box_at_rest(1));
    test.add(BoxShape{}, {5, 0.5_r, 0}, box_at_rest(2));
    test.add(BoxShape{}, {0, 1.5_r, 0}, box_at_rest(3));
    test.add(BoxShape{}, {5, 1.5_r, 0}, box_at_rest(4));
    test.add(BoxShape{}, {5, 2.5_r, 0}, box_at_rest(5));
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 2}, {2, 3}}));
    EXPECT_EQ(test.world.report().islands[0].contacts, 8U);
    EXPECT_EQ(test.world.report().islands[1].contacts, 12U);
}

TEST(Islands, OneBodyAcrossTwoTowersMakesOne) {
    TestWorld test(in_small_steps());
    test.ground();
    test.add(BoxShape{}, {-1, 0.5_r, 0}, box_at_rest(1));
    test.add(BoxShape{}, {1, 0.5_r, 0}, box_at_rest(2));
    test.run(0.1);
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 1}, {2, 1}}));
    test.add(BoxShape{.size_m = {3, 0.2_r, 1}}, {0, 1.1_r, 0}, box_at_rest(3));
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 3}}));
}

TEST(Islands, KinematicAndFrozenBodiesDivideThemToo) {
    TestWorld test(in_small_steps());
    const BodyId lift = test.add(BoxShape{.size_m = {8, 1, 2}},
                                 {0, -0.5_r, 0},
                                 {.kind = BodyKind::Kinematic, .velocity_mps = {0, 0.1_r, 0}});
    test.add(BoxShape{}, {-2, 0.5_r, 0}, box_at_rest(1));
    test.add(BoxShape{}, {2, 0.5_r, 0}, box_at_rest(2));
    const BodyId beam = test.add(BoxShape{.size_m = {5, 0.2_r, 1}}, {0, 1.1_r, 0}, box_at_rest(3));
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 3}}));
    test.world.set_velocity(lift, {0, 0, 0}, {0, 0, 0});
    test.world.set_frozen(beam, true);
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 1}, {2, 1}}));
}

TEST(Islands, JointsConnectUntilTheyBreak) {
    TestWorld test(in_small_steps());
    const BodyId a = test.add(SphereShape{}, {0, 5, 0}, box_at_rest(1));
    const BodyId b = test.add(SphereShape{}, {3, 5, 0}, box_at_rest(2));
    const auto joint = test.world.create_joint({.kind = JointKind::Distance,
                                                .a = a,
                                                .b = b,
                                                .anchor_a_world = {0, 5, 0},
                                                .anchor_b_world = {3, 5, 0}});
    ASSERT_TRUE(joint.ok());
    test.world.step();
    EXPECT_EQ(users_and_sizes(test.world), (IslandSizes{{1, 2}}));
    EXPECT_EQ(test.world.report().islands[0].joints, 1U);
    test.world.destroy_body(b);
    test.world.step();
    EXPECT_TRUE(test.world.report().islands.empty());
}

TEST(Islands, WhoeverIsFlungTakesNobodyAlong) {
    Heap heap;
    heap.run(200);
    PhysicsWorld& world = heap.test.world;
    const auto tie = world.create_joint({.kind = JointKind::BallAndSocket,
                                         .a = heap.ids[7],
                                         .b = heap.ids[8],
                                         .anchor_a_world = Vec3(heap.test.at(heap.ids[7])),
                                         .anchor_b_world = Vec3(heap.test.at(heap.ids[7]))});
    ASSERT_TRUE(tie.ok());
    for (int i = 0; i < 20; ++i) {
        world.apply_force(heap.ids[7], {1e9_r, -1e9_r, 0});
        heap.run(1);
    }
    heap.run(200);
    // Those two may have left; nobody else is lost, and what lay on the ground still does.
    EXPECT_LE(world.report().isolated.size(), 2U);
    int on_the_ground = 0;
    for (const BodyId id : heap.ids) {
        const Vec3d at = heap.test.at(id);
        EXPECT_TRUE(std::isfinite(at.x + at.y + at.z));
        if (at.y > 0 && glm::length(at) < 60) ++on_the_ground;
    }
    EXPECT_GE(on_the_ground, 20);
}

}  // namespace
}  // namespace plumbline::physics
