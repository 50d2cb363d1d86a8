// Islands solved in as many sub-steps as they ask for.
#include "tests/engine/physics/test_world.h"

#include <string>
#include <utility>
#include <vector>

namespace plumbline::physics {
namespace {

std::vector<std::pair<int, std::string>> substeps_of(const PhysicsWorld& world) {
    std::vector<std::pair<int, std::string>> list;
    for (const IslandReport& island : world.report().islands)
        list.emplace_back(island.substeps, island.reason);
    return list;
}

using Substeps = std::vector<std::pair<int, std::string>>;

TEST(IslandSolver, AnIslandKeepsItsSubstepsForHalfASecondAfterItsLoad) {
    TestWorld test(WorldDef{.substeps = 2, .substeps_max = 16});
    test.ground();
    const BodyId under = test.add(
        BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 1, .can_sleep = false});
    const BodyId load = test.add(
        BoxShape{}, {0, 1.5_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 200, .can_sleep = false});
    test.run(1);
    ASSERT_EQ(test.world.report().islands.size(), 1U);
    const int loaded = test.world.report().islands[0].substeps;
    EXPECT_GT(loaded, 4);
    EXPECT_EQ(test.world.report().islands[0].bodies, 2U);
    test.world.destroy_body(load);
    test.world.step();
    EXPECT_EQ(substeps_of(test.world), (Substeps{{loaded, "held"}}));
    test.run(1);
    EXPECT_EQ(substeps_of(test.world), (Substeps{{2, "least"}}));
    EXPECT_TRUE(test.world.state(under).awake);
}

// Only what contacts had carried for ten steps counted: for so long a body of 0.1 kg was pressed on with the sub-steps of its
// weight.
TEST(IslandSolver, WhatCallersPressWithCountsFromTheFirstStep) {
    TestWorld test(WorldDef{.substeps = 2, .substeps_max = 16});
    test.ground();
    const BodyId block = test.add(
        BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 1, .can_sleep = false});
    test.run(1);
    ASSERT_EQ(test.world.report().islands[0].substeps, 2);
    test.world.apply_force(block, {0, 9, 0});  // carries most of it
    test.world.step();
    EXPECT_EQ(test.world.report().islands[0].substeps, 2);
    test.world.apply_force(block, {0, -2000, 0});
    test.world.step();
    EXPECT_EQ(test.world.report().islands[0].reason, "load");
    EXPECT_GE(test.world.report().islands[0].substeps, 8);
}

TEST(IslandSolver, WithoutAChoiceItIsFixed) {
    TestWorld test(in_small_steps(3));
    test.ground();
    test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(0.1);
    EXPECT_EQ(substeps_of(test.world), (Substeps{{3, "fixed"}}));
}

// A crate on a belt that goes at 1 m/s: friction 0.5 brings it up to that in 0.2 s, then it rides.
TEST(IslandSolver, KinematicBodiesMoveWhatTouchesThem) {
    TestWorld test(in_small_steps());
    test.add(BoxShape{.size_m = {40, 1, 4}},
             {0, -0.5_r, 0},
             {.kind = BodyKind::Kinematic, .velocity_mps = {1, 0, 0}, .friction = 0.5_r});
    const BodyId crate =
        test.add(BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .friction = 0.5_r});
    test.run(0.1);
    EXPECT_NEAR(test.velocity(crate).x, 0.5 * kG * 0.1, 0.01);
    test.run(0.4);
    EXPECT_NEAR(test.velocity(crate).x, 1, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
