// What is added to the image's light after the scene: by whom, with which numbers, and that nobody
// pays who does not call.
#include "tests/engine/effects/drawn.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

TEST(ScreenEffects, NobodyWhoDoesNotCallForThemPays) {
    Running run(test::scene_of({test::ground()}));
    EffectRuntime effects(*run, kImage);
    run.step(2, effects);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_FALSE(frame.occlusion);
    EXPECT_FALSE(frame.shafts);
    EXPECT_FALSE(frame.depth_of_field);
    EXPECT_FALSE(frame.motion_blur);
    EXPECT_FALSE(frame.refraction);
    for (const char* name : {"refraction",
                             "caustics",
                             "ambient_occlusion",
                             "sun_shafts",
                             "depth_of_field",
                             "motion_blur"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
}

TEST(ScreenEffects, OcclusionHasTheScenesNumbersAndItsFidelitysLooks) {
    SceneDescription scene = test::scene_of({});
    scene.occlusion = scene::OcclusionDescription{
        .radius_m = 0.5F, .strength = 0.75F, .location = in_file("garden.toml", 30)};
    scene.screen_fidelity.occlusion = scene::Fidelity::Draft;
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.occlusion);
    EXPECT_EQ(frame.occlusion->radius_m, 0.5F);
    EXPECT_EQ(frame.occlusion->strength, 0.75F);
    EXPECT_EQ(frame.occlusion->slices * frame.occlusion->steps, 2U);
    EXPECT_EQ(line_of(effects, "ambient_occlusion").called_for_by,
              Callers{"[ambient] occlusion (garden.toml:30)"});
    run->switches.turn("ambient_occlusion", false);
    EXPECT_FALSE(draw(run, effects).occlusion);
}

TEST(ScreenEffects, ShaftsAndLensHaveTheScenesNumbers) {
    SceneDescription scene = test::scene_of({});
    scene.sun = scene::SunDescription{};
    scene.sun->shafts = scene::ShaftsDescription{
        .density_per_m = 0.03F, .distance_m = 25.0F, .location = in_file("garden.toml", 4)};
    scene.camera.focus = scene::FocusDescription{
        .distance_m = 3.0F, .aperture_m = 0.01F, .location = in_file("garden.toml", 9)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.shafts);
    EXPECT_EQ(frame.shafts->density_per_m, 0.03F);
    EXPECT_EQ(frame.shafts->distance_m, 25.0F);
    ASSERT_TRUE(frame.depth_of_field);
    EXPECT_EQ(frame.depth_of_field->focus_m, 3.0F);
    EXPECT_EQ(frame.depth_of_field->aperture_m, 0.01F);
    EXPECT_EQ(line_of(effects, "sun_shafts").called_for_by,
              Callers{"[sun] shafts (garden.toml:4)"});
    EXPECT_EQ(line_of(effects, "depth_of_field").called_for_by,
              Callers{"[camera] focus (garden.toml:9)"});
}

TEST(ScreenEffects, WaterThatIsSeenIntoCallsForRefractionAndItsCaustics) {
    SceneDescription scene = test::scene_of({test::ground(), test::cube("pool", {0, 2, 0})});
    scene.entities[1].material = "water";
    const auto row_of = [&](float attenuation_m, float caustics) {
        scene.materials["water"] = {.alpha_mode = assets::AlphaMode::Blend,
                                    .ripple_slope = 0.1F,
                                    .attenuation_m = attenuation_m,
                                    .caustics = caustics};
        Running run(scene);
        EffectRuntime effects(*run, kImage);
        const render::RenderFrame frame = draw(run, effects);
        const bool seen = attenuation_m > 0.0F;
        EXPECT_EQ(frame.refraction.has_value(), seen);
        EXPECT_EQ(frame.refraction && frame.refraction->caustics, seen && caustics > 0.0F);
        const Callers pool = seen ? Callers{"entity pool (test.toml:10)"} : Callers{};
        EXPECT_EQ(line_of(effects, "refraction").called_for_by, pool);
        EXPECT_EQ(line_of(effects, "caustics").calls, seen && caustics > 0.0F ? 1U : 0U);
        run->switches.turn("refraction", false);
        EXPECT_FALSE(draw(run, effects).refraction);
    };
    row_of(0.0F, 3.0F);
    row_of(2.0F, 0.0F);
    row_of(2.0F, 3.0F);
}

/// Images of a camera that goes its way, one a step of 1/60 s; the shutter is open for half of it.
class Shutter : public testing::Test {
protected:
    static SceneDescription scene() {
        SceneDescription scene = test::scene_of({});
        scene.post = scene::PostDescription{};
        scene.post->shutter = scene::ShutterDescription{.open_s = 1.0F / 120.0F};
        return scene;
    }
    std::optional<render::MotionBlur> seen_from(const Pose& world_from_camera) {
        run_.step(1, effects_);
        return seen_now(world_from_camera);
    }
    std::optional<render::MotionBlur> seen_now(const Pose& world_from_camera) {
        scene::ViewPoint view;
        view.world_from_camera = world_from_camera;
        render::RenderFrame frame = scene::extract(*run_, view, 64, 64);
        effects_.extract(*run_, view, frame);
        return frame.motion_blur;
    }
    Running run_{scene()};
    EffectRuntime effects_{*run_, kImage};
};

TEST_F(Shutter, OpensWhereTheCameraWasHalfWayBack) {
    EXPECT_FALSE(seen_from({.position = {0, 0, 0}})) << "nothing was seen before";
    const auto moved = seen_from({.position = {0.2_r, 0, 0}});
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->position_before_world.x, 0.1F, 1e-5F);
    const auto turned =
        seen_from({.position = {0.2_r, 0, 0}, .orientation = glm::angleAxis(0.1_r, Vec3{0, 1, 0})});
    ASSERT_TRUE(turned);
    EXPECT_NEAR(glm::angle(turned->orientation_before), 0.05F, 1e-4F);
}

