// What floats sleeps, wakes and is let go.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

TEST(Buoyancy, FloatsFallAsleepAndCostNothing) {
    test::Running run(pond_with({kilogram("ball", {0, 0.1_r, 0})}));
    EffectRuntime effects(*run, {});
    run.step(1200, effects);
    EXPECT_FALSE(run.state("ball").awake);
    const std::uint64_t calls = line_of(effects, "buoyancy").calls;
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "buoyancy").calls, calls);
    run->physics.apply_impulse(run.body("ball"), {0, 1, 0});
    run.step(1, effects);
    EXPECT_GT(line_of(effects, "buoyancy").calls, calls);
}

TEST(Buoyancy, CalledOffInMidGameLetsGo) {
    test::Running run(pond_with({kilogram("ball", {0, 0.1_r, 0})}));
    EffectRuntime effects(*run, {});
    run.step(1200, effects);
    ASSERT_FALSE(run.state("ball").awake);
    run->switches.turn("buoyancy", false);
    run.step(60, effects);
    EXPECT_LT(run.state("ball").velocity_mps.y, -9) << "it falls";
    EXPECT_FALSE(line_of(effects, "buoyancy").exists);
    EXPECT_TRUE(run->force_fields.all().empty());
    run->switches.turn("buoyancy", true);
    run.step(1, effects);
    EXPECT_EQ(line_of(effects, "buoyancy").constructions, 2U);
}

TEST(Buoyancy, ActsInWaterOnlyAndDownToItsGround) {
    SceneDescription scene =
        pond_with({kilogram("beside", {20, -1, 0}), kilogram("below", {0, -12, 0})});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_NEAR(static_cast<double>(run.state("beside").velocity_mps.y), -9.81 / 2, 1e-3);
    EXPECT_NEAR(static_cast<double>(run.state("below").velocity_mps.y), -9.81 / 2, 1e-3);
    EXPECT_EQ(line_of(effects, "buoyancy").calls, 0U);
}

}  // namespace
}  // namespace plumbline::effects
