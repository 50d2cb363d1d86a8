#include "engine/effects/effect_runtime.h"
#include "engine/scene/environment/wind_field.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

using scene::EntityDescription;
using scene::SceneDescription;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

constexpr ServedDomains kSilent{};
constexpr ServedDomains kWithSound{.frame = false, .sound = true};

std::filesystem::path sound_file(const char* name) {
    return std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds" / name;
}

scene::SurfaceTable loud_surfaces() {
    scene::SurfaceTable table = test::plain_surfaces();
    table.surfaces[0].step_sounds = {sound_file("step_grass_1.ogg")};
    table.surfaces.push_back(
        {.name = "wood",
         .density_kgpm3 = 1,
         .impact_sounds = {sound_file("impact_wood_0.ogg"), sound_file("impact_wood_1.ogg")}});
    return table;
}

/// Everything in it that has a body is of wood.
SceneDescription wooden(std::vector<EntityDescription> entities) {
    SceneDescription scene = scene_of(std::move(entities));
    scene.materials["wood"] = {.name = "wood", .surface = "wood"};
    for (EntityDescription& entity : scene.entities) entity.material = "wood";
    return scene;
}

EntityDescription wooden_cube(const std::string& name, const Vec3& position_m) {
    EntityDescription entity = cube(name, position_m);
    entity.material = "wood";
    return entity;
}

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

TEST(ImpactSounds, AMissingFileIsToldOnce) {
    scene::SurfaceTable surfaces = loud_surfaces();
    surfaces.surfaces[1].impact_sounds = {"no/such.ogg"};
    SceneDescription scene = wooden({ground()});
    for (int i = 0; i < 5; ++i) {
        scene.entities.push_back(wooden_cube("cube" + std::to_string(i), {Real(3 * i), 2, 0}));
    }
    Running run(scene, surfaces);
    EffectRuntime effects(*run, kWithSound);
    run.step(120, effects);
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty());
    EXPECT_EQ(run->warnings.size(), 1U);
}

TEST(Sound, NeverChangesWhatHappens) {
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

TEST(WindSound, FollowsTheGustsAtTheEarAndIsLessInTheLee) {
    scene::SceneDescription scene = scene_of({ground()});
    scene.wind = scene::WindDescription{.speed_mps = 4,
                                        .gusts = 0.6_r,
                                        .sound = sound_file("loop_wind.ogg"),
                                        .sound_gain = 0.2F,
                                        .location = in_file("garden.toml", 30)};
    scene::ViewPoint ear;
    ear.world_from_camera.position = {3, 1.7_r, 2};
    Running run(scene);
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "wind_sound").called_for_by,
              Callers{"[wind] sound (garden.toml:30)"});
    for (int i = 0; i < 5; ++i) {
        run.step(40, effects);
        const Real speed = glm::length(scene::wind_at(*scene.wind, {3, 1.7_r, 2}, run->time_s()));
        const audio::LoopCue wind = effects.sound(*run, ear).loops.at(0);
        EXPECT_NEAR(wind.gain, 0.2_r * speed * speed / 16, 1e-4F);
        EXPECT_LT(wind.position_world.x, 3.0F) << "from where it blows";
    }
    // A wall upwind, 2 m off.
    scene.entities.push_back(
        test::box("wall", {1, 5, 2}, {0.2_r, 30, 40}, physics::BodyKind::Static));
    Running sheltered(scene);
    EffectRuntime in_the_lee(*sheltered, kWithSound);
    const Real speed = glm::length(scene::wind_at(*scene.wind, {3, 1.7_r, 2}, 0));
    EXPECT_NEAR(in_the_lee.sound(*sheltered, ear).loops.at(0).gain,
                0.15_r * 0.2_r * speed * speed / 16,
                1e-4F);
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

class Walker final : public scene::Game {
public:
    scene::ViewPoint view(const scene::Simulation&, Real, float, float) const override {
        return {};
    }
    std::span<const scene::FootstepEvent> footsteps() const override { return steps; }
    std::vector<scene::FootstepEvent> steps;
};

TEST(Footsteps, SoundByTheGroundWalkedOn) {
    SceneDescription scene = scene_of({ground()});
    scene.player = scene::PlayerDescription{.location = in_file("garden.toml", 5)};
    Running run(scene, loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "footsteps").called_for_by, Callers{"[player] (garden.toml:5)"});
    Walker walker;
    walker.steps = {{.position_m = {1, 0, 2}, .surface = 0, .speed_mps = 3}};
    advance(*run, effects, walker, {});
    const SoundFrame sound = effects.sound(*run, {});
    ASSERT_EQ(sound.cues.size(), 1U);
    EXPECT_EQ(sound.cues[0].position_world, (Vec3f{1, 0, 2}));
    EXPECT_FLOAT_EQ(sound.cues[0].gain, 0.5F);
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty()) << "each step sounds once";
}

}  // namespace
}  // namespace plumbline::effects
