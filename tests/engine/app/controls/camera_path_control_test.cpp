// SOURCES B24, B25: what the camera path's keys do, frame by frame.
#include "engine/app/controls/camera_path_control.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plumbline::app {
namespace {

/// Keys, frames of 1/60 s, and a camera that goes along x at 1 m/s.
class CameraPaths : public testing::Test {
protected:
    test::TemporaryFolder folder_;
    std::vector<std::string> said_;
    input::ActionLatch latch_{input::built_in_bindings()};
    double now_s_{100};
    std::filesystem::path file() const { return folder_ / "meadow.path"; }
    CameraPathControl control_{{.folder = folder_.path(), .scene = "meadow"},
                               [this](std::string line) { said_.push_back(std::move(line)); }};

    /// GLFW's numbers: 295 is F6.
    scene::ViewPoint frame(int key = 0, bool held = false) {
        InputSnapshot input;
        input.now_s = now_s_;
        if (key != 0) {
            input.events.push_back({.code = key, .pressed = true});
            input.events.push_back({.code = key, .pressed = false});
        }
        latch_.update(input, {});
        control_.apply(latch_, now_s_);
        scene::ViewPoint view;
        view.world_from_camera.position = {static_cast<Real>(now_s_ - 100), 0, 0};
        view.world_from_hand.position = view.world_from_camera.position + Vec3{0.25_r, 0, 0};
        const scene::ViewPoint seen = control_.see(view, now_s_, held);
        now_s_ += 1.0 / 60;
        return seen;
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) frame();
    }
    static constexpr int kRecord = 295;
    static constexpr int kPlay = 296;
    static constexpr int kReload = 297;
};

TEST_F(CameraPaths, WhatIsRecordedPlaysAtTheSameSpeed) {
    frames(10);
    const Real from = frame(kRecord).world_from_camera.position.x;
    EXPECT_TRUE(control_.recording());
    frames(120);
    EXPECT_EQ(control_.status(), "recording camera path: 2.0 s");
    frame(kRecord);
    EXPECT_FALSE(control_.recording());
    EXPECT_EQ(said_.back(), "camera path saved (2.0 s): " + file().string());
    frames(300);
    EXPECT_NEAR(frame(kPlay).world_from_camera.position.x, from, 1e-4);
    for (int i = 1; i <= 60; ++i) {
        const scene::ViewPoint seen = frame();
        EXPECT_NEAR(seen.world_from_camera.position.x, from + static_cast<Real>(i) / 60, 1e-4);
        EXPECT_NEAR(
            seen.world_from_hand.position.x - seen.world_from_camera.position.x, 0.25, 1e-4);
    }
    EXPECT_EQ(control_.status(), "playing camera path: 1.0 / 2.0 s");
    frames(62);
    EXPECT_FALSE(control_.playing()) << "it ends by itself";
    const double here_m = now_s_ - 100;
    EXPECT_NEAR(frame().world_from_camera.position.x, here_m, 1e-3);
}

TEST_F(CameraPaths, TheMenuHoldsItAndWalkingEndsIt) {
    frame(kRecord);
    frames(60);
    frame(kRecord);
    const Real first = frame(kPlay).world_from_camera.position.x;
    for (int i = 0; i < 50; ++i) frame(0, true);
    EXPECT_LT(frame().world_from_camera.position.x - first, 0.04);
    EXPECT_TRUE(control_.playing());
    frame('W');
    EXPECT_FALSE(control_.playing());
}

TEST_F(CameraPaths, RecordingAgainKeepsTheOneBefore) {
    for (const int length : {30, 60}) {
        frame(kRecord);
        frames(length);
        frame(kRecord);
    }
    EXPECT_NEAR(control_.path().length_s(), 1, 0.02);
    EXPECT_NEAR(scene::CameraPath::read(file())->length_s(), 1, 0.02);
    int others = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
        if (entry.path() == file()) continue;
        ++others;
        EXPECT_NEAR(scene::CameraPath::read(entry.path())->length_s(), 0.5, 0.02);
    }
    EXPECT_EQ(others, 1);
}

TEST_F(CameraPaths, ABadFileIsNamedAndThePathInUseStays) {
    frame(kRecord);
    frames(60);
    frame(kRecord);
    frame(kPlay);
    folder_.write("meadow.path", "plumbline camera path 1\n0 1 2\n");
    frame(kReload);
    EXPECT_TRUE(control_.playing());
    EXPECT_EQ(said_.back(),
              file().string() + ":2: 3 numbers; expected 8 numbers: time_s x y z qw qx qy qz");
    EXPECT_NEAR(control_.path().length_s(), 1, 0.02);
    folder_.write("meadow.path", "0 0 -1 7 0 0\n0 0 -1 7 0 1\n");
    frame(kReload);
    EXPECT_FALSE(control_.playing()) << "the next press plays the new one, from its start";
    EXPECT_EQ(frame(kPlay).world_from_camera.position.x, 7) << "the file was read again";
}

TEST_F(CameraPaths, WithoutAPathItSaysHowToGetOne) {
    frame(kPlay);
    EXPECT_FALSE(control_.playing());
    EXPECT_EQ(said_.back().find("this scene has no camera path yet"), 0U);
    frame(kRecord);
    frame(kRecord);
    EXPECT_EQ(said_.back(), "empty camera path: nothing was recorded");
    EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(CameraPaths, WhatIsRecordedIsSavedAtTheEnd) {
    frame(kRecord);
    frames(30);
    control_.end_recording();
    EXPECT_TRUE(scene::CameraPath::read(file()).ok());
}

TEST_F(CameraPaths, AFolderThatCannotBeWrittenIsNamed) {
    const auto blocked = folder_.write("file", "x");
    CameraPathControl control({.folder = blocked, .scene = "meadow"},
                              [this](std::string line) { said_.push_back(std::move(line)); });
    for (const int key : {kRecord, 0, 0, kRecord}) {
        InputSnapshot input;
        input.now_s = now_s_ += 0.1;
        if (key != 0) {
            input.events.push_back({.code = key, .pressed = true});
            input.events.push_back({.code = key, .pressed = false});
        }
        latch_.update(input, {});
        control.apply(latch_, now_s_);
        control.see({}, now_s_, false);
    }
    EXPECT_NE(said_.back().find(blocked.string()), std::string::npos) << said_.back();
    EXPECT_EQ(control.path().size(), 3U) << "it plays all the same";
}

}  // namespace
}  // namespace plumbline::app
