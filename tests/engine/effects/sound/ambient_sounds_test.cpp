// Loops where entities have them.
#include "engine/scene/environment/wind_field.h"
#include "tests/engine/effects/sound/wooden.h"

#include <cmath>

namespace plumbline::effects {
namespace {

TEST(AmbientSounds, LoopWhereTheirEntitiesAre) {
    EntityDescription fountain;
    fountain.name = "fountain";
    fountain.world_from_body.position = {3, 1, 2};
    fountain.location = in_file("garden.toml", 120);
    fountain.sound = scene::SoundDescription{
        .file = sound_file("loop_leaves.ogg"), .gain = 0.6F, .radius_m = 9.0F};
    Running run(scene_of({fountain}));
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "ambient_sounds").called_for_by,
              Callers{"entity fountain (garden.toml:120)"});
    for (int frame = 0; frame < 2; ++frame) {
        const SoundFrame sound = effects.sound(*run, {});
        ASSERT_EQ(sound.loops.size(), 1U);
        EXPECT_EQ(sound.loops[0].key, scene::mark_of(run->find("fountain")));
        EXPECT_EQ(sound.loops[0].gain, 0.6F);
        EXPECT_EQ(sound.loops[0].radius_m, 9.0F);
        EXPECT_EQ(sound.loops[0].position_world, (Vec3f{3, 1, 2}));
        EXPECT_TRUE(sound.cues.empty());
    }
    EXPECT_GT(line_of(effects, "ambient_sounds").bytes_cpu, 10'000U) << "its samples";
    run->registry.destroy(run->find("fountain"));
    effects.refresh(*run);
    EXPECT_TRUE(effects.sound(*run, {}).loops.empty());
    EXPECT_EQ(line_of(effects, "ambient_sounds").bytes_cpu, 0U);
}

TEST(AmbientSounds, MoveAsFastAsTheirBodies) {  // what the Doppler shift goes by
    EntityDescription bee = cube("bee", {0, 50, 0});
    bee.body->velocity_mps = {3, 0, 0};
    bee.sound = scene::SoundDescription{.file = sound_file("loop_leaves.ogg")};
    Running run(scene_of({bee}));
    EffectRuntime effects(*run, kWithSound);
    run.step(60, effects);
    const audio::LoopCue buzz = effects.sound(*run, {}).loops.at(0);
    EXPECT_NEAR(buzz.velocity_mps.x, 3.0F, 1e-3F);
    EXPECT_NEAR(buzz.velocity_mps.y, -9.81F, 0.1F);
    EXPECT_EQ(buzz.made_by[0], scene::mark_of(run->find("bee"))) << "it is not in its own way";
}

TEST(AmbientSounds, RustleAsTheSquareOfTheWind) {
    EntityDescription tree;
    tree.name = "tree";
    tree.world_from_body.position = {3, 1, 2};
    tree.sound = scene::SoundDescription{
        .file = sound_file("loop_leaves.ogg"), .gain = 0.5F, .by_wind = true};
    scene::SceneDescription scene = scene_of({tree});
    {
        Running calm(scene);
        EffectRuntime effects(*calm, kWithSound);
        EXPECT_EQ(effects.sound(*calm, {}).loops.at(0).gain, 0.0F);
    }
    scene.wind = scene::WindDescription{.speed_mps = 4, .gusts = 0.6_r};
    Running run(scene);
    EffectRuntime effects(*run, kWithSound);
    for (int i = 0; i < 5; ++i) {
        run.step(40, effects);
        const Real speed = glm::length(scene::wind_at(*scene.wind, {3, 1, 2}, run->time_s()));
        const Real expected = 0.5_r * speed * speed / 16;
        EXPECT_NEAR(effects.sound(*run, {}).loops.at(0).gain, expected, 1e-5F);
    }
}

// Power is flow times what each kilogram lands with; loudness goes with its root, 1 at 5 W.
TEST(AmbientSounds, RushAsTheRootOfTheWatersPower) {
    EntityDescription basin;
    basin.name = "basin";
    basin.sound = scene::SoundDescription{
        .file = sound_file("loop_fountain.ogg"), .gain = 0.5F, .radius_m = 10, .by_flow = true};
    const auto gain_of = [&](std::vector<scene::FountainDescription> fountains) {
        scene::SceneDescription scene = scene_of({basin});
        scene.fountains = std::move(fountains);
        Running run(scene);
        EffectRuntime effects(*run, kWithSound);
        return effects.sound(*run, {}).loops.at(0).gain;
    };
    scene::FountainDescription jet{.position_m = {0, 2, 0}, .speed_mps = 4, .flow_lps = 0.25_r};
    jet.pools = {{.center_m = {0, 1.5_r, 0}, .radius_m = 1},
                 {.center_m = {0, 0.2_r, 0}, .radius_m = 3}};
    const float power_W = 0.25F * (8 + 9.81F * 0.5F);
    EXPECT_NEAR(gain_of({jet}), 0.5F * std::sqrt(power_W / 5), 1e-3F);
    scene::FountainDescription stronger = jet;
    stronger.flow_lps *= 2;
    EXPECT_NEAR(gain_of({stronger}) / gain_of({jet}), std::sqrt(2.0F), 1e-3F);
    scene::FountainDescription dry = jet;
    dry.flow_lps = 0;
    EXPECT_EQ(gain_of({dry}), 0.0F);
    EXPECT_EQ(gain_of({}), 0.0F);
    scene::FountainDescription far = jet;
    far.position_m.x = 50;
    EXPECT_EQ(gain_of({far}), 0.0F);
}

TEST(AmbientSounds, ReadNoFileWhereNobodyListens) {
    EntityDescription fountain;
    fountain.name = "fountain";
    fountain.sound = scene::SoundDescription{.file = "no/such.ogg"};
    Running run(scene_of({fountain}));
    EffectRuntime effects(*run, kSilent);
    run.step(1, effects);
    EXPECT_TRUE(run->warnings.empty());
}

TEST(AmbientSounds, ThatDoNotLoopArePlayedOnce) {
    EntityDescription bell;
    bell.name = "bell";
    bell.sound = scene::SoundDescription{
        .file = sound_file("impact_wood_0.ogg"), .loop = false, .gain = 0.75F};
    Running run(scene_of({bell}));
    EffectRuntime effects(*run, kWithSound);
    const SoundFrame first = effects.sound(*run, {});
    ASSERT_EQ(first.cues.size(), 1U);
    EXPECT_EQ(first.cues[0].gain, 0.75F);
    EXPECT_TRUE(first.loops.empty());
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty());
}

}  // namespace
}  // namespace plumbline::effects
