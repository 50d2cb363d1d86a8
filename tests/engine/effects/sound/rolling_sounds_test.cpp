#include "engine/effects/effect_runtime.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

using scene::EntityDescription;
using test::Running;

constexpr ServedDomains kHeard{.frame = false, .sound = true};
constexpr Real kWeight_N = 9.81_r;  // of 1 kg

std::filesystem::path loop_file(const char* name) {
    return std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds" / name;
}

/// Wood that is heard when it scrapes, when it rolls, or both; friction 0.5, loudness 1.
scene::SurfaceTable wood(bool scrapes, bool rolls) {
    scene::SurfaceTable table = test::plain_surfaces();
    scene::Surface wood{.name = "wood", .friction = 0.5_r};
    wood.impact_sounds = {loop_file("impact_wood_0.ogg")};
    if (scrapes) wood.scrape_sound = loop_file("scrape_wood.ogg");
    if (rolls) wood.roll_sound = loop_file("roll_wood.ogg");
    table.surfaces.push_back(wood);
    return table;
}

/// On wooden ground, which is 40 m square.
scene::SceneDescription on_wood(EntityDescription thing, Real mass_kg) {
    thing.body->mass_kg = mass_kg;
    scene::SceneDescription scene = test::scene_of({test::ground(), thing});
    scene.materials["wood"] = {.name = "wood", .surface = "wood"};
    for (EntityDescription& entity : scene.entities) entity.material = "wood";
    return scene;
}

/// What is heard after a second at this speed, kept up from step to step.
std::vector<audio::LoopCue> loops_at(EntityDescription thing,
                                     Real mass_kg,
                                     const Vec3& velocity_mps,
                                     const Vec3& spin_radps,
                                     const scene::SurfaceTable& surfaces) {
    Running run(on_wood(std::move(thing), mass_kg), surfaces);
    EffectRuntime effects(*run, kHeard);
    for (int i = 0; i < 60; ++i) {
        run->physics.set_velocity(run.body("thing"), velocity_mps, spin_radps);
        run.step(1, effects);
    }
    return effects.sound(*run, {}).loops;
}

EntityDescription block() {
    return test::box("thing", {0, 0.25_r, 0}, {1, 0.5_r, 1});
}

EntityDescription wheel() {
    return test::ball("thing", {0, 0.25_r, 0}, 0.25_r);
}

// Friction takes mu m g v of power; the gain is the root of its share of 180 W.
TEST(RollingSounds, ScrapesByTheRootOfThePowerOfFriction) {
    const auto gain = [](Real mass_kg, Real speed_mps) {
        const auto loops = loops_at(block(), mass_kg, {speed_mps, 0, 0}, {}, wood(true, true));
        EXPECT_EQ(loops.size(), 1U) << "it slides and does not roll";
        return loops.empty() ? 0.0F : loops[0].gain;
    };
    const auto expected = [](Real mass_kg, Real speed_mps) {
        return std::sqrt(0.5_r * mass_kg * kWeight_N * speed_mps / 180);
    };
    for (const auto& [mass_kg, speed_mps] : {std::pair<Real, Real>{1, 2}, {4, 2}, {4, 0.5_r}})
        EXPECT_NEAR(gain(mass_kg, speed_mps),
                    expected(mass_kg, speed_mps),
                    0.05_r * expected(mass_kg, speed_mps));
}

// m g v against 900 W, where the ground touches; nothing scrapes.
TEST(RollingSounds, RollsByTheRootOfLoadTimesSpeed) {
    const auto loops = loops_at(wheel(), 4, {2, 0, 0}, {0, 0, -8}, wood(true, true));
    ASSERT_EQ(loops.size(), 1U);
    const Real expected = std::sqrt(4 * kWeight_N * 2 / 900);
    EXPECT_NEAR(loops[0].gain, expected, 0.05_r * expected);
    EXPECT_NEAR(loops[0].position_world.x, 2, 0.1);
    EXPECT_NEAR(loops[0].position_world.y, 0, 0.01);
    EXPECT_TRUE(loops_at(wheel(), 4, {2, 0, 0}, {0, 0, -8}, wood(true, false)).empty());
    EXPECT_TRUE(loops_at(block(), 4, {2, 0, 0}, {}, wood(false, true)).empty());
}

TEST(RollingSounds, AreHigherTheFasterItGoes) {
    const auto pitch = [](Real speed_mps) {
        const auto loops =
            loops_at(wheel(), 4, {speed_mps, 0, 0}, {0, 0, -4 * speed_mps}, wood(true, true));
        return loops.empty() ? 0.0F : loops[0].pitch;
    };
    EXPECT_NEAR(pitch(1), 0.9, 0.01);
    EXPECT_NEAR(pitch(3), 1.3, 0.02);
}

TEST(RollingSounds, EndWhereItRestsAndWhereItOnlyTips) {
    EntityDescription sliding = block();
    sliding.body->velocity_mps = {2, 0, 0};  // 4.9 m/s2 stop it in 0.4 s
    Running run(on_wood(sliding, 20), wood(true, true));
    EffectRuntime effects(*run, kHeard);
    run.step(15, effects);
    EXPECT_EQ(effects.sound(*run, {}).loops.size(), 1U);
    run.step(60, effects);
    EXPECT_TRUE(effects.sound(*run, {}).loops.empty());
    EXPECT_LT(glm::length(run.state("thing").velocity_mps), 0.01);
}

TEST(RollingSounds, AreOneLoopFromStepToStepAndNoEntitysOwn) {
    Running run(on_wood(wheel(), 4), wood(true, true));
    EffectRuntime effects(*run, kHeard);
    std::uint64_t key = 0;
    for (int i = 0; i < 120; ++i) {
        run->physics.set_velocity(run.body("thing"), {2, 0, 0}, {0, 0, -8});
        run.step(1, effects);
        const auto loops = effects.sound(*run, {}).loops;
        if (i < 30) continue;
        ASSERT_EQ(loops.size(), 1U) << i;
        if (key == 0) key = loops[0].key;
        ASSERT_EQ(loops[0].key, key) << i;
    }
    EXPECT_NE(key, scene::mark_of(run->find("thing")));
    EXPECT_NE(key, scene::mark_of(run->find("ground")));
}

TEST(RollingSounds, CostNothingWhereNoSurfaceHasThem) {
    Running run(on_wood(wheel(), 4), wood(false, false));
    EffectRuntime effects(*run, kHeard);
    run.step(60, effects);
    const LedgerLine line = line_of(effects, "rolling_sounds");
    EXPECT_TRUE(line.called_for_by.empty());
    EXPECT_EQ(line.calls, 0U);
    EXPECT_EQ(line.bytes_cpu, 0U);
    Running loud(on_wood(wheel(), 4), wood(true, true));
    EffectRuntime silent(*loud, {});
    loud.step(60, silent);
    EXPECT_EQ(line_of(silent, "rolling_sounds").calls, 0U) << "nobody listens";
}

}  // namespace
}  // namespace plumbline::effects
