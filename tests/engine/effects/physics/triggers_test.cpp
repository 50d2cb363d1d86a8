// What volumes do to the world.
#include "tests/engine/effects/drawn.h"

#include <algorithm>

namespace plumbline::effects {
namespace {

/// The book's volume: half as large 1, 0.25 and 1 m at (0, 1.5, 0), over a floor at y = 1.
scene::SceneDescription with_trigger(int times) {
    scene::EntityDescription floor =
        test::box("floor", {0, 0, 0}, {100, 2, 100}, physics::BodyKind::Static);
    scene::EntityDescription red = test::box("red_box", {0, 10, 0}, {2, 2, 2});
    red.body->mass_kg = 1;
    scene::EntityDescription volume = test::box("trigger", {0, 1.5_r, 0}, {2, 0.5_r, 2});
    volume.body.reset();
    volume.trigger = scene::TriggerDescription{
        .of = {"red_box"}, .times = times, .spawn = "green_box", .at_m = {5, 10, 0}};
    scene::SceneDescription scene = test::scene_of({floor, red, volume});
    scene.gravity_mps2 = {0, -10, 0};
    scene.prefabs["green_box"] = test::box("green_box", {0, 0, 0}, {4, 4, 4});
    scene.prefabs["green_box"].body->mass_kg = 2;
    return scene;
}

// SOURCES A36: the box's lower side is at y = 9 and comes to the volume's top, 1.75, after
// sqrt(2 * 7.25 / 10) = 1.204 s, which is in step 73. It falls through, to y = 2.
TEST(Triggers, ABoxThatComesInMakesAnotherAppear) {
    test::Running run(with_trigger(1));
    EffectRuntime effects(*run, {});
    run.step(72, effects);
    EXPECT_FALSE(run->registry.alive(run->find("green_box#1")));
    run.step(1, effects);
    ASSERT_TRUE(run->registry.alive(run->find("green_box#1")));
    EXPECT_NEAR(run.state("green_box#1").world_from_body.position.x, 5, 1e-6);
    EXPECT_NEAR(run.state("green_box#1").world_from_body.position.y, 10, 1e-6);
    EXPECT_NEAR(run->physics.state(run.body("green_box#1")).mass.mass_kg, 2, 1e-5);
    run.step(240, effects);
    EXPECT_NEAR(run.state("red_box").world_from_body.position.y, 2, 0.02) << "nothing stopped it";
    EXPECT_FALSE(run->registry.alive(run->find("green_box#2"))) << "once only";
    EXPECT_EQ(line_of(effects, "triggers").calls, 1U);
}

TEST(Triggers, CountsEachTimeABodyComesInAsOftenAsItMay) {
    test::Running run(with_trigger(2));
    EffectRuntime effects(*run, {});
    for (std::uint64_t visit = 1; visit <= 3; ++visit) {
        run->physics.set_pose(run.body("red_box"), {.position = {0, 1.9_r, 0}});
        run.step(2, effects);
        EXPECT_EQ(line_of(effects, "triggers").calls, std::min<std::uint64_t>(visit, 2));
        run->physics.set_pose(run.body("red_box"), {.position = {0, 30, 0}});
        run.step(2, effects);
    }
}

TEST(Triggers, CountTowardsTheGoalAndAreHeardWhereTheyAre) {
    scene::SceneDescription scene = with_trigger(2);
    scene.entities[2].trigger->spawn.clear();
    scene.entities[2].trigger->count = true;
    scene.entities[2].trigger->sound =
        std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds/impact_chime_0.ogg";
    test::Running run(scene);
    EffectRuntime effects(*run, {.frame = false, .sound = true});
    std::vector<audio::SoundCue> cues;
    for (int visit = 1; visit <= 3; ++visit) {
        run->physics.set_pose(run.body("red_box"), {.position = {0, 1.9_r, 0}});
        run.step(2, effects);
        EXPECT_EQ(run->counted, std::min(visit, 2));
        run->physics.set_pose(run.body("red_box"), {.position = {0, 30, 0}});
        run.step(2, effects);
        for (const audio::SoundCue& cue : effects.sound(*run, {}).cues) cues.push_back(cue);
    }
    ASSERT_EQ(cues.size(), 2U);
    EXPECT_EQ(cues[0].position_world, (Vec3f{0, 1.5F, 0}));
}

TEST(Triggers, OthersThanThoseItNamesDoNotCount) {
    scene::SceneDescription scene = with_trigger(1);
    scene.entities[1].name = "blue_box";
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(180, effects);
    EXPECT_EQ(line_of(effects, "triggers").calls, 0U);
}

TEST(Triggers, OnlyWhatMovesByItselfComesIn) {
    scene::SceneDescription scene = with_trigger(5);
    scene.entities[2].trigger->of.clear();
    scene.entities[1].body->kind = physics::BodyKind::Kinematic;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run->physics.set_pose(run.body("red_box"), {.position = {0, 1.9_r, 0}});
    run.step(3, effects);
    EXPECT_EQ(line_of(effects, "triggers").calls, 0U) << "kinematic";
    run->spawn(test::box("visitor", {0, 1.5_r, 0}, {0.1_r, 0.1_r, 0.1_r}));
    run.step(3, effects);
    EXPECT_EQ(line_of(effects, "triggers").calls, 1U) << "of any name, once while it is inside";
}

/// Gates 2 cm thick along x, one at every metre from 1 on.
scene::SceneDescription with_gates(int gates, double ball_mps) {
    scene::EntityDescription ball = test::ball("ball", {0, 0, 0}, 0.05_r);
    ball.body->mass_kg = 1;
    ball.body->velocity_mps = {static_cast<Real>(ball_mps), 0, 0};
    scene::SceneDescription scene = test::scene_of({ball});
    scene.gravity_mps2 = {0, 0, 0};
    for (int i = 1; i <= gates; ++i) {
        scene::EntityDescription gate =
            test::box("gate" + std::to_string(i), {static_cast<Real>(i), 0, 0}, {0.02_r, 2, 2});
        gate.body.reset();
        gate.trigger = scene::TriggerDescription{.times = 10, .message = gate.name};
        scene.entities.push_back(gate);
    }
    return scene;
}

// 3.3 m a step: forty gates count once each, in their order.
TEST(Triggers, NoneIsFlownThroughUnseen) {
    test::Running run(with_gates(40, 200));
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    ASSERT_EQ(run->messages.size(), 40U);
    for (std::size_t i = 0; i < 40; ++i)
        EXPECT_EQ(run->messages[i], "gate" + std::to_string(i + 1));
    EXPECT_EQ(line_of(effects, "triggers").calls, 40U);
}

TEST(Triggers, WhatFliesPastDoesNotCount) {
    scene::SceneDescription scene = with_gates(5, 200);
    for (std::size_t i = 1; i < scene.entities.size(); ++i)
        scene.entities[i].world_from_body.position.y = 1.2_r;  // 15 cm beside the ball
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_TRUE(run->messages.empty());
}

TEST(Triggers, PushTurnGravityAndRemove) {
    scene::SceneDescription scene = with_gates(3, 10);
    scene.entities[1].trigger->impulse_Ns = Vec3{0, 2, 0};
    scene.entities[2].trigger->gravity_mps2 = Vec3{0, -1, 0};
    scene.entities[3].trigger->remove = true;
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(8, effects);  // 0.13 s: past the first
    EXPECT_NEAR(static_cast<double>(run.state("ball").velocity_mps.y), 2, 1e-4);
    EXPECT_EQ(run->physics.def().gravity_mps2, (Vec3{0, 0, 0}));
    run.step(6, effects);
    EXPECT_EQ(run->physics.def().gravity_mps2, (Vec3{0, -1, 0}));
    run.step(6, effects);
    EXPECT_FALSE(run->registry.alive(run->find("ball")));
}

TEST(Triggers, LightLampsAndCharges) {
    scene::SceneDescription scene = with_gates(1, 10);
    scene::EntityDescription lamp = test::box("lamp", {0, 5, 0}, {1, 1, 1});
    lamp.body.reset();
    lamp.light = scene::LightDescription{};
    scene.entities.push_back(lamp);
    scene.entities[1].trigger->light = "lamp";
    scene.entities[1].trigger->explode = "charge";
    scene.forces.explosions.push_back(
        {.name = "charge", .position_m = {1.2_r, -2, 0}, .impulse_Ns = 5000});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(10, effects);
    EXPECT_EQ(run->registry.get<scene::PointLight>(run->find("lamp")).on, scene::LampOn::Never);
    EXPECT_GT(run.state("ball").velocity_mps.y, 0);
}

}  // namespace
}  // namespace plumbline::effects
