// Fog, of the scene or switched on.
#include "engine/scene/environment/live_light.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;
using test::scene_of;

TEST(Fog, CanBeAddedAndTakenAway) {
    Running clear(scene_of({}));
    EffectRuntime effects(*clear, kImage);
    clear->switches.turn("fog", true);
    ASSERT_TRUE(draw(clear, effects).fog);
    EXPECT_EQ(line_of(effects, "fog").called_for_by, Callers{"switch fog"});

    SceneDescription misty = scene_of({});
    misty.fog = scene::FogDescription{};
    Running run(misty);
    EffectRuntime others(*run, kImage);
    EXPECT_TRUE(draw(run, others).fog);
    run->switches.turn("fog", false);
    EXPECT_FALSE(draw(run, others).fog);
}

TEST(Fog, IsTheScenesUntilAnotherColourIsChosen) {
    SceneDescription misty = scene_of({});
    misty.fog = scene::FogDescription{.color = {0.1F, 0.2F, 0.3F}, .density_per_m = 0.02F};
    Running run(misty);
    EffectRuntime effects(*run, kImage);
    run->switches.light_scale = 0.5F;
    run->switches.fog_density_scale = 3.0F;
    const render::Fog own = *draw(run, effects).fog;
    EXPECT_TRUE(test::near(own.color, Vec3f{0.05F, 0.1F, 0.15F}, 1e-6)) << "dusk dims it too";
    EXPECT_FLOAT_EQ(own.density_per_m, 0.06F);
    for (const std::size_t chosen : {1U, 2U}) {
        run->switches.fog_color = chosen;
        const Vec3f color = draw(run, effects).fog->color;
        EXPECT_TRUE(test::near(color, 0.5F * scene::kFogColors[chosen].color, 1e-6)) << chosen;
    }
    misty.fog->on = false;
    Running clear(misty);
    EffectRuntime others(*clear, kImage);
    EXPECT_FALSE(draw(clear, others).fog) << "there, and off";
}

}  // namespace
}  // namespace plumbline::effects
