// The light in the hand.
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;
using test::scene_of;

TEST(Flashlight, LivesWithItsSwitch) {
    SceneDescription scene = scene_of({});
    scene.flashlight = scene::FlashlightDescription{.intensity = 10, .color = {1, 1, 1}};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    EXPECT_FALSE(draw(run, effects).flashlight);
    EXPECT_EQ(line_of(effects, "flashlight").constructions, 0U);

    run->switches.turn("flashlight", true);
    const render::RenderFrame lit = draw(run, effects);
    ASSERT_TRUE(lit.flashlight);
    EXPECT_TRUE(test::near(lit.flashlight->intensity, Vec3f{10.0F}, 1e-6));
    const scene::ViewPoint view = run.game.view(*run, Real{1}, 0.0F, 0.0F);
    EXPECT_TRUE(
        test::near(lit.flashlight->position_world, Vec3f(view.world_from_hand.position), 1e-6))
        << "the beam starts at the hand";
    EXPECT_EQ(line_of(effects, "flashlight").called_for_by, Callers{"switch flashlight"});

    run->switches.turn("flashlight", false);
    EXPECT_FALSE(draw(run, effects).flashlight);
    const LedgerLine off = line_of(effects, "flashlight");
    EXPECT_FALSE(off.exists);
    EXPECT_EQ(off.bytes_cpu, 0U);
    EXPECT_EQ(off.constructions, 1U);
    EXPECT_EQ(off.calls, 1U);

    run->switches.turn("flashlight", true);
    draw(run, effects);
    EXPECT_EQ(line_of(effects, "flashlight").constructions, 2U);
    EXPECT_EQ(line_of(effects, "flashlight").calls, 2U);
}

TEST(Flashlight, NoPlayerHasAFlashlightThatTheSceneDoesNotGive) {
    Running run(scene_of({}));
    EffectRuntime effects(*run, kImage);
    run->switches.turn("flashlight", true);
    EXPECT_FALSE(draw(run, effects).flashlight);
}

TEST(Flashlight, IsHeldInTheHandOrStandsAtTheEye) {
    for (const bool at_eye : {false, true}) {
        SceneDescription scene = scene_of({});
        scene.flashlight =
            scene::FlashlightDescription{.inner_deg = 10, .outer_deg = 30, .on = true};
        scene.flashlight->at_eye = at_eye;
        Running run(scene);
        EffectRuntime effects(*run, kImage);
        effects.refresh(*run);
        scene::ViewPoint view;
        view.world_from_camera.position = {1, 2, 3};
        view.world_from_hand = {.position = {4, 5, 6},
                                .orientation = glm::angleAxis(kPi / 2, Vec3{0, 1, 0})};
        render::RenderFrame frame = scene::extract(*run, view, 64, 64);
        effects.extract(*run, view, frame);
        ASSERT_TRUE(frame.flashlight);
        const Vec3f place = at_eye ? Vec3f{1, 2, 3} : Vec3f{4, 5, 6};
        EXPECT_TRUE(test::near(frame.flashlight->position_world, place, 1e-6));
        // A quarter turn to the left of -z, also where it stands at the eye.
        EXPECT_TRUE(test::near(frame.flashlight->direction_world, Vec3f{-1, 0, 0}, 1e-6));
        EXPECT_NEAR(frame.flashlight->outer_rad, glm::pi<float>() / 6.0F, 1e-6F);
    }
}

}  // namespace
}  // namespace plumbline::effects
