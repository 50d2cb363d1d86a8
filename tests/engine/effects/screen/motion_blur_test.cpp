// A shutter that stays open.
#include "tests/engine/effects/drawn.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

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

TEST(MotionBlur, TheShutterSeesWhatMoves) {
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

TEST(MotionBlur, FidelityIsTheNumberOfSamples) {
    std::vector<std::uint32_t> samples;
    for (const scene::Fidelity fidelity :
         {scene::Fidelity::Draft, scene::Fidelity::Balanced, scene::Fidelity::Precise}) {
        SceneDescription scene = test::scene_of({test::cube("falls", {9, 30, 0})});
        scene.post = scene::PostDescription{};
        scene.post->shutter = scene::ShutterDescription{.open_s = 0.01F};
        scene.screen_fidelity.shutter = fidelity;
        Running run(scene);
        EffectRuntime effects(*run, kImage);
        run.step(20, effects);
        draw(run, effects);
        run.step(1, effects);
        const auto blur = draw(run, effects).motion_blur;
        ASSERT_TRUE(blur);
        samples.push_back(blur->samples);
    }
    EXPECT_EQ(samples, (std::vector<std::uint32_t>{6, 16, 48}));
}

}  // namespace
}  // namespace plumbline::effects
