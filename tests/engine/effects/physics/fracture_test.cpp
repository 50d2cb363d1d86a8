// Bodies that break: when, into what, and what is kept of them.
#include "engine/core/io/archive.h"
#include "engine/effects/saved_game.h"
#include "engine/scene/build/fragments.h"
#include "engine/scene/state_report.h"
#include "tests/engine/effects/fields/in_fields.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

constexpr double kStrength_Pa = 1e6;

/// 2 m long, 0.1 m thick, 20 kg.
scene::EntityDescription breakable_rod(double strength_Pa = kStrength_Pa) {
    scene::EntityDescription rod = test::box("rod", {0, 5, 0}, {2, 0.1_r, 0.1_r});
    rod.body->fracture =
        scene::FractureDescription{.pieces = 20, .strength_Pa = static_cast<Real>(strength_Pa)};
    return rod;
}

SceneDescription spinning_at(double spin_radps) {
    scene::EntityDescription rod = breakable_rod();
    rod.body->angular_velocity_radps = {0, static_cast<Real>(spin_radps), 0};
    rod.body->velocity_mps = {1, 2, 3};
    SceneDescription scene = test::scene_of({rod});
    scene.gravity_mps2 = {0, 0, 0};
    return scene;
}

/// That pulls it apart at its middle.
double breaking_spin_radps() {
    return std::sqrt(8 * kStrength_Pa / (1000 * 2 * 2));
}

nlohmann::json state_of(const scene::Simulation& simulation) {
    return nlohmann::json::parse(scene::state_json(simulation, {}, "{}", 0, true));
}

Vec3d vector_of(const nlohmann::json& list) {
    return {list[0], list[1], list[2]};
}

TEST(Fracture, ARodThatSpinsTooFastFallsInTwoAndKeepsItsMotion) {
    test::Running slow(spinning_at(0.997 * breaking_spin_radps()));
    EffectRuntime slow_effects(*slow, {});
    slow.step(30, slow_effects);
    EXPECT_TRUE(slow->find("rod"));
    EXPECT_TRUE(state_of(*slow)["breaks"].empty());

    test::Running fast(spinning_at(1.003 * breaking_spin_radps()));
    EffectRuntime effects(*fast, {});
    const nlohmann::json before = state_of(*fast);
    fast.step(2, effects);
    const nlohmann::json after = state_of(*fast);
    EXPECT_FALSE(fast->find("rod"));
    ASSERT_EQ(after["breaks"].size(), 1U);
    EXPECT_EQ(after["breaks"][0]["name"], "rod");
    EXPECT_EQ(after["breaks"][0]["pieces"], 2);
    EXPECT_EQ(after["bodies"][0]["name"], "rod/0");
    EXPECT_EQ(after["bodies"][1]["name"], "rod/1");
    EXPECT_NEAR(static_cast<double>(after["bodies"][0]["mass_kg"]) +
                    static_cast<double>(after["bodies"][1]["mass_kg"]),
                20,
                1e-5);
    for (const char* key : {"momentum_kgmps", "angular_momentum_kgm2ps"}) {
        const Vec3d was = vector_of(before[key]);
        EXPECT_LT(glm::distance(vector_of(after[key]), was), 1e-5 * glm::length(was)) << key;
    }
    EXPECT_NEAR(static_cast<double>(after["energy_J"]["kinetic"]) /
                    static_cast<double>(before["energy_J"]["kinetic"]),
                1,
                1e-5);
    EXPECT_EQ(line_of(effects, "fracture").calls > 0, true);
}

/// Clamped at one end to a post; `tip_kg` hang at the other.
SceneDescription cantilever(double tip_kg) {
    scene::EntityDescription rod = breakable_rod();
    rod.body->mass_kg = 0.1_r;
    scene::EntityDescription post =
        test::box("post", {-1.5_r, 5, 0}, {1, 1, 1}, physics::BodyKind::Static);
    scene::EntityDescription tip = test::box("tip", {0.95_r, 4.5_r, 0}, {0.1_r, 0.1_r, 0.1_r});
    tip.body->mass_kg = static_cast<Real>(tip_kg);
    SceneDescription scene = test::scene_of({rod, post, tip});
    scene.gravity_mps2 = {0, -10, 0};
    scene.joints = {{.name = "clamp",
                     .kind = physics::JointKind::Fixed,
                     .a = "rod",
                     .b = "post",
                     .anchor_a_m = {-1, 5, 0},
                     .anchor_b_m = {-1, 5, 0}},
                    {.name = "hook",
                     .kind = physics::JointKind::BallAndSocket,
                     .a = "tip",
                     .b = "rod",
                     .anchor_a_m = {0.95_r, 5, 0},
                     .anchor_b_m = {0.95_r, 5, 0}}};
    return scene;
}

