// Waves as an effect: there while a surface has them, asleep when it is level, felt and made by floats.
#include "engine/scene/environment/wave_field.h"
#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

scene::SceneDescription wavy(std::vector<scene::EntityDescription> entities) {
    scene::SceneDescription scene = pond_with(std::move(entities));
    scene.forces.waters.front().surface = scene::WaterSurface::Waves;
    return scene;
}

TEST(Water, LevelSurfacesHaveNoWaves) {
    test::Running run(pond_with({kilogram("ball", {0, 0, 0})}));
    EffectRuntime effects(*run, {});
    run.step(10, effects);
    EXPECT_FALSE(line_of(effects, "water").exists);
    EXPECT_EQ(run->waters.front().waves, nullptr);
}

TEST(Water, LiesAsleepUntilSomethingFallsIn) {
    test::Running run(wavy({kilogram("ball", {0, 9, 0})}));
    EffectRuntime effects(*run, {});
    run.step(75, effects);
    EXPECT_TRUE(run->waters.front().waves->is_asleep()) << "the ball is still in the air";
    const std::uint64_t calls = line_of(effects, "water").calls;
    run.step(1, effects);
    EXPECT_EQ(line_of(effects, "water").calls, calls);
    EXPECT_EQ(run->waters.front().waves->energy_J(), 0);
    run.step(60, effects);
    EXPECT_GT(run->waters.front().waves->energy_J(), 0.01) << "it fell in";
    EXPECT_GT(line_of(effects, "water").calls, calls);
}

TEST(Water, AFloatFeelsTheWavesAndSleepsNoLonger) {
    scene::SceneDescription scene = wavy({kilogram("ball", {-6, 0.15866_r, 0})});
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(1800, effects);
    ASSERT_FALSE(run.state("ball").awake);
    run->waters.front().waves->displace({6, 0, 0}, 1, 2);
    double most_mps = 0;
    for (int i = 0; i < 600; ++i) {
        run.step(1, effects);
        most_mps =
            std::max(most_mps, static_cast<double>(std::abs(run.state("ball").velocity_mps.y)));
    }
    EXPECT_GT(most_mps, 0.02);
}

TEST(Water, CalledOffIsLevel) {
    scene::SceneDescription scene = wavy({kilogram("ball", {0, 0.1_r, 0})});
    scene.forces.waters.front().start = {.amplitude_m = 0.1_r, .nx = 1};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(30, effects);
    ASSERT_NE(run->waters.front().waves, nullptr);
    const std::uint64_t with_waves = run->state_hash();
    run->switches.turn("water", false);
    run.step(1, effects);
    EXPECT_EQ(run->waters.front().waves, nullptr);
    EXPECT_NE(run->state_hash(), with_waves);
    EXPECT_TRUE(line_of(effects, "buoyancy").exists) << "it floats on";
}

TEST(Water, IsDrawnAsItMovesAndFlatWhenCalledOff) {
    scene::SceneDescription scene = wavy({});
    scene.forces.waters.front().start = {.amplitude_m = 0.1_r, .nx = 1};
    scene.forces.waters.front().material = "water";
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(2, effects);
    render::RenderFrame frame;
    const auto& visual = run->registry.get<scene::Visual>(run->waters.front().surface);
    const auto& mesh = run->library().mesh(visual.mesh);
    effects.extract(*run, {}, frame);
    EXPECT_NEAR(mesh.bounds.max.y, run->waters.front().waves->height_m(-9, 0), 1e-3);
    const std::uint32_t version = mesh.version;
    effects.extract(*run, {}, frame);
    EXPECT_EQ(mesh.version, version) << "nothing moved since";
    run->switches.turn("water", false);
    run.step(1, effects);
    EXPECT_EQ(mesh.bounds.max.y, 0);
    EXPECT_EQ(mesh.bounds.min.y, 0);
}

TEST(Water, WhatGoesTakesItsVolumeAlong) {
    test::Running run(wavy({kilogram("ball", {0, 1, 0})}));
    EffectRuntime effects(*run, {});
    run.step(120, effects);
    EXPECT_NEAR(run->waters.front().waves->range().mean_m, 1e-3 / (18 * 18), 4e-7);
    run->registry.mark_for_destruction(run->find("ball"));
    run.step(2, effects);
    EXPECT_NEAR(run->waters.front().waves->range().mean_m, 0, 1e-9);
}

TEST(Water, ASoftBodyMakesWavesAndTakesItsVolumeAlong) {
    scene::SceneDescription scene = wavy({});
    scene::SoftDescription soft;
    soft.name = "jelly";
    soft.size_m = {1, 1, 1};
    soft.cell_m = 0.25;
    soft.density_kgpm3 = 600;
    soft.damping_s = 0.01;
    soft.pose.position = {1, 9, 0};
    scene.forces.softs = {soft};
    test::Running run(scene);
    EffectRuntime effects(*run, {});
    run.step(70, effects);
    EXPECT_TRUE(run->waters.front().waves->is_asleep()) << "it is still in the air";
    run.step(80, effects);
    EXPECT_GT(run->waters.front().waves->energy_J(), 5) << "it fell in";
    for (int i = 0; i < 10; ++i) {
        run.step(30, effects);
        EXPECT_NEAR(run->waters.front().waves->range().mean_m,
                    run->softs().front().displaced.volume_m3 / (18 * 18),
                    1e-9);
    }
    run->registry.mark_for_destruction(run->softs().front().entity);
    run.step(2, effects);
    EXPECT_NEAR(run->waters.front().waves->range().mean_m, 0, 1e-9);
}

}  // namespace
}  // namespace plumbline::effects