TEST_F(Shutter, ACameraThatStandsStillCostsNothing) {
    seen_from({.position = {1, 2, 3}});
    EXPECT_FALSE(seen_from({.position = {1, 2, 3}}));
    EXPECT_EQ(line_of(effects_, "motion_blur").calls, 0U);
}

TEST(ScreenEffects, TheShutterSeesWhatMoves) {
    SceneDescription scene = test::scene_of(
        {test::ground(), test::cube("rests", {0, 0.5_r, 0}), test::cube("falls", {9, 30, 0})});
    scene.entities[1].body->kind = physics::BodyKind::Static;
    scene.post = scene::PostDescription{};
    scene.post->shutter = scene::ShutterDescription{.open_s = 1.0F / 120.0F};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    run.step(20, effects);
    EXPECT_FALSE(draw(run, effects).motion_blur) << "nothing was seen before";
    run.step(1, effects);
    const auto blur = draw(run, effects, 0.5_r).motion_blur;
    ASSERT_TRUE(blur);
    ASSERT_EQ(blur->moved.size(), 1U);
    const render::MovedMesh& falls = blur->moved[0];
    const auto fallen_m = falls.world_from_body_before[3].y - falls.world_from_body[3].y;
    // Half a step at the speed of the latest one: g times 21 steps, to a step.
    EXPECT_NEAR(fallen_m, 9.81F * 21.0F / 60.0F / 120.0F, 9.81F / 60.0F / 120.0F);
    EXPECT_NEAR(falls.world_from_body[3].x, 9.0F, 1e-5F);
}

TEST_F(Shutter, AWorldThatStandsStillAndACutToAnotherPlaceAreSharp) {
    seen_from({.position = {0, 0, 0}});
    EXPECT_FALSE(seen_now({.position = {0.1_r, 0, 0}})) << "paused";
    EXPECT_FALSE(seen_from({.position = {30, 0, 0}})) << "a cut";
    run_.step(30, effects_);
    EXPECT_FALSE(seen_from({.position = {30.5_r, 0, 0}})) << "half a second later";
}

}  // namespace
}  // namespace plumbline::effects
