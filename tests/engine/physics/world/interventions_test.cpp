// What the solver did to motion beside solving for it is counted.
#include "tests/engine/physics/test_world.h"

namespace plumbline::physics {
namespace {

/// Of all steps of so many seconds.
Interventions over(TestWorld& test, double seconds) {
    Interventions sum;
    for (int i = 0; i < static_cast<int>(seconds / test.world.def().step_s + 0.5); ++i) {
        test.world.step();
        sum.add(test.world.report().cost.interventions);
    }
    return sum;
}

TEST(InterventionCount, IsZeroWhereNothingWasDone) {
    TestWorld test;
    test.ground();
    for (int i = 0; i < 3; ++i)
        test.add(BoxShape{.size_m = {1, 1, 1}}, {0, 0.5_r + static_cast<Real>(i), 0});
    const Interventions sum = over(test, 1);
    EXPECT_EQ(sum.braked_J, 0);
    EXPECT_EQ(sum.braked_islands + sum.clamped_bodies + sum.limited_bodies +
                  sum.unresolved_islands + sum.restored_islands + sum.impacts,
              0U);
}

TEST(InterventionCount, HasTheBounceOfABall) {
    TestWorld test;
    test.ground(0.5_r, 1);
    test.add(SphereShape{.radius_m = 0.5_r},
             {0, 1.5_r, 0},
             {.kind = BodyKind::Dynamic, .restitution = 1});
    // Falls 1 m in 0.45 s, and is at its height again after twice that.
    EXPECT_EQ(over(test, 0.8).impacts, 1U);
}

TEST(InterventionCount, HasBodiesAtTheSpeedLimit) {
    for (const Solver solver : {Solver::SmallStep, Solver::BulletSi}) {
        TestWorld test({.gravity_mps2 = {0, 0, 0}, .solver = solver});
        test.add(SphereShape{.radius_m = 0.5_r},
                 {0, 0, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {2e4_r, 0, 0}});
        test.add(SphereShape{.radius_m = 0.5_r},
                 {0, 9, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {9e3_r, 0, 0}});
        test.world.step();
        EXPECT_EQ(test.world.report().cost.interventions.limited_bodies, 1U) << solver_name(solver);
        test.world.step();
        EXPECT_EQ(test.world.report().cost.interventions.limited_bodies, 0U)
            << "it is slow enough now";
    }
}

TEST(InterventionCount, HasWhatOverlapPushedTooFast) {
    TestWorld test({.gravity_mps2 = {0, 0, 0}});
    for (int i = 0; i < 30; ++i) test.add(SphereShape{.radius_m = 0.25_r}, {0, 0, 0});
    const Interventions sum = over(test, 1);
    EXPECT_GT(sum.clamped_bodies, 0U);
    EXPECT_GT(sum.braked_islands, 0U);
    EXPECT_GT(sum.braked_J, 0);
}

}  // namespace
}  // namespace plumbline::physics
