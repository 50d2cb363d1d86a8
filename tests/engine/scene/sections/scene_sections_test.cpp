// [world], [player], [camera] and the views.
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <cmath>

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, WorldPlayerCameraAndViews) {
    const Outcome outcome = load(R"([scene]
title = "T"
description = "D"
[world]
gravity_mps2 = [1, -2.5, 3]
kill_below_m = -100
[player]
position_m = [1, 2, 3]
yaw_deg = 90
pitch_deg = -30
[camera]
position_m = [4, 5, 6]
target_m = [0, 1, 0]
fov_deg = 60
near_m = 0.1
far_m = 250
clear_color = [0.1, 0.2, 0.3]
[[view]]
name = "gate"
position_m = [1, 1, 1]
target_m = [0, 0, 0]
wait_s = 2.5
flashlight = true
light_scale = 0.25
[[entity]]
primitive = { plane = [9, 9] }
body = { kind = "static" }
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.title, "T");
    EXPECT_EQ(scene.description, "D");
    expect_near(scene.gravity_mps2, {1, -2.5_r, 3});
    EXPECT_EQ(scene.kill_below_m, Real{-100});
    ASSERT_TRUE(scene.player);
    expect_near(scene.player->feet_position_m, {1, 2, 3});
    EXPECT_NEAR(scene.player->yaw_rad, kPi / 2, kSlack);
    EXPECT_NEAR(scene.player->pitch_rad, -kPi / 6, kSlack);
    EXPECT_EQ(to_string(scene.player->location), "scene.toml:7");
    EXPECT_TRUE(scene.has_camera);
    expect_near(scene.camera.position_m, {4, 5, 6});
    expect_near(scene.camera.target_m, {0, 1, 0});
    EXPECT_NEAR(scene.camera.fov_y_rad, kPi / 3, kSlack);
    EXPECT_NEAR(scene.camera.near_m, 0.1_r, kSlack);
    EXPECT_NEAR(scene.camera.far_m, Real{250}, kSlack);
    expect_near_f(scene.camera.clear_color, {0.1F, 0.2F, 0.3F});
    ASSERT_EQ(scene.views.size(), 1U);
    EXPECT_EQ(scene.views[0].name, "gate");
    EXPECT_NEAR(scene.views[0].wait_s, 2.5_r, kSlack);
    EXPECT_TRUE(scene.views[0].flashlight);
    EXPECT_FLOAT_EQ(scene.views[0].light_scale, 0.25F);
}

TEST_F(SceneFileTest, StrongGravityIsClamped) {
    const Outcome outcome = load("[world]\ngravity_mps2 = [3e6, 4e6, 0]");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_NEAR(outcome.scene->gravity_mps2.x, Real{600}, 0.01_r);
    EXPECT_NEAR(outcome.scene->gravity_mps2.y, Real{800}, 0.01_r);
}

// SOURCES A8, A26: distance 15, pitch 20 and yaw 0 stand on the side of -Z, above.
TEST_F(SceneFileTest, OrbitPlacesTheCamera) {
    const SceneDescription scene = good(
        "[camera]\ntarget_m = [1, 2, 3]\n"
        "orbit = { distance_m = 15, pitch_deg = 20, yaw_deg = 0, step_deg = 5, step_m = 5 }\n");
    const Real pitch = radians_from_degrees(20.0_r);
    EXPECT_TRUE(scene.has_camera);
    EXPECT_NEAR(scene.camera.position_m.x, 1, 1e-5);
    EXPECT_NEAR(scene.camera.position_m.y, 2 + 15 * std::sin(pitch), 1e-5);
    EXPECT_NEAR(scene.camera.position_m.z, 3 - 15 * std::cos(pitch), 1e-5);
    ASSERT_TRUE(scene.camera.orbit.has_value());
    EXPECT_NEAR(scene.camera.orbit->step_rad, radians_from_degrees(5.0_r), kSlack);
    EXPECT_NEAR(scene.camera.orbit->step_m, 5, kSlack);
}

TEST_F(SceneFileTest, WhatOrbitLeavesOpenIsAsThePositionSays) {
    const SceneDescription steps =
        good("[camera]\nposition_m = [10, 5, 0]\ntarget_m = [0, 0, 0]\norbit = { step_deg = 1 }\n");
    expect_near(steps.camera.position_m, {10, 5, 0});
    const SceneDescription nearer = good(
        "[camera]\nposition_m = [10, 5, 0]\ntarget_m = [0, 0, 0]\norbit = { distance_m = 1 }\n");
    const Vec3 wanted = glm::normalize(Vec3{10, 5, 0});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(nearer.camera.position_m[i], wanted[i], 1e-5);
    // About an up of its own: yaw is about it, pitch towards it.
    const SceneDescription tilted = good(
        "[camera]\ntarget_m = [0, 0, 0]\nup = [0, 0, 2]\n"
        "orbit = { distance_m = 2, pitch_deg = 30, yaw_deg = 0 }\n");
    EXPECT_NEAR(tilted.camera.position_m.z, 1, 1e-5);
    expect_near(tilted.camera.up, {0, 0, 1});
}

TEST_F(SceneFileTest, ACameraThatCannotStandSoIsRefused) {
    expect_only(
        "[camera]\nup = [0, 0, 0]\n",
        "2:6: error: camera.up: [0, 0, 0] has no direction; expected a vector of some length");
    expect_only("[camera]\nposition_m = [0, 5, 0]\ntarget_m = [0, 0, 0]\nup = [0, 1, 0]\n",
                "4:6: error: camera.up: lies along the line of sight; expected another direction");
    expect_only("[camera]\norbit = { distance_m = 0 }\n",
                "2:24: error: camera.orbit.distance_m: 0; expected a length from 0.1 to 500 m");
    expect_only("[camera]\norbit = { step = 5 }\n",
                "2:11: error: camera.orbit.step: unknown key; did you mean \"step_deg\"?");
}

TEST_F(SceneFileTest, EffectsThatHaveSettingsAreListed) {
    const SceneDescription scene = good("[effects.fog]\n[effects.motion_blur]\n");
    EXPECT_TRUE(scene.effect_settings.contains("motion_blur"));
    EXPECT_FALSE(scene.effect_settings.contains("drag"));
}

TEST_F(SceneFileTest, OnlyAPlaceMakesACamera) {
    EXPECT_FALSE(good("[camera]\nclear_color = [1, 1, 1]\n").has_camera);
    EXPECT_TRUE(good("[camera]\nposition_m = [0, 0, 9]\n").has_camera);
    expect_only("[camera]\nnear_m = 2\nfar_m = 2\n",
                "2:10: error: camera.near_m: 2 m is not before far_m, 2 m");
}

TEST_F(SceneFileTest, WishesOfAccuracyThatExcludeEachOther) {
    expect_only("[accuracy]\ntolerance = 0.1\nbudget_ms = 1\n",
                "3:13: error: accuracy.budget_ms: is a second wish beside tolerance; expected one "
                "of the two");
    expect_only("[accuracy]\nsubsteps = 5\nsubsteps_max = 4\n",
                "3:16: error: accuracy.substeps_max: 4 is below substeps = 5; expected at least as "
                "many");
    EXPECT_TRUE(load("[accuracy]\nsubsteps = 4\nsubsteps_max = 4\n").faults.empty());
}

}  // namespace
}  // namespace plumbline::scene
