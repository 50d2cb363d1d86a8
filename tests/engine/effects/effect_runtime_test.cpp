#include "engine/effects/effect_runtime.h"

#include "engine/scene/extract.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>

namespace plumbline::effects {
namespace {

using scene::EntityDescription;
using scene::SceneDescription;
using test::ball;
using test::box;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

constexpr ServedDomains kStepsOnly{};
constexpr ServedDomains kAll{.frame = true, .sound = true};

void expect_nothing(const LedgerLine& line) {
    EXPECT_TRUE(line.called_for_by.empty()) << line.name;
    EXPECT_EQ(line.constructions, 0U) << line.name;
    EXPECT_EQ(line.calls, 0U) << line.name;
    EXPECT_EQ(line.cpu_ms, 0.0) << line.name;
    EXPECT_EQ(line.gpu_ms, 0.0) << line.name;
    EXPECT_EQ(line.bytes_cpu, 0U) << line.name;
    EXPECT_EQ(line.bytes_gpu, 0U) << line.name;
    EXPECT_FALSE(line.exists) << line.name;
}

TEST(EffectTable, HasTheRowsOfTheContract) {
    std::vector<std::string_view> names;
    for (const EffectRow& row : effect_table()) names.push_back(row.name);
    const std::vector<std::string_view> expected{"sun_shadow",
                                                 "light_shadows",
                                                 "flashlight",
                                                 "fog",
                                                 "skybox",
                                                 "refraction",
                                                 "caustics",
                                                 "ambient_occlusion",
                                                 "indirect_light",
                                                 "sun_shafts",
                                                 "depth_of_field",
                                                 "motion_blur",
                                                 "post",
                                                 "model_animation",
                                                 "contact_look",
                                                 "triggers",
                                                 "viewer_aids",
                                                 "light_cubes",
                                                 "wind",
                                                 "grass",
                                                 "flock",
                                                 "fountain",
                                                 "impact_sounds",
                                                 "rolling_sounds",
                                                 "plaques",
                                                 "joint_bars",
                                                 "ambient_sounds",
                                                 "footsteps",
                                                 "creak_sounds",
                                                 "wind_sound",
                                                 "sound_paths",
                                                 "room_reverb",
                                                 "explosion",
                                                 "drag",
                                                 "buoyancy",
                                                 "water",
                                                 "magnets",
                                                 "conveyor",
                                                 "rope",
                                                 "cloth",
                                                 "soft",
                                                 "vehicles",
                                                 "fracture",
                                                 "continuous_collision",
                                                 "gyroscopic_torque",
                                                 "contact_events",
                                                 "burst_sounds"};
    EXPECT_EQ(names, expected);
}

/// As a source file of its own would: a lamp that is called for when time has come to it.
struct Lamp final : Effect {
    void extract(const scene::Simulation&,
                 const scene::ViewPoint&,
                 render::RenderFrame& frame) override {
        frame.post = render::Post{.exposure = 3.0F, .bloom = 0.0F};
        ++work_.calls;
    }
};
EffectRow lamp() {
    return {.name = "lamp",
            .domain = Domain::Frame,
            .called_for_by = [](const scene::Simulation& simulation) -> Callers {
                const bool by_time = simulation.steps() >= 3;
                if (!simulation.switches.is_on("lamp", by_time)) return {};
                return {"the third step"};
            },
            .make = [](scene::Simulation&) -> std::unique_ptr<Effect> {
                return std::make_unique<Lamp>();
            },
            .key = [](const scene::Simulation& simulation) { return simulation.steps() / 3; },
            .gpu_owner = "lamp",
            .passes = "lamp."};
}

// All that a new effect brings is in its row: key, switch, passes and memory on the GPU.
TEST(EffectTable, AnEffectIsAddedByOneRow) {
    std::vector<EffectRow> table(effect_table().begin(), effect_table().end());
    table.push_back(lamp());
    Running run(scene_of({}));
    EffectRuntime effects(*run, kAll, table);
    EXPECT_FALSE(draw(run, effects).post);
    run.step(2, effects);
    EXPECT_FALSE(draw(run, effects).post);
    expect_nothing(line_of(effects, "lamp"));

    run.step(1, effects);
    EXPECT_EQ(draw(run, effects).post->exposure, 3.0F);
    run->switches.turn("lamp", false);
    EXPECT_FALSE(draw(run, effects).post);
    run->switches.turn("lamp", true);
    EXPECT_TRUE(draw(run, effects).post);

    render::FrameStats stats;
    stats.passes.push_back({.name = "lamp.glow", .cpu_ms = 2.0, .gpu_ms = 5.0});
    const std::array bytes{render::GpuBytes{.owner = "lamp", .bytes = 77}};
    effects.add_render_stats(stats, bytes);
    const LedgerLine line = line_of(effects, "lamp");
    EXPECT_EQ(line.called_for_by, Callers{"the third step"});
    EXPECT_EQ(line.constructions, 2U);
    EXPECT_EQ(line.calls, 2U);
    EXPECT_GE(line.cpu_ms, 2.0);
    EXPECT_EQ(line.gpu_ms, 5.0);
    EXPECT_EQ(line.bytes_gpu, 77U);
}

// What `study --effects` measures by: called for, and yet not there.
TEST(EffectRuntime, TheOneLeftOutIsNeverMade) {
    SceneDescription scene = scene_of({ground(), cube("cube", {0, 8.5_r, 0})});
    scene.fog.emplace();
    Running with(scene);
    Running without(scene);
    EffectRuntime all(*with, {.frame = true});
    EffectRuntime left_out(*without, {.frame = true, .without = "fog"});
    EXPECT_TRUE(draw(with, all).fog);
    EXPECT_FALSE(draw(without, left_out).fog);
    EXPECT_TRUE(line_of(all, "fog").exists);
    expect_nothing(line_of(left_out, "fog"));
}

TEST(EffectRuntime, AFallingCubePaysForNothing) {
    SceneDescription scene = scene_of({ground(), cube("cube", {0, 8.5_r, 0})});
    scene.sun = scene::SunDescription{};  // a sun without a shadow is no effect
    Running run(scene);
    EffectRuntime effects(*run, kAll);
    for (int i = 0; i < 120; ++i) {
        run.step(1, effects);
        const render::RenderFrame frame = draw(run, effects);
        EXPECT_FALSE(frame.sun_shadow || frame.fog || frame.sky || frame.flashlight || frame.post);
        effects.sound(*run, {});
    }
    EXPECT_NEAR(static_cast<double>(run.state("cube").world_from_body.position.y), 0.5, 0.01);
    for (const LedgerLine& line : effects.ledger()) expect_nothing(line);
}

TEST(EffectRuntime, SaysWhichSettingCalls) {
    SceneDescription scene = scene_of({});
    scene.sun = scene::SunDescription{
        .shadow = scene::ShadowDescription{.size_px = 512, .location = in_file("garden.toml", 31)}};
    scene.fog =
        scene::FogDescription{.density_per_m = 0.5F, .location = in_file("garden.toml", 40)};
    scene.sky = scene::SkyDescription{.folder = "skies/x", .location = in_file("garden.toml", 50)};
    scene.post = scene::PostDescription{.bloom = 0.1F, .location = in_file("garden.toml", 60)};
    Running run(scene);
    EffectRuntime effects(*run, kAll);
    const render::RenderFrame frame = draw(run, effects);
    const auto caller = [&](std::string_view name) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 1U);
        EXPECT_EQ(line.calls, 1U);
        return line.called_for_by.size() == 1 ? line.called_for_by.front() : std::string();
    };
    EXPECT_EQ(caller("sun_shadow"), "[sun] shadow (garden.toml:31)");
    EXPECT_EQ(caller("fog"), "[fog] (garden.toml:40)");
    EXPECT_EQ(caller("skybox"), "[sky] skybox (garden.toml:50)");
    EXPECT_EQ(caller("post"), "[post] (garden.toml:60)");
    ASSERT_TRUE(frame.sun_shadow && frame.fog && frame.sky && frame.post);
    EXPECT_EQ(frame.sun_shadow->size_px, 512U);
    EXPECT_EQ(frame.fog->density_per_m, 0.5F);
    EXPECT_EQ(frame.sky->folder, "skies/x");
    EXPECT_EQ(frame.post->bloom, 0.1F);
}

