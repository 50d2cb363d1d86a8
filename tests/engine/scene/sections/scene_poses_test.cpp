#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, OrientationIsNormalised) {
    const Outcome outcome = load("[[entity]]\norientation = [0.7071, 0, 0.7071, 0]\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.faults.empty());
    const Quat turned = outcome.scene->entities[0].world_from_body.orientation;
    EXPECT_NEAR(glm::length(turned), Real{1}, kSlack);
    expect_near(turned * Vec3{1, 0, 0}, {0, 0, -1});
}

TEST_F(SceneFileTest, AnglesTurnInTheOrderOfTheirAxes) {
    const SceneDescription scene = good("[[entity]]\nrotation_deg = [90, 90, 0]\n");
    const Quat turn = scene.entities[0].world_from_body.orientation;
    const Quat wanted = quat_from_euler_deg(Vec3{90, 90, 0});
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        expect_near(turn * axis, wanted * axis);
}

TEST_F(SceneFileTest, QuaternionsThatAreNone) {
    const std::string key = "[[entity]]\norientation = ";
    expect_only(key + "[1, 0, 0]\n",
                "2:15: error: entity[0].orientation: an array of 3; expected [w, x, y, z], a "
                "quaternion of length 1");
    expect_only(key + "[1, 0, \"x\", 0]\n",
                "2:22: error: entity[0].orientation[2]: \"x\"; expected a finite number");
    expect_only(key + "[0, 0, 0, 0]\n",
                "2:15: error: entity[0].orientation: its length is 0; expected [w, x, y, z], a "
                "quaternion of length 1");
    EXPECT_TRUE(load(key + "[1.0099, 0, 0, 0]\n").faults.empty());
    expect_only(key + "[0, 0, 1.02, 0]\n",
                "2:15: warning: entity[0].orientation: its length is 1.02 instead of 1; it is "
                "normalised");
    expect_only("[[entity]]\nrotation_deg = [0, 0, 0]\norientation = [1, 0, 0, 0]\n",
                "3:15: error: entity[0].orientation: given beside rotation_deg; they say the same "
                "thing, keep one");
}

TEST_F(SceneFileTest, FarFromTheOriginIsWarnedOf) {
    EXPECT_TRUE(load("[[entity]]\nposition_m = [0, 0, -10000]\n").faults.empty());
    expect_only("[[entity]]\nposition_m = [0, 0, -10001]\n",
                "2:14: warning: entity[0].position_m: more than 10000 m from the origin: single "
                "precision resolves 1 mm there");
}

}  // namespace
}  // namespace plumbline::scene
