// A model by itself: turned, shifted, zoomed at any size; nothing is thrown.
#include "tests/game/playground.h"

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

TEST(Viewer, ShiftsTheModelAcrossThePicture) {
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
    play.step(press({Action::Turntable}));
    play.run(1);
    EXPECT_NEAR(std::atan2(eye(play).x, eye(play).z), 0.5, 0.02) << "half a radian a second";
}

}  // namespace
}  // namespace plumbline::game
