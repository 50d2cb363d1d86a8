// Force fields as effects: there only while called for, asleep when nothing happens, gone in mid-game, and saved.
#include "engine/core/io/archive.h"
#include "tests/engine/effects/drawn.h"

#include <array>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

scene::EntityDescription kilogram(const std::string& name, const Vec3& position_m) {
    scene::EntityDescription ball = test::ball(name, position_m, 0.2_r);
    ball.body->mass_kg = 1;
    return ball;
}

SceneDescription pond_with(std::vector<scene::EntityDescription> entities) {
    SceneDescription scene = test::scene_of(std::move(entities));
    scene.waters.push_back({.name = "pond", .min_m = {-9, -9, -9}, .max_m = {9, 0, 9}});
    return scene;
}

TEST(FieldEffects, AreAllZeroWhereNothingCallsForThem) {
    test::Running run(test::scene_of({test::ground(), kilogram("ball", {0, 1, 0})}));
    EffectRuntime effects(*run, {});
    run.step(60, effects);
    for (const char* name : {"drag", "buoyancy", "magnets", "conveyor", "explosion"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_FALSE(line.exists) << name;
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.cpu_ms, 0.0) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
    EXPECT_TRUE(run->force_fields.all().empty());
}

TEST(FieldEffects, NameTheirCallers) {
    SceneDescription scene = pond_with({kilogram("ball", {0, 0, 0})});
    scene.entities.front().body->drag = scene::Drag{};
    scene.entities.front().body->magnet = scene::Magnet{{1, 0, 0}};
    scene.explosions.push_back({.at_s = 5});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(10, effects);
    for (const char* name : {"drag", "buoyancy", "magnets", "explosion"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_TRUE(line.exists) << name;
        EXPECT_EQ(line.called_for_by.size(), 1U) << name;
    }
    EXPECT_GE(line_of(effects, "drag").calls, 10U);
    EXPECT_EQ(line_of(effects, "explosion").calls, 0U) << "not yet";
}

TEST(Buoyancy, FloatsFallAsleepAndCostNothing) {
    test::Running run(pond_with({kilogram("ball", {0, 0.1_r, 0})}));
    EffectRuntime effects(*run, {});
    run.step(1200, effects);
    EXPECT_FALSE(run.state("ball").awake);
    const std::uint64_t calls = line_of(effects, "buoyancy").calls;
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "buoyancy").calls, calls);
    run->physics.apply_impulse(run.body("ball"), {0, 1, 0});
    run.step(1, effects);
    EXPECT_GT(line_of(effects, "buoyancy").calls, calls);
}

TEST(Buoyancy, CalledOffInMidGameLetsGo) {
    test::Running run(pond_with({kilogram("ball", {0, 0.1_r, 0})}));
    EffectRuntime effects(*run, {});
    run.step(1200, effects);
    ASSERT_FALSE(run.state("ball").awake);
    run->switches.turn("buoyancy", false);
    run.step(60, effects);
    EXPECT_LT(run.state("ball").velocity_mps.y, -9) << "it falls";
    EXPECT_FALSE(line_of(effects, "buoyancy").exists);
    EXPECT_TRUE(run->force_fields.all().empty());
    run->switches.turn("buoyancy", true);
    run.step(1, effects);
    EXPECT_EQ(line_of(effects, "buoyancy").constructions, 2U);
}

TEST(Buoyancy, ActsInWaterOnlyAndDownToItsGround) {
    SceneDescription scene =
        pond_with({kilogram("beside", {20, -1, 0}), kilogram("below", {0, -12, 0})});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_NEAR(static_cast<double>(run.state("beside").velocity_mps.y), -9.81 / 2, 1e-3);
    EXPECT_NEAR(static_cast<double>(run.state("below").velocity_mps.y), -9.81 / 2, 1e-3);
    EXPECT_EQ(line_of(effects, "buoyancy").calls, 0U);
}

TEST(Drag, GustsWakeWhatTheyMoveAndNothingElse) {
    SceneDescription scene = test::scene_of({test::ground()});
    scene.wind = scene::WindDescription{.speed_mps = 8, .gusts = 1, .gust_size_m = 40};
    scene::EntityDescription light = test::box("light", {0, 0.5_r, 0}, {1, 1, 1});
    light.body->mass_kg = 4;
    light.body->friction = 1.0_r;
    light.body->drag = scene::Drag{.coefficient = 1.05_r};
    scene::EntityDescription heavy = light;
    heavy.name = "heavy";
    heavy.world_from_body.position.x = 5;
    heavy.body->mass_kg = 4000;
    scene.entities.push_back(light);
    scene.entities.push_back(heavy);
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    int heavy_awake = 0;
    int light_awake = 0;
    run.step(240, effects);
    for (int i = 0; i < 1200; ++i) {
        run.step(1, effects);
        heavy_awake += run.state("heavy").awake ? 1 : 0;
        light_awake += run.state("light").awake ? 1 : 0;
    }
    EXPECT_EQ(heavy_awake, 0);
    EXPECT_GT(light_awake, 100);
}

TEST(Drag, StillWindKeepsNobodyAwake) {
    SceneDescription scene = test::scene_of({test::ground()});
    scene.wind = scene::WindDescription{.speed_mps = 5, .gusts = 0};
    for (int i = 0; i < 20; ++i) {
        scene::EntityDescription box = test::box(
            "box" + std::to_string(i), {static_cast<Real>(2 * i - 20), 0.5_r, 0}, {1, 1, 1});
        box.body->drag = scene::Drag{.coefficient = 1.05_r};
        scene.entities.push_back(box);
    }
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(240, effects);
    const std::uint64_t calls = line_of(effects, "drag").calls;
    run.step(60, effects);
    EXPECT_EQ(line_of(effects, "drag").calls, calls);
}

