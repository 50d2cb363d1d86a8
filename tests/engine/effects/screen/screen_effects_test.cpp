// What is added to the image's light after the scene: by whom, with which numbers, and that nobody
// pays who does not call.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

TEST(ScreenEffects, NobodyWhoDoesNotCallForThemPays) {
    Running run(test::scene_of({test::ground()}));
    EffectRuntime effects(*run, kImage);
    run.step(2, effects);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_FALSE(frame.occlusion);
    EXPECT_FALSE(frame.indirect);
    EXPECT_FALSE(frame.shafts);
    EXPECT_FALSE(frame.depth_of_field);
    EXPECT_FALSE(frame.motion_blur);
    EXPECT_FALSE(frame.refraction);
    for (const char* name : {"refraction",
                             "caustics",
                             "ambient_occlusion",
                             "indirect_light",
                             "sun_shafts",
                             "depth_of_field",
                             "motion_blur"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
}

TEST(ScreenEffects, OcclusionHasTheScenesNumbersAndItsFidelitysLooks) {
    SceneDescription scene = test::scene_of({});
    scene.ambient.occlusion = scene::OcclusionDescription{
        .radius_m = 0.5F, .strength = 0.75F, .location = in_file("garden.toml", 30)};
    scene.screen_fidelity.occlusion = scene::Fidelity::Draft;
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.occlusion);
    EXPECT_EQ(frame.occlusion->radius_m, 0.5F);
    EXPECT_EQ(frame.occlusion->strength, 0.75F);
    EXPECT_EQ(frame.occlusion->slices * frame.occlusion->steps, 2U);
    EXPECT_EQ(line_of(effects, "ambient_occlusion").called_for_by,
              Callers{"[ambient] occlusion (garden.toml:30)"});
    run->switches.turn("ambient_occlusion", false);
    EXPECT_FALSE(draw(run, effects).occlusion);
}

TEST(ScreenEffects, IndirectLightHasTheScenesBox) {
    SceneDescription scene = test::scene_of({});
    scene.ambient.indirect =
        scene::IndirectLightDescription{.min_m = {-3.0F, 0.0F, -2.0F},
                                        .max_m = {3.0F, 2.5F, 2.0F},
                                        .spacing_m = 0.25F,
                                        .gain = 2.0F,
                                        .location = in_file("garden.toml", 31)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.indirect);
    EXPECT_EQ(frame.indirect->max_world.y, 2.5F);
    EXPECT_EQ(frame.indirect->spacing_m, 0.25F);
    EXPECT_EQ(frame.indirect->gain, 2.0F);
    EXPECT_EQ(line_of(effects, "indirect_light").called_for_by,
              Callers{"[ambient] indirect (garden.toml:31)"});
    run->switches.turn("indirect_light", false);
    EXPECT_FALSE(draw(run, effects).indirect);
}

TEST(ScreenEffects, ShaftsAndLensHaveTheScenesNumbers) {
    SceneDescription scene = test::scene_of({});
    scene.sun = scene::SunDescription{};
    scene.sun->shafts = scene::ShaftsDescription{
        .density_per_m = 0.03F, .distance_m = 25.0F, .location = in_file("garden.toml", 4)};
    scene.camera.focus = scene::FocusDescription{
        .distance_m = 3.0F, .aperture_m = 0.01F, .location = in_file("garden.toml", 9)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.shafts);
    EXPECT_EQ(frame.shafts->density_per_m, 0.03F);
    EXPECT_EQ(frame.shafts->distance_m, 25.0F);
    ASSERT_TRUE(frame.depth_of_field);
    EXPECT_EQ(frame.depth_of_field->focus_m, 3.0F);
    EXPECT_EQ(frame.depth_of_field->aperture_m, 0.01F);
    EXPECT_EQ(line_of(effects, "sun_shafts").called_for_by,
              Callers{"[sun] shafts (garden.toml:4)"});
    EXPECT_EQ(line_of(effects, "depth_of_field").called_for_by,
              Callers{"[camera] focus (garden.toml:9)"});
}

TEST(ScreenEffects, WaterThatIsSeenIntoCallsForRefractionAndItsCaustics) {
    SceneDescription scene = test::scene_of({test::ground(), test::cube("pool", {0, 2, 0})});
    scene.entities[1].material = "water";
    const auto row_of = [&](float attenuation_m, float caustics) {
        scene.materials["water"] = {.alpha_mode = assets::AlphaMode::Blend,
                                    .ripple_slope = 0.1F,
                                    .attenuation_m = attenuation_m,
                                    .caustics = caustics};
        Running run(scene);
        EffectRuntime effects(*run, kImage);
        const render::RenderFrame frame = draw(run, effects);
        const bool seen = attenuation_m > 0.0F;
        EXPECT_EQ(frame.refraction.has_value(), seen);
        EXPECT_EQ(frame.refraction && frame.refraction->caustics, seen && caustics > 0.0F);
        const Callers pool = seen ? Callers{"entity pool (test.toml:10)"} : Callers{};
        EXPECT_EQ(line_of(effects, "refraction").called_for_by, pool);
        EXPECT_EQ(line_of(effects, "caustics").calls, seen && caustics > 0.0F ? 1U : 0U);
        run->switches.turn("refraction", false);
        EXPECT_FALSE(draw(run, effects).refraction);
    };
    row_of(0.0F, 3.0F);
    row_of(2.0F, 0.0F);
    row_of(2.0F, 3.0F);
}

}  // namespace
}  // namespace plumbline::effects