TEST(EffectRuntime, MakesNoImageThatNobodyLooksAt) {
    SceneDescription scene = scene_of({});
    scene.fog = scene::FogDescription{};
    Running run(scene);
    EffectRuntime effects(*run, kStepsOnly);
    run.step(10, effects);
    expect_nothing(line_of(effects, "fog"));
}

TEST(EffectRuntime, SweepsOnlyWhileSomethingIsFast) {
    EntityDescription bullet = ball("bullet", {-15, 1, 0}, 0.1_r);
    bullet.body->velocity_mps = {100, 0, 0};
    Running run(scene_of(
        {ground(), box("wall", {0, 2, 0}, {0.05_r, 4, 4}, physics::BodyKind::Static), bullet}));
    EffectRuntime effects(*run, kStepsOnly);
    run.step(1, effects);
    EXPECT_EQ(line_of(effects, "continuous_collision").called_for_by,
              Callers{"entity bullet (test.toml:10)"});
    run.step(240, effects);
    EXPECT_LT(run.state("bullet").world_from_body.position.x, Real{0}) << "it passed the wall";
    const LedgerLine line = line_of(effects, "continuous_collision");
    EXPECT_FALSE(line.exists) << "it has come to rest";
    EXPECT_GE(line.constructions, 1U);
    EXPECT_GE(line.calls, 8U);  // 15 m at 1.67 m a step
}