TEST(Drag, ALeeIsStill) {
    SceneDescription scene = test::scene_of({test::ground()});
    scene.wind = scene::WindDescription{.speed_mps = 20, .gusts = 0, .shelter = true};
    scene.gravity_mps2 = {0, 0, 0};
    scene.entities.push_back(
        test::box("wall", {-1, 2, 0}, {0.2_r, 4, 4}, physics::BodyKind::Static));
    scene.entities.push_back(kilogram("sheltered", {0, 1, 0}));
    scene.entities.push_back(kilogram("exposed", {0, 1, 10}));
    for (std::size_t i = 2; i < 4; ++i) scene.entities[i].body->drag = scene::Drag{};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_LT(run.state("sheltered").velocity_mps.x, run.state("exposed").velocity_mps.x / 50);
    EXPECT_GT(run.state("exposed").velocity_mps.x, 1);
}

TEST(Magnets, OneThatMovesWakesOneThatSleeps) {
    SceneDescription scene = test::scene_of({test::ground()});
    for (const char* name : {"lies", "comes"}) {
        scene::EntityDescription magnet = test::box(name, {0, 0.05_r, 0}, {0.1_r, 0.1_r, 0.1_r});
        magnet.body->mass_kg = 0.5_r;
        magnet.body->magnet = scene::Magnet{{0, 0, 100}};
        scene.entities.push_back(magnet);
    }
    scene.entities.back().world_from_body.position = {0, 0.05_r, 8};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(180, effects);
    EXPECT_FALSE(run.state("lies").awake);
    EXPECT_EQ(line_of(effects, "magnets").calls > 0, true);
    run->physics.set_pose(run.body("comes"), {.position = {0, 0.05_r, 0.18_r}});
    run->physics.set_velocity(run.body("comes"), {0, 0, -0.1_r}, {0, 0, 0});
    run.step(30, effects);
    EXPECT_GT(run.state("lies").world_from_body.position.z, 0.01_r) << "pulled towards it";
}

TEST(Magnets, FixedOnesPullAndStay) {
    SceneDescription scene = test::scene_of({});
    scene.gravity_mps2 = {0, 0, 0};
    scene::EntityDescription fixed = kilogram("fixed", {0, 0, 0});
    fixed.body->kind = physics::BodyKind::Static;
    fixed.body->magnet = scene::Magnet{{0, 0, 100}};
    scene::EntityDescription free = kilogram("free", {0, 0, 1});
    free.body->magnet = scene::Magnet{{0, 0, 100}};
    scene.entities = {fixed, free};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    EXPECT_NEAR(static_cast<double>(run.state("free").velocity_mps.z), -0.5 * 6e-3, 1e-4);
}

TEST(Conveyor, StopsWhenItIsCalledOff) {
    SceneDescription scene =
        test::scene_of({test::ground(), test::box("box", {0, 0.5_r, 0}, {1, 1, 1})});
    scene.entities.front().body->surface_velocity_mps = {2, 0, 0};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(90, effects);
    EXPECT_NEAR(static_cast<double>(run.state("box").velocity_mps.x), 2, 1e-3);
    EXPECT_GE(line_of(effects, "conveyor").calls, 90U);
    run->switches.turn("conveyor", false);
    run.step(90, effects);
    EXPECT_NEAR(static_cast<double>(run.state("box").velocity_mps.x), 0, 1e-3);
    EXPECT_FALSE(line_of(effects, "conveyor").exists);
}

TEST(Explosion, GoesOffOnceAtEveryRate) {
    for (const int hz : {30, 60, 240}) {
        SceneDescription scene = test::scene_of({kilogram("ball", {0, 0, 2})});
        scene.gravity_mps2 = {0, 0, 0};
        scene.accuracy.step_hz = hz;
        scene.accuracy.step_hz_given = true;
        scene.explosions.push_back({.at_s = 0.5, .impulse_Ns = 100});
        test::Running run(scene);
        EffectRuntime effects(*run, {});
        run.step(hz / 2, effects);
        EXPECT_EQ(run.state("ball").velocity_mps.z, 0) << hz;
        run.step(hz, effects);
        EXPECT_NEAR(static_cast<double>(run.state("ball").velocity_mps.z), 100 * 0.01 / 4, 1e-4)
            << hz;
    }
}

TEST(Explosion, SparesWhatIsOutOfReachOrHidden) {
    SceneDescription scene = test::scene_of(
        {kilogram("near", {0, 0, 2}), kilogram("far", {0, 0, -5}), kilogram("behind", {4, 0, 0})});
    scene.gravity_mps2 = {0, 0, 0};
    scene.entities.push_back(
        test::box("wall", {2, 0, 0}, {0.2_r, 3, 3}, physics::BodyKind::Static));
    scene.explosions.push_back({.at_s = 0, .impulse_Ns = 100, .reach_m = 4.5_r});
    scene.explosions.push_back(
        {.position_m = {0, 0, 2.5_r}, .impulse_Ns = 1000});  // nobody sets it off
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(2, effects);
    EXPECT_GT(run.state("near").velocity_mps.z, 0);
    EXPECT_EQ(run.state("far").velocity_mps.z, 0);
    EXPECT_EQ(run.state("behind").velocity_mps.x, 0);
    EXPECT_EQ(line_of(effects, "explosion").calls, 2U)
        << "near and, hidden, none: targets in reach";
}

}  // namespace
}  // namespace plumbline::effects
