// What goes off, breaks or parts is heard there, once, as loud as it is strong.
#include "tests/engine/effects/drawn.h"

#include <gtest/gtest.h>

namespace plumbline::effects {
namespace {

using scene::Burst;

constexpr ServedDomains kHearingBursts{.frame = false, .sound = true};

scene::SurfaceTable bursting_surfaces() {
    const auto sounds = std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds";
    scene::SurfaceTable table = test::plain_surfaces();
    table.surfaces.push_back({.name = "explosion", .impact_sounds = {sounds / "explosion_0.ogg"}});
    table.surfaces.push_back({.name = "rope_end", .impact_sounds = {sounds / "snap_0.ogg"}});
    table.surfaces.push_back(
        {.name = "ceramic", .impact_sounds = {sounds / "impact_ceramic_0.ogg"}});
    return table;
}

scene::SceneDescription charged(double at_s, Real impulse_Ns) {
    scene::SceneDescription scene = test::scene_of({test::box("crate", {0, 5, 0}, {1, 1, 1})});
    scene::ExplosionDescription charge;
    charge.name = "charge";
    charge.at_s = at_s;
    charge.position_m = {3, 0, 0};
    charge.impulse_Ns = impulse_Ns;
    scene.forces.explosions.push_back(charge);
    return scene;
}

std::vector<audio::SoundCue> heard(const scene::SceneDescription& scene, int steps) {
    test::Running run(scene, bursting_surfaces());
    EffectRuntime effects(*run, kHearingBursts);
    run.step(steps, effects);
    return effects.sound(*run, {}).cues;
}

TEST(BurstSounds, AnExplosionIsHeardOnceWhereItIs) {
    const std::vector<audio::SoundCue> cues = heard(charged(0.1, 400), 60);
    ASSERT_EQ(cues.size(), 1U);
    EXPECT_EQ(cues[0].caption, "explosion");
    EXPECT_EQ(cues[0].position_world, (Vec3f{3, 0, 0}));
    EXPECT_EQ(cues[0].gain, 1.0F);
    EXPECT_TRUE(heard(charged(5, 400), 60).empty()) << "not before its time";
}

TEST(BurstSounds, AWeakerOneIsQuieterByTheRootOfItsImpulse) {
    EXPECT_NEAR(heard(charged(0, 100), 5).at(0).gain, 0.5, 1e-6);
    EXPECT_LT(heard(charged(0, 100), 5).at(0).radius_m, heard(charged(0, 400), 5).at(0).radius_m);
}

TEST(BurstSounds, WhatBreaksSoundsLikeItsSurfaceAndARopeLikeItsEnd) {
    test::Running run(charged(100, 1), bursting_surfaces());
    EffectRuntime effects(*run, kHearingBursts);
    run->bursts.push_back(
        {.kind = Burst::Kind::Break, .strength = 2.5, .surface = run->surfaces().find("ceramic")});
    run->bursts.push_back({.kind = Burst::Kind::Snap, .point_world = {1, 2, 3}});
    run.step(1, effects);
    const std::vector<audio::SoundCue> cues = effects.sound(*run, {}).cues;
    ASSERT_EQ(cues.size(), 2U);
    EXPECT_EQ(cues[0].caption, "ceramic breaks");
    EXPECT_NEAR(cues[0].gain, 0.5, 1e-6);
    EXPECT_EQ(cues[1].caption, "rope parts");
    run.step(5, effects);
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty());
}

TEST(BurstSounds, AWholeSceneThatBreaksAtOnceIsNotHeardPieceByPiece) {
    test::Running run(charged(100, 1), bursting_surfaces());
    EffectRuntime effects(*run, kHearingBursts);
    for (int i = 0; i < 500; ++i) run->bursts.push_back({.kind = Burst::Kind::Snap});
    run.step(1, effects);
    EXPECT_EQ(effects.sound(*run, {}).cues.size(), 16U);
}

}  // namespace
}  // namespace plumbline::effects
