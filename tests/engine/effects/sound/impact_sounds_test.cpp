// What strikes something is heard.
#include "tests/engine/effects/sound/wooden.h"

#include <cmath>

namespace plumbline::effects {
namespace {

std::vector<audio::SoundCue> cues_of_a_drop(Real height_m) {
    Running run(wooden({ground(), cube("cube", {0, 0.5_r + height_m, 0})}), loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    run.step(120, effects);
    return effects.sound(*run, {}).cues;
}

TEST(ImpactSounds, SoundOnceWhereSomethingLands) {
    const std::vector<audio::SoundCue> cues = cues_of_a_drop(1);
    ASSERT_FALSE(cues.empty());
    EXPECT_NE(cues[0].sound, assets::SoundId{});
    EXPECT_NEAR(cues[0].position_world.y, 0.0F, 0.08F) << "4.4 m/s are 7 cm a step";
    EXPECT_GE(cues[0].pitch, 0.92F);
    EXPECT_LE(cues[0].pitch, 1.08F);
    EXPECT_LE(cues.size(), 3U) << "a resting cube is silent";
}

TEST(ImpactSounds, GainGrowsWithImpulse) {
    // Impulse m*v goes with the root of the height: four times the height, 2^0.6 the gain.
    const float low = cues_of_a_drop(0.25_r).at(0).gain;
    const float high = cues_of_a_drop(1).at(0).gain;
    EXPECT_NEAR(high / low, std::pow(2.0F, 0.6F), 0.15F);
}

TEST(ImpactSounds, CallForContactEventsWhileTheyLive) {
    Running run(wooden({ground(), cube("cube", {0, 2, 0})}), loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "contact_events").called_for_by, Callers{"effect impact_sounds"});
    EXPECT_TRUE(run->features().contact_events);
    run->registry.destroy(run->find("cube"));
    run.step(1, effects);
    EXPECT_FALSE(line_of(effects, "impact_sounds").exists);
    EXPECT_FALSE(line_of(effects, "contact_events").exists);
    EXPECT_FALSE(run->features().contact_events);

    // The first thing dropped in play brings them back.
    run->spawn(wooden_cube("crate", {0, 2, 0}));
    run.step(1, effects);
    EXPECT_EQ(line_of(effects, "impact_sounds").constructions, 2U);
    EXPECT_EQ(line_of(effects, "contact_events").constructions, 2U);
}

TEST(ImpactSounds, AreNotMadeForMaterialsThatNameNoSurface) {
    scene::SurfaceTable surfaces = loud_surfaces();
    surfaces.surfaces[0].impact_sounds = surfaces.surfaces[1].impact_sounds;
    Running run(scene_of({ground(), cube("cube", {0, 2, 0})}), surfaces);
    EffectRuntime effects(*run, kWithSound);
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "impact_sounds").constructions, 0U);
    EXPECT_EQ(line_of(effects, "contact_events").constructions, 0U);
}

TEST(ImpactSounds, NeverChangesWhatHappens) {
    const auto hash_with = [](const ServedDomains& served) {
        SceneDescription scene = wooden({ground()});
        scene.arrays.push_back({.name = "pile",
                                .prefab = wooden_cube("crate", {}),
                                .origin_m = {0, 1, 0},
                                .count = {2, 5, 2},
                                .spacing_m = {0.9_r, 1.3_r, 1.05_r}});
        EntityDescription stick = test::box("stick", {0.3_r, 9, 0.2_r}, {2, 0.1_r, 0.2_r});
        scene.entities.push_back(stick);
        Running run(scene, loud_surfaces());
        EffectRuntime effects(*run, served);
        std::size_t cues = 0;
        for (int i = 0; i < 180; ++i) {
            run.step(1, effects);
            if (i % 3 == 0) cues += effects.sound(*run, {}).cues.size();
        }
        EXPECT_EQ(cues > 0, served.sound);
        return run->state_hash();
    };
    EXPECT_EQ(hash_with(kSilent), hash_with(kWithSound));
}

// A crate of wood that falls on felt: as loud as both together are lively.
TEST(ImpactSounds, ASoftGroundDullsThem) {
    const auto gain_on = [](float loudness) {
        scene::SurfaceTable surfaces = loud_surfaces();
        surfaces.surfaces.push_back({.name = "felt", .loudness = loudness});
        SceneDescription scene = wooden({ground(), cube("cube", {0, 1.5_r, 0})});
        scene.materials["felt"] = {.name = "felt", .surface = "felt"};
        scene.entities[0].material = "felt";
        Running run(scene, surfaces);
        EffectRuntime effects(*run, kWithSound);
        run.step(60, effects);
        const auto cues = effects.sound(*run, {}).cues;
        EXPECT_EQ(cues.empty(), loudness == 0);
        if (cues.empty()) return 0.0F;
        EXPECT_EQ(cues[0].caption, "wood hits felt");
        EXPECT_EQ(cues[0].made_by[0] == 0, cues[0].made_by[1] != 0) << "the ground makes none";
        return cues[0].gain;
    };
    EXPECT_NEAR(gain_on(0.25F) / gain_on(1.0F), 0.5F, 1e-3F);
    EXPECT_EQ(gain_on(0), 0.0F);
}

TEST(ImpactSounds, OfOnePairAreATenthOfASecondApart) {
    Running run(wooden({ground(), cube("cube", {0, 0.6_r, 0})}), loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    std::size_t cues = 0;
    for (int i = 0; i < 60; ++i) {
        // Lifted and struck down in every other step.
        run->physics.set_pose(run.body("cube"), {.position = {0, 0.53_r, 0}});
        run->physics.set_velocity(run.body("cube"), {0, -6, 0}, {0, 0, 0});
        run.step(1, effects);
        cues += effects.sound(*run, {}).cues.size();
    }
    EXPECT_GE(cues, 8U);
    EXPECT_LE(cues, 10U) << "in a second";
}

}  // namespace
}  // namespace plumbline::effects
