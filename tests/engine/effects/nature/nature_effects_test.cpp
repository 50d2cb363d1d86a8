// Wind, grass and flocks: what they add to a frame, where, and that nobody pays who does not call.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

TEST(NatureEffects, NobodyWhoDoesNotCallForThemPays) {
    Running run(test::scene_of({test::ground()}));
    EffectRuntime effects(*run, kImage);
    run.step(2, effects);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_FALSE(frame.wind);
    EXPECT_EQ(frame.items.size(), 1U) << "the ground";
    for (const char* name : {"wind", "grass", "flock"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
}

TEST(NatureEffects, TheWindOfTheSceneIsTheWindOfTheFrame) {
    SceneDescription scene = test::scene_of({});
    scene.wind = scene::WindDescription{.direction = {0, 0, -1},
                                        .speed_mps = 6,
                                        .gusts = 0.5_r,
                                        .location = in_file("garden.toml", 30)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.wind);
    EXPECT_EQ(frame.wind->mean_mps, (Vec2f{0.0F, -6.0F}));
    EXPECT_NEAR(frame.wind->gusts[0].speed_mps + frame.wind->gusts[1].speed_mps, 3.0F, 1e-5F);
    EXPECT_EQ(line_of(effects, "wind").called_for_by, Callers{"[wind] (garden.toml:30)"});
    run->switches.turn("wind", false);
    EXPECT_FALSE(draw(run, effects).wind);
}

}  // namespace
}  // namespace plumbline::effects
