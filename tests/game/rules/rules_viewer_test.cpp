// A model by itself: turned, shifted, zoomed at any size; nothing is thrown.
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

/// A model scene as its stage leaves it, around something of that radius at the origin.
scene::SceneDescription stage(Real radius_m) {
    scene::SceneDescription scene;
    scene.model_radius_m = radius_m;
    scene.camera.target_m = {0, 0, 0};
    scene.camera.position_m = {0, 0, 2 * radius_m};
    scene.entities.push_back(block("ground", {1, 1, 1}, {0, -10, 0}));
    return scene;
}

Vec3 eye(const Playground& play) {
    return play.game->view(*play.simulation, 1, 0, 0).world_from_camera.position;
}

Actions drag(Action action, float yaw_rad, float pitch_rad) {
    Actions actions = hold({action});
    actions.look_yaw_rad = yaw_rad;
    actions.look_pitch_rad = pitch_rad;
    return actions;
}

TEST(Viewer, TurnsAboutTheModelOnlyWhileItIsDragged) {
    Playground play(stage(1));
    EXPECT_EQ(play.game->mode(), MoveMode::Orbit);
    EXPECT_TRUE(play.game->frees_pointer());
    play.step(look(0.5F, 0.2F));
    EXPECT_NEAR(glm::distance(eye(play), Vec3(0, 0, 2)), 0, 1e-5) << "a free pointer turns nothing";
    // A quarter turn: four times the angle that looking around would give.
    play.step(drag(Action::TurnModel, static_cast<float>(kPi) / 8, 0));
    EXPECT_NEAR(glm::distance(eye(play), Vec3(2, 0, 0)), 0, 1e-4);
    EXPECT_EQ(play.thing_count(), 0U) << "nothing was thrown";
}

TEST(Viewer, AClickThrowsNothingUntilTheModeIsChanged) {  // FAULTS 26
    Playground play(stage(1));
    play.step(press({Action::Throw}));
    play.step({});
    EXPECT_EQ(play.thing_count(), 0U);
}

TEST(Viewer, ShiftsTheModelAcrossTheImage) {
    Playground play(stage(1));
    const Vec3 before = eye(play);
    play.step(drag(Action::ShiftModel, 0.1F, 0));
    // By the angle times the distance of 2 m.
    EXPECT_NEAR(glm::distance(eye(play), before + Vec3(0.2, 0, 0)), 0, 1e-5);
}

TEST(Viewer, ZoomsByShareWhateverTheSize) {
    for (const Real radius_m : {0.0005_r, 5000.0_r}) {
        Playground play(stage(radius_m));
        play.step(press({Action::Push}));
        EXPECT_NEAR(glm::length(eye(play)) / radius_m, 2 * 0.88, 1e-3) << radius_m;
        for (int i = 0; i < 200; ++i) play.step(press({Action::Push}));
        EXPECT_NEAR(glm::length(eye(play)) / radius_m, 0.02, 1e-3) << "and no nearer";
    }
}

TEST(Viewer, FliesAsFastAndAsLowAsSuitsTheModel) {
    for (const Real radius_m : {0.002_r, 1.0_r, 400.0_r}) {
        scene::SceneDescription scene = stage(radius_m);
        const Vec3 size = Vec3{20, 1, 20} * radius_m;
        scene.entities = {block("ground", size, {0, -1.5_r * radius_m, 0})};  // its top at y = -1
        Playground play(scene);
        while (play.game->mode() != MoveMode::Fly) play.step(press({Action::MoveMode}));
        const Real before = eye(play).z;
        play.run(1, hold({Action::Back}));
        EXPECT_NEAR((eye(play).z - before) / radius_m, 1 - 0.08, 0.03) << radius_m;
        if (radius_m < 1) continue;  // rays end a millimetre early
        play.run(3, hold({Action::Crouch}));
        EXPECT_NEAR(eye(play).y / radius_m, -1 + 0.005, 0.002) << radius_m;
    }
}

TEST(Viewer, SwitchesItsAids) {
    Playground play(stage(1));
    play.step(press({Action::Grid, Action::Ground, Action::Background}));
    EXPECT_TRUE(play.simulation->switches.grid);
    EXPECT_FALSE(play.simulation->switches.ground);
    EXPECT_EQ(play.simulation->switches.background, 1);
    EXPECT_EQ(play.messages(),
              (std::vector<std::string>{"grid on", "ground off", "next background"}));
    play.step(press({Action::Turntable}));
    play.run(1);
    EXPECT_NEAR(std::atan2(eye(play).x, eye(play).z), 0.5, 0.02) << "half a radian a second";
}

TEST(Viewer, ItsKeysSayElsewhereWhereTheyWork) {
    Playground play;
    play.step(press({Action::Ground, Action::Background}));
    EXPECT_EQ(play.messages(),
              (std::vector<std::string>{"ground: only available in the model viewer",
                                        "background: only available in the model viewer"}));
}

