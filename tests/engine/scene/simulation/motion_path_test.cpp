#include "engine/scene/simulation.h"
#include "tests/support/near.h"

#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

using test::near;

TEST(MotionPath, RestsAtItsPointsAndComesBack) {
    const MotionPath lift{.points_m = {{0, 1, 0}, {0, 3, 0}}, .period_s = 4};
    const auto height = [&](double time_s) {
        return static_cast<double>(pose_on_path(lift, time_s).position.y);
    };
    EXPECT_NEAR(height(0.0), 1.0, 1e-6);
    EXPECT_NEAR(height(1.0), 2.0, 1e-6);
    EXPECT_NEAR(height(2.0), 3.0, 1e-6);
    EXPECT_NEAR(height(3.0), 2.0, 1e-6);
    EXPECT_NEAR(height(4.0), 1.0, 1e-6);
    // At rest at the top: near it, the cosine falls as half the square of its angle.
    const double angle = glm::pi<double>() * 0.01 / 2.0;
    EXPECT_NEAR(height(2.01), 3.0 - 2.0 * angle * angle / 4.0, 1e-6);
}

TEST(MotionPath, SharesItsTimeByTheWay) {
    const MotionPath path{.points_m = {{0, 0, 0}, {1, 0, 0}, {1, 3, 0}}, .period_s = 8};
    EXPECT_TRUE(near(pose_on_path(path, 1.0).position, Vec3{1, 0, 0}, 1e-5));
    EXPECT_TRUE(near(pose_on_path(path, 4.0).position, Vec3{1, 3, 0}, 1e-5));
    EXPECT_TRUE(near(pose_on_path(path, 7.0).position, Vec3{1, 0, 0}, 1e-5));
}

TEST(MotionPath, TurnsAboutItsAxis) {
    const MotionPath wheel{.spin_radps = {0, 2, 0}, .start = {.position = {1, 2, 3}}};
    const Pose pose = pose_on_path(wheel, 0.25);
    EXPECT_TRUE(near(pose.position, Vec3{1, 2, 3}, 1e-6));
    EXPECT_TRUE(near(pose.orientation, glm::angleAxis(0.5_r, Vec3{0, 1, 0}), 1e-5));
}

}  // namespace
}  // namespace plumbline::scene