// The moment is largest in the cut that is nearest to the clamp, 0.05 m or so off it.
TEST(Fracture, ACantileverBreaksAtItsClampAndItsJointsHoldTheParts) {
    const double bears_kg = kStrength_Pa * 1e-3 / 6 / (10 * 1.95);
    test::Running light(cantilever(0.9 * bears_kg));
    EffectRuntime light_effects(*light, {});
    light.step(60, light_effects);
    EXPECT_TRUE(light->find("rod"));

    test::Running heavy(cantilever(1.2 * bears_kg));
    EffectRuntime effects(*heavy, {});
    heavy.step(60, effects);
    EXPECT_FALSE(heavy->find("rod"));
    const auto& clamp = heavy->joints()[0];
    const auto& hook = heavy->joints()[1];
    ASSERT_TRUE(heavy->physics.contains(clamp.joint));
    ASSERT_TRUE(heavy->physics.contains(hook.joint));
    EXPECT_LT(heavy->physics.joint(clamp.joint).state.error_m, 1e-3_r);
    EXPECT_LT(heavy->physics.joint(hook.joint).state.error_m, 1e-3_r);
    EXPECT_LT(heavy.state("tip").world_from_body.position.y, 3) << "it fell with its end";
    const physics::BodyState stub = heavy->physics.state(clamp.a);
    EXPECT_NEAR(static_cast<double>(stub.center_of_mass_world().y), 5, 0.01) << "the rest stayed";
}

// One drop after another of the same height: what holds once holds for ever.
TEST(Fracture, WhatHoldsIsNotWornOut) {
    scene::EntityDescription rod = breakable_rod(1e9);
    rod.world_from_body.position.y = 0.5_r;
    rod.body->restitution = 0.9_r;
    SceneDescription scene = test::scene_of({rod, test::ground()});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(300, effects);
    EXPECT_TRUE(run->find("rod"));
    EXPECT_TRUE(run->registry.get<scene::Fragile>(run->find("rod")).cracked.empty());
}

// At every rate alike.
TEST(Fracture, ABlowBreaksByItsImpulse) {
    for (const int hz : {30, 60, 240}) {
        for (const double share : {0.5, 4.0}) {
            scene::EntityDescription rod = breakable_rod();
            rod.body->fracture->stiffness_Pa = 1e9_r;
            SceneDescription scene = test::scene_of({rod});
            scene.gravity_mps2 = {0, 0, 0};
            scene.accuracy.step_hz = hz;
            scene.accuracy.step_hz_given = true;
            // Most strikes its middle: it bends as a free beam.
            scene.forces.explosions.push_back({.at_s = 0.1,
                                               .position_m = {0, 5.3_r, 0},
                                               .impulse_Ns = static_cast<Real>(share * 60)});
            test::Running run(scene);
            EffectRuntime effects(*run, {});
            run.step(hz / 2, effects);
            EXPECT_EQ(static_cast<bool>(run->find("rod")), share < 1) << hz << " " << share;
        }
    }
}

TEST(Fracture, PartsBreakOnAndAreNumberedOn) {
    SceneDescription scene = spinning_at(3 * breaking_spin_radps());
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(60, effects);
    const nlohmann::json state = state_of(*run);
    EXPECT_GT(state["breaks"][0]["pieces"], 2);
    EXPECT_FALSE(run->find("rod"));
    EXPECT_EQ(state["bodies"].size(), state["breaks"][0]["pieces"]);
}

TEST(Fracture, SwitchedOffNothingBreaks) {
    test::Running run(spinning_at(2 * breaking_spin_radps()));
    EffectRuntime effects(*run, {});
    run->switches.turn("fracture", false);
    run.step(30, effects);
    EXPECT_TRUE(run->find("rod"));
    EXPECT_EQ(line_of(effects, "fracture").calls, 0U);
    run->switches.turn("fracture", true);
    run.step(2, effects);
    EXPECT_FALSE(run->find("rod"));
}

TEST(Fracture, SleepersAndSinglePiecesAreLeftAlone) {
    scene::EntityDescription rod = breakable_rod();
    rod.world_from_body.position.y = 0.05_r;
    test::Running run(test::scene_of({rod, test::ground()}));
    EffectRuntime effects(*run, {});
    run.step(300, effects);
    ASSERT_FALSE(run.state("rod").awake);
    const std::uint64_t calls = line_of(effects, "fracture").calls;
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "fracture").calls, calls);
}

}  // namespace
}  // namespace plumbline::effects
