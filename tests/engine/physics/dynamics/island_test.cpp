// Which bodies are solved together, and that only ids decide in what order.
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

BodyDef box_at_rest(std::uint64_t user) {
    return {.kind = BodyKind::Dynamic, .can_sleep = false, .user = user};
}

std::vector<std::pair<std::uint64_t, std::uint32_t>> users_and_sizes(const PhysicsWorld& world) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> list;
    for (const IslandReport& island : world.islands()) {
        list.emplace_back(island.user, island.bodies);
    }
    return list;
}

using List = std::vector<std::pair<std::uint64_t, std::uint32_t>>;

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
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 2}, {2, 3}}));
    EXPECT_EQ(test.world.islands()[0].contacts, 8U);
    EXPECT_EQ(test.world.islands()[1].contacts, 12U);
}

TEST(Islands, OneBodyAcrossTwoTowersMakesOne) {
    TestWorld test(in_small_steps());
    test.ground();
    test.add(BoxShape{}, {-1, 0.5_r, 0}, box_at_rest(1));
    test.add(BoxShape{}, {1, 0.5_r, 0}, box_at_rest(2));
    test.run(0.1);
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 1}, {2, 1}}));
    test.add(BoxShape{.size_m = {3, 0.2_r, 1}}, {0, 1.1_r, 0}, box_at_rest(3));
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 3}}));
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
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 3}}));
    test.world.set_velocity(lift, {0, 0, 0}, {0, 0, 0});
    test.world.set_frozen(beam, true);
    test.run(0.2);
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 1}, {2, 1}}));
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
    EXPECT_EQ(users_and_sizes(test.world), (List{{1, 2}}));
    EXPECT_EQ(test.world.islands()[0].joints, 1U);
    test.world.destroy_body(b);
    test.world.step();
    EXPECT_TRUE(test.world.islands().empty());
}

TEST(Islands, WhatFliesBelongsToNoneAndFliesAsIfAlone) {
    const BodyDef flying{.kind = BodyKind::Dynamic,
                         .velocity_mps = {1, 5, 0.3_r},
                         .angular_velocity_radps = {1, 2, 3}};
    TestWorld alone(in_small_steps());
    const BodyId a = alone.add(BoxShape{.size_m = {1, 2, 3}}, {0, 20, 0}, flying);
    TestWorld crowd(in_small_steps());
    const BodyId b = crowd.add(BoxShape{.size_m = {1, 2, 3}}, {0, 20, 0}, flying);
    crowd.ground();
    for (int i = 0; i < 5; ++i) {
        crowd.add(BoxShape{}, {3, 0.5_r + static_cast<Real>(i), 0}, box_at_rest(9));
    }
    alone.run(1.0);
    crowd.run(1.0);
    EXPECT_TRUE(alone.world.islands().empty());
    EXPECT_EQ(users_and_sizes(crowd.world), (List{{9, 5}}));
    EXPECT_EQ(alone.hash({a}), crowd.hash({b}));
}

/// A heap in which contacts come and go.
struct Heap {
    TestWorld test{in_small_steps()};
    std::vector<BodyId> ids;

    Heap() {
        test.ground();
        for (int i = 0; i < 40; ++i) {
            const auto n = static_cast<Real>(i);
            const Vec3 at{std::sin(n), 1 + 0.7_r * n, std::cos(2 * n)};
            const BodyDef def{.kind = BodyKind::Dynamic,
                              .angular_velocity_radps = {0, n, 0},
                              .restitution = i % 3 == 0 ? 0.5_r : 0.0_r,
                              .contact_events = i % 2 == 0};
            if (i % 3 == 0)
                ids.push_back(test.add(SphereShape{}, at, def));
            else
                ids.push_back(test.add(BoxShape{.size_m = {1, 0.6_r, 0.8_r}}, at, def));
        }
    }
    std::uint64_t run(int steps) {
        for (int i = 0; i < steps; ++i) test.world.step();
        return test.hash(ids);
    }
};

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
    EXPECT_LE(world.quarantined().size(), 2U);
    int on_the_ground = 0;
    for (const BodyId id : heap.ids) {
        const Vec3d at = heap.test.at(id);
        EXPECT_TRUE(std::isfinite(at.x + at.y + at.z));
        if (at.y > 0 && glm::length(at) < 60) ++on_the_ground;
    }
    EXPECT_GE(on_the_ground, 20);
}

TEST(Islands, SameCallsGiveTheSameBits) {
    Heap once;
    Heap again;
    EXPECT_EQ(once.run(400), again.run(400));
}

TEST(Islands, QueriesAndDrawingLeaveNoTrace) {
    Heap plain;
    Heap watched;
    const ShapeId ball = watched.test.shape(SphereShape{.radius_m = 0.3_r});
    for (int i = 0; i < 300; ++i) {
        watched.run(1);
        watched.test.world.cast_ray({-9, 1, 0}, {9, 1, 0});
        watched.test.world.sweep(ball, {.position = {0, 9, 0}}, {0, 0, 0});
        watched.test.world.overlaps(ball, {.position = {0, 1, 0}}, 0.5_r);
        watched.test.world.all_contacts();
        LineList lines;
        watched.test.world.add_debug_lines(lines);
        EXPECT_FALSE(lines.vertices.empty());
    }
    EXPECT_EQ(plain.run(300), watched.test.hash(watched.ids));
}

TEST(Islands, WhatHappensFarAwayChangesNothing) {
    Heap plain;
    Heap crowded;
    for (int i = 0; i < 20; ++i) {
        crowded.test.add(BoxShape{}, {500 + 3 * static_cast<Real>(i), 5, 0});
    }
    EXPECT_EQ(plain.run(300), crowded.run(300));
}

}  // namespace
}  // namespace plumbline::physics
