// What a step of small_step does for bodies that touch nothing, and that no history matters.
#include "engine/physics/debug_lines.h"
#include "engine/physics/query.h"
#include "engine/physics/totals.h"
#include "tests/engine/physics/dynamics/island_heap.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(SmallStepWorld, WhatFliesBelongsToNoneAndFliesAsIfAlone) {
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
    EXPECT_TRUE(alone.world.report().islands.empty());
    EXPECT_EQ(users_and_sizes(crowd.world), (IslandSizes{{9, 5}}));
    EXPECT_EQ(alone.hash({a}), crowd.hash({b}));
}

TEST(SmallStepWorld, SameCallsGiveTheSameBits) {
    Heap once;
    Heap again;
    EXPECT_EQ(once.run(400), again.run(400));
}

TEST(SmallStepWorld, QueriesAndDrawingLeaveNoTrace) {
    Heap plain;
    Heap watched;
    const ShapeId ball = watched.test.shape(SphereShape{.radius_m = 0.3_r});
    for (int i = 0; i < 300; ++i) {
        watched.run(1);
        cast_ray(watched.test.world, {-9, 1, 0}, {9, 1, 0});
        sweep(watched.test.world, ball, {.position = {0, 9, 0}}, {0, 0, 0});
        overlaps(watched.test.world, ball, {.position = {0, 1, 0}}, 0.5_r);
        all_contacts(watched.test.world);
        LineList lines;
        add_debug_lines(watched.test.world, lines);
        EXPECT_FALSE(lines.vertices.empty());
    }
    EXPECT_EQ(plain.run(300), watched.test.hash(watched.ids));
}

TEST(SmallStepWorld, WhatHappensFarAwayChangesNothing) {
    Heap plain;
    Heap crowded;
    for (int i = 0; i < 20; ++i) {
        crowded.test.add(BoxShape{}, {500 + 3 * static_cast<Real>(i), 5, 0});
    }
    EXPECT_EQ(plain.run(300), crowded.run(300));
}

TEST(TallTower, OfSixtyCubesStands) {
    constexpr int kCubes = 60;
    TestWorld test(
        {.substeps = 2, .substeps_max = 16, .iterations = 1, .solver = Solver::SmallStep});
    test.ground();
    BodyId top{};
    for (int i = 0; i < kCubes; ++i) {
        top = test.add(BoxShape{{1, 1, 1}},
                       {0, static_cast<Real>(i) + 0.5_r, 0},
                       {.kind = BodyKind::Dynamic, .can_sleep = false});
    }
    test.run(20);
    EXPECT_NEAR(test.at(top).x, 0, 1e-3);
    EXPECT_NEAR(test.at(top).y, kCubes - 0.5, 0.05);
    EXPECT_NEAR(test.at(top).z, 0, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
