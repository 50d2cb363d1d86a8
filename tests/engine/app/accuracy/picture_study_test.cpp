#include "engine/app/accuracy/picture_study.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace plumbline::app {
namespace {

TEST(PictureStudy, TheCameraIsWrittenAsTheCommandLineReadsIt) {
    const Quat left = glm::angleAxis(glm::radians(Real{90}), Vec3{0, 1, 0});
    const Quat up = glm::angleAxis(glm::radians(Real{30}), Vec3{1, 0, 0});
    EXPECT_EQ(camera_option({{1, 2, -3}, left * up}), "1.0000,2.0000,-3.0000,90.000,30.000");
}

// The program is not beside the tests.
TEST(PictureStudy, SaysWhyItCameToNothing) {
    PictureStudy picture;
    EXPECT_FALSE(picture.runs());
    picture.start("scene.toml", Pose{});
    for (int i = 0; i < 1000 && picture.runs(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        picture.take_answers();
    }
    EXPECT_FALSE(picture.runs());
    EXPECT_FALSE(picture.failure().empty());
    EXPECT_TRUE(picture.rows().empty());
}

}  // namespace
}  // namespace plumbline::app