/// A JSON scene of that radius, looked at from (0, -3, 0) along +Y with +Z up.
scene::SceneDescription json_scene(Real radius_m) {
    scene::SceneDescription scene;
    scene.viewer = scene::ViewerDescription{
        .width_px = 4, .height_px = 3, .radius_m = radius_m, .up = {0, 0, 1}};
    scene.camera.position_m = {0, -3, 0};
    scene.camera.target_m = {0, -2, 0};
    scene.camera.up = {0, 0, 1};
    scene.sun = scene::SunDescription{.shadow = scene::ShadowDescription{}};
    return scene;
}

Quat view_turn(const Playground& play) {
    return play.game->view(*play.simulation, 1, 0, 0).world_from_camera.orientation;
}

// SOURCES C12: the original camera-to-world times R(yaw, pitch), whatever was turned before.
TEST(JsonViewer, TurnsTheFirstCameraByYawAndPitch) {
    Playground play(json_scene(1));
    const Quat first = view_turn(play);
    EXPECT_NEAR(glm::distance(first * Vec3(0, 0, -1), Vec3(0, 1, 0)), 0, 1e-6);
    EXPECT_NEAR(glm::distance(first * Vec3(0, 1, 0), Vec3(0, 0, 1)), 0, 1e-6);
    play.step(look(0.4F, 0.3F));
    play.step(look(-0.7F, 0.2F));
    const Quat wanted =
        first * glm::angleAxis(-0.3_r, Vec3(0, 1, 0)) * glm::angleAxis(0.5_r, Vec3(1, 0, 0));
    EXPECT_NEAR(std::abs(glm::dot(view_turn(play), wanted)), 1, 1e-6);
    play.step(look(0.3F, -0.5F));
    EXPECT_NEAR(std::abs(glm::dot(view_turn(play), first)), 1, 1e-6) << "nothing was accumulated";
}

// SOURCES C11: along the camera's columns; up is the scene's own; as fast as the scene is large.
TEST(JsonViewer, FliesAlongItsOwnAxesAtASpeedThatSuitsTheScene) {
    for (const Real radius_m : {0.1_r, 300.0_r}) {
        const auto way = [&](Action action) {
            Playground play(json_scene(radius_m));
            const Vec3 before = eye(play);
            for (int i = 0; i < 120; ++i) play.step(hold({action}));
            return (eye(play) - before) / radius_m;
        };
        // One radius a second, but for the start.
        EXPECT_NEAR(way(Action::Forward).y, 1.92, 0.01) << radius_m;
        EXPECT_NEAR(way(Action::Right).x, 1.92, 0.01) << radius_m;
        EXPECT_NEAR(way(Action::Jump).z, 1.92, 0.01) << radius_m;
    }
}

TEST(JsonViewer, IsOnlyLookedAtAndNeverWalked) {
    Playground play(json_scene(1));
    play.step(press({Action::Drop, Action::Throw}));
    play.step({});
    EXPECT_EQ(play.thing_count(), 0U);
    EXPECT_TRUE(play.game->hud(*play.simulation).chosen_thing.empty()) << "nothing to drop here";
    EXPECT_EQ(play.game->mode(), MoveMode::Fly);
    const Vec3 before = eye(play);
    play.step(press({Action::MoveMode}));
    EXPECT_EQ(play.game->mode(), MoveMode::Orbit);
    EXPECT_NEAR(glm::distance(eye(play), before), 0, 1e-5);
    play.step(press({Action::MoveMode}));
    EXPECT_EQ(play.game->mode(), MoveMode::Fly);
    EXPECT_NEAR(glm::distance(eye(play), before), 0, 1e-5);
}

// SOURCES C17 C18 C22: textures, light and shadow are there when asked for.
TEST(JsonViewer, TexturesLightAndShadowAreSwitched) {
    Playground play(json_scene(1));
    const scene::LiveSwitches& switches = play.simulation->switches;
    EXPECT_FALSE(switches.textures);
    EXPECT_FALSE(switches.shading.has_value());
    play.step(press({Action::Shading, Action::Textures, Action::SunShadow}));
    EXPECT_TRUE(switches.textures);
    EXPECT_EQ(switches.shading, assets::Shading::BlinnPhong);
    EXPECT_TRUE(switches.is_on("sun_shadow", false));
    play.step(press({Action::Shading, Action::Textures, Action::SunShadow}));
    EXPECT_FALSE(switches.textures);
    EXPECT_FALSE(switches.shading.has_value());
    EXPECT_FALSE(switches.is_on("sun_shadow", true));
}

// SOURCES C20: the light turns about the scene's up.
TEST(JsonViewer, TheLightTurnsAboutTheScenesUp) {
    Playground play(json_scene(1));
    const Vec3f before = play.simulation->switches.sun_direction;
    play.step(press({Action::SunFaster}));
    for (int i = 0; i < 60; ++i) play.step({});
    const Vec3f after = play.simulation->switches.sun_direction;
    EXPECT_NEAR(after.z, before.z, 1e-5F);
    EXPECT_GT(glm::distance(after, before), 0.01F);
}

}  // namespace
}  // namespace plumbline::game
