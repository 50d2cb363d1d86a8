// Which islands fall asleep.
#include "engine/physics/totals.h"
#include "tests/engine/physics/world/asleep.h"

namespace plumbline::physics {
namespace {

TEST(Sleep, AnIslandFallsAsleepAllAtOnce) {
    TestWorld test(in_small_steps());
    test.ground();
    for (int i = 0; i < 5; ++i) test.add(BoxShape{}, {0, 0.5_r + static_cast<Real>(i), 0});
    int steps = 0;
    for (; awake_count(test.world) > 0 && steps < 300; ++steps) {
        EXPECT_EQ(awake_count(test.world), 5U);
        test.world.step();
    }
    EXPECT_GE(steps, 30) << "half a second at least";
    EXPECT_LT(steps, 90);
}

TEST(Sleep, OfThingsOfAnySize) {
    for (const Real size_m : {0.01_r, 0.1_r, 10.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground();
        const BodyId box = test.add(BoxShape{.size_m = {size_m, size_m, size_m}},
                                    {0, 0.55_r * size_m, 0},
                                    {.kind = BodyKind::Dynamic, .mass_kg = 2});
        test.run(3.0);
        EXPECT_FALSE(test.world.state(box).awake);
    }
}

TEST(Sleep, WhoMayNotKeepsItsIslandAwake) {
    TestWorld test(in_small_steps());
    test.ground();
    const BodyId insomniac =
        test.add(BoxShape{}, {0, 0.5_r, 0}, {.kind = BodyKind::Dynamic, .can_sleep = false});
    const BodyId on_it = test.add(BoxShape{}, {0, 1.5_r, 0});
    const BodyId elsewhere = test.add(BoxShape{}, {5, 0.5_r, 0});
    test.run(3.0);
    EXPECT_TRUE(test.world.state(insomniac).awake);
    EXPECT_TRUE(test.world.state(on_it).awake);
    EXPECT_FALSE(test.world.state(elsewhere).awake);
}

TEST(SlowMotion, NothingSleepsInTheAir) {
    WorldDef def = in_small_steps();
    def.gravity_mps2 = {0, 0, 0};
    TestWorld test(def);
    const BodyId still = test.add(BoxShape{}, {0, 5, 0});
    const BodyId slow = test.add(
        SphereShape{}, {5, 5, 0}, {.kind = BodyKind::Dynamic, .velocity_mps = {0.001_r, 0, 0}});
    test.run(10.0);
    EXPECT_TRUE(test.world.state(still).awake);
    EXPECT_NEAR(test.at(slow).x, 5.01, 1e-6 + 10 * kRounding);
}

TEST(SlowMotion, WithoutGravityOnlyWhatRestsAgainstSomethingSleeps) {
    WorldDef def = in_small_steps();
    def.gravity_mps2 = {0, 0, 0};
    TestWorld test(def);
    test.ground();
    const BodyId still = test.add(BoxShape{}, {0, 0.5_r, 0});
    const BodyId sliding =
        test.add(BoxShape{},
                 {5, 0.5_r, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {0.002_r, 0, 0}, .friction = 0});
    const BodyId pair_a = test.add(BoxShape{}, {0, 5, 0});
    const BodyId pair_b = test.add(BoxShape{}, {0, 6, 0});
    test.run(5.0);
    EXPECT_FALSE(test.world.state(still).awake);
    EXPECT_NEAR(test.at(sliding).x, 5.01, 1e-4);
    EXPECT_TRUE(test.world.state(pair_a).awake);
    EXPECT_TRUE(test.world.state(pair_b).awake);
}

}  // namespace
}  // namespace plumbline::physics
