// Cameras that are not a person stay above the ground.
#include "game/rules/camera_rig.h"

#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

Vec3 eye_of(const Playground& play) {
    return play.game->view(*play.simulation, 1, 0.0F, 0.0F).world_from_camera.position;
}

TEST(CameraRig, FlyingEndsAHandAboveTheGround) {
    Playground play;
    play.step(press({Action::MoveMode}));
    ASSERT_EQ(play.game->mode(), MoveMode::Fly);
    for (int i = 0; i < 300; ++i) {
        play.step(hold({Action::Crouch, Action::Forward}));
        ASSERT_GT(eye_of(play).y, 0.12_r) << "step " << i;
    }
    EXPECT_NEAR(eye_of(play).y, 0.14, 0.02);
    // What stops the fall does not stop the way: 5 m/s, shared between down and forward.
    EXPECT_LT(eye_of(play).z, -Real{5} * 5 * std::sqrt(0.5_r) + 1);
    play.run(1, hold({Action::Jump}));
    EXPECT_NEAR(eye_of(play).y, 0.14 + 5 * (1 - 0.08), 0.1) << "and up again at once";
}

TEST(CameraRig, FlyingFastStopsAtTheGroundToo) {
    Playground play;
    play.step(press({Action::MoveMode}));
    for (int i = 0; i < 20; ++i) play.step(press({Action::Push}));  // 200 m/s, 600 in a sprint
    play.run(1, hold({Action::Jump, Action::Sprint}));
    ASSERT_GT(eye_of(play).y, 300);
    play.run(4, hold({Action::Crouch, Action::Sprint}));
    EXPECT_NEAR(eye_of(play).y, 0.14, 0.02);
}

TEST(CameraRig, FliesThroughARoofButNotThroughTheFloor) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("roof", {6, 0.2_r, 6}, {0, 4, 0}));
    Playground play(scene);
    play.step(press({Action::MoveMode}));
    play.run(2, hold({Action::Jump}));
    ASSERT_GT(eye_of(play).y, 8);
    play.run(2, hold({Action::Crouch}));
    EXPECT_LT(eye_of(play).y, 4);
    play.run(3, hold({Action::Crouch}));
    EXPECT_NEAR(eye_of(play).y, 0.14, 0.02);
}

TEST(CameraRig, BeyondTheEdgeOfTheWorldItMayGoDown) {
    scene::SceneDescription scene = meadow();
    scene.player.reset();
    scene.camera.position_m = {110, 3, 0};  // the ground ends at 100 m
    scene.camera.target_m = {110, 3, -1};
    Playground play(scene);
    play.run(2, hold({Action::Crouch}));
    EXPECT_NEAR(eye_of(play).y, 3 - 5 * (2 - 0.08), 0.1);
}

TEST(CameraRig, OrbitingTurnsNoLowerThanTheGround) {
    Playground play;
    play.step(press({Action::MoveMode}));
    play.step(look(0.0F, -0.5F));
    play.step(press({Action::MoveMode}));
    ASSERT_EQ(play.game->mode(), MoveMode::Orbit);
    const Real distance = eye_of(play).y / std::sin(0.5_r);
    const Vec3 target{0, 0, -distance * std::cos(0.5_r)};
    for (int i = 0; i < 60; ++i) {
        play.step(look(0.02F, 0.05F));  // three radians up: it would look from straight below
        ASSERT_GT(eye_of(play).y, 0.05_r) << "step " << i;
        ASSERT_NEAR(glm::distance(eye_of(play), target), distance, 0.01);
    }
    EXPECT_LT(eye_of(play).y, 0.15_r) << "it lies on the ground and looks along it";
    play.run(2, hold({Action::Back}));  // by the keys as well
    EXPECT_GT(eye_of(play).y, 0.05_r);
    play.run(1, hold({Action::Forward}));
    EXPECT_GT(eye_of(play).y, 1) << "and up again";
}

TEST(CameraRig, ZoomingOutOfAViewFromBelowStopsAtTheGround) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("kite", {2, 2, 2}, {0, 8, -8}));
    Playground play(scene);
    play.step(press({Action::MoveMode}));
    play.step(look(0.0F, 0.65F));
    play.step(press({Action::MoveMode}));
    const Vec3 before = eye_of(play);
    ASSERT_GT(before.y, 1);
    play.run(5, hold({Action::ZoomOut}));
    EXPECT_GT(eye_of(play).y, 0.05_r);
    EXPECT_LT(eye_of(play).y, 0.2_r) << "as far as it goes";
    EXPECT_GT(eye_of(play).z, before.z);
}

}  // namespace
}  // namespace plumbline::game
