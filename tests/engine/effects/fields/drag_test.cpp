// Who the wind wakes, and who it does not.
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;

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

}  // namespace
}  // namespace plumbline::effects