TEST(EffectRuntime, GyroscopicTorqueFollowsTheSpin) {
    EntityDescription plank = box("plank", {0, 50, 0}, {2, 0.1_r, 0.3_r});
    plank.body->angular_velocity_radps = {1, 2, 3};
    Running run(scene_of({plank, cube("cube", {9, 50, 0})}));
    EffectRuntime effects(*run, kStepsOnly);
    run.step(10, effects);
    EXPECT_EQ(line_of(effects, "gyroscopic_torque").called_for_by,
              Callers{"entity plank (test.toml:10)"});
    EXPECT_EQ(line_of(effects, "gyroscopic_torque").calls, 10U);

    run->registry.destroy(run->find("plank"));
    run.step(1, effects);
    EXPECT_FALSE(line_of(effects, "gyroscopic_torque").exists);
    EXPECT_EQ(line_of(effects, "gyroscopic_torque").calls, 10U);
}

TEST(EffectRuntime, BooksThePassesOfItsRows) {
    SceneDescription scene = scene_of({});
    scene.sun = scene::SunDescription{.shadow = scene::ShadowDescription{}};
    scene.post = scene::PostDescription{};
    Running run(scene);
    EffectRuntime effects(*run, kAll);
    const double own_ms = line_of(effects, "post").cpu_ms;
    render::FrameStats stats;
    stats.passes = {{.name = "shadow.sun", .cpu_ms = 1.5, .gpu_ms = -1.0},
                    {.name = "opaque", .cpu_ms = 9.0, .gpu_ms = 9.0},
                    {.name = "post.bloom", .cpu_ms = 0.25, .gpu_ms = 2.0},
                    {.name = "post.tone_map", .cpu_ms = 0.5, .gpu_ms = 3.0}};
    const std::vector<render::GpuBytes> bytes{{.owner = "post", .bytes = 300},
                                              {.owner = "meshes", .bytes = 7},
                                              {.owner = "sun_shadow", .bytes = 40}};
    effects.add_render_stats(stats, bytes);
    effects.add_render_stats(stats, bytes);
    EXPECT_NEAR(line_of(effects, "post").cpu_ms - own_ms, 1.5, 1e-9);
    EXPECT_DOUBLE_EQ(line_of(effects, "post").gpu_ms, 10.0);
    EXPECT_EQ(line_of(effects, "post").bytes_gpu, 300U);
    EXPECT_EQ(line_of(effects, "sun_shadow").gpu_ms, -1.0) << "the driver does not tell";
    EXPECT_EQ(line_of(effects, "sun_shadow").bytes_gpu, 40U);
    EXPECT_EQ(line_of(effects, "fog").bytes_gpu, 0U);
}

}  // namespace
}  // namespace plumbline::effects
