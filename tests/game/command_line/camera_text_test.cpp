// Views by word, by place and by scene.
#include "game/command_line/camera_text.h"

#include "tests/support/near.h"

#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

using test::near;

Vec3 ahead(const scene::ViewPoint& view) {
    return view.world_from_camera.orientation * Vec3{0, 0, -1};
}

TEST(CameraText, IsAPlaceAndTwoAnglesInDegrees) {
    const auto view = parse_camera("1,2.5,-3,90,-30", 1.25_r);
    ASSERT_TRUE(view.has_value());
    EXPECT_EQ(view->world_from_camera.position, Vec3(1, 2.5, -3));
    EXPECT_EQ(view->fov_y_rad, 1.25_r);
    // Turned left by a quarter it looks down -X; 30 degrees below the horizon.
    EXPECT_TRUE(near(ahead(*view), Vec3(-std::sqrt(0.75_r), -0.5_r, 0), 1e-6));
    EXPECT_TRUE(parse_camera(" 0, 0, 0, 0, 0", 1).has_value()) << "blanks may stand before numbers";
}

TEST(CameraText, AnythingElseIsNoView) {
    for (const char* text : {"",
                             "1,2,3,4",
                             "1,2,3,4,5,6",
                             "1,2,3,4,5,",
                             "1,2,3,4,5 ",
                             "1;2;3;4;5",
                             "1,2,3,4,x",
                             "1,2,3,4,nan",
                             "1,2,3,4,1e999",
                             "1 2 3 4 5"})
        EXPECT_FALSE(parse_camera(text, 1).has_value()) << text;
}

TEST(CameraText, LooksFromAnEyeAtATargetOrStraightOnWhereTheyAreOne) {
    const scene::ViewPoint view = view_from({0, 1, 0}, {3, 1, 0}, 1);
    EXPECT_TRUE(near(ahead(view), Vec3(1, 0, 0), 1e-6));
    EXPECT_TRUE(near(ahead(view_from({0, 0, 0}, {0, 5, 0}, 1)), Vec3(0, 1, 0), 1e-3));
    EXPECT_TRUE(near(ahead(view_from({1, 2, 3}, {1, 2, 3}, 1)), Vec3(0, 0, -1), 1e-6));
    // The hand is a little to the right of, below and before the eye.
    EXPECT_TRUE(near(view.world_from_hand.position, Vec3(0.2, 0.7, 0.25), 1e-5));
    const Pose pose{.position = {1, 2, 3}, .orientation = {0, 1, 0, 0}};
    EXPECT_EQ(view_at(pose, 1).world_from_camera.orientation, pose.orientation);
}

TEST(CameraText, TheFirstViewIsTheCamerasElseThePlayers) {
    scene::SceneDescription scene;
    scene.camera.position_m = {0, 1, 5};
    scene.camera.target_m = {0, 1, 0};
    scene.camera.fov_y_rad = 0.5_r;
    EXPECT_EQ(first_view(scene).world_from_camera.position, Vec3(0, 1, 5)) << "nobody plays";
    scene.player.emplace();
    scene.player->feet_position_m = {7, 0, 0};
    scene.player->yaw_rad = kPi / 2;
    const scene::ViewPoint eyes = first_view(scene);
    EXPECT_TRUE(near(eyes.world_from_camera.position, Vec3(7, 1.65, 0), 1e-6));
    EXPECT_TRUE(near(ahead(eyes), Vec3(-1, 0, 0), 1e-6));
    EXPECT_NEAR(eyes.fov_y_rad, radians_from_degrees(70.0), 1e-6);
    scene.has_camera = true;
    EXPECT_EQ(first_view(scene).fov_y_rad, 0.5_r) << "a camera of its own goes before";
    scene.viewer.emplace();
    scene.camera.up = {0, 0, 1};
    scene.camera.position_m = {0, -5, 0};
    scene.camera.target_m = {0, 0, 0};
    EXPECT_TRUE(
        near(first_view(scene).world_from_camera.orientation * Vec3{0, 1, 0}, Vec3(0, 0, 1), 1e-6))
        << "with the scene's own up";
}

}  // namespace
}  // namespace plumbline::game
