// SOURCES B24, B25: camera paths are kept, read, and gone along; what is wrong with a file is named.
#include "engine/scene/camera_path.h"

#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plumbline::scene {
namespace {

Pose turned(const Vec3& position_m, Real yaw_rad) {
    return {.position = position_m, .orientation = glm::angleAxis(yaw_rad, Vec3{0, 1, 0})};
}

std::string fault_of(std::string_view text) {
    const auto path = CameraPath::parse(text, "p");
    return path ? fmt::format("read, {} poses", path->size()) : path.error().message;
}

TEST(CameraPath, GoesStraightAtSteadySpeedWhateverTheFramesWere) {
    CameraPath path;
    const Vec3 start{1, 2, 3};
    const Vec3 velocity{2, 0, -1};
    for (const double t : {0.0, 0.1, 0.13, 0.5, 1.7, 2.0})
        ASSERT_TRUE(path.add(t, turned(start + velocity * static_cast<Real>(t), 0)));
    for (double t = 0; t <= 2.0; t += 0.01) {
        const Vec3 wanted = start + velocity * static_cast<Real>(t);
        EXPECT_NEAR(glm::distance(path.at(t).position, wanted), 0, 1e-5) << t;
    }
    EXPECT_EQ(path.at(-1).position, start);
    EXPECT_NEAR(glm::distance(path.at(9).position, start + velocity * Real{2}), 0, 1e-6);
    EXPECT_EQ(path.length_s(), 2.0);
}

// Sixteen poses on a circle: cubics through them with central slopes leave it by less than
// (pi / 8)^4 / 16 of the radius, where straight lines would leave it by 1 - cos(pi / 16) = 1.9 %.
TEST(CameraPath, IsRoundWhereTheWayWas) {
    CameraPath path;
    constexpr int kPoses = 32;
    const auto at = [](double t) {
        const auto angle = static_cast<Real>(t) * kPi / 8;
        return turned(Vec3{std::sin(angle), 0, std::cos(angle)} * Real{5}, angle);
    };
    for (int i = 0; i <= kPoses; ++i) ASSERT_TRUE(path.add(i, at(i)));
    for (double t = 1; t <= kPoses - 1; t += 0.125) {
        EXPECT_NEAR(glm::length(path.at(t).position), 5, 5 * 0.0015) << t;
        const Quat turn = path.at(t).orientation * glm::conjugate(at(t).orientation);
        EXPECT_NEAR(std::abs(turn.w), 1, 1e-5) << "looks at the middle at " << t;
        EXPECT_NEAR(glm::length(path.at(t).orientation), 1, 1e-6);
    }
}

TEST(CameraPath, PassesThroughEveryPose) {
    CameraPath path;
    const std::vector<Vec3> places{{0, 0, 0}, {1, 5, 0}, {-3, 2, 2}, {0, 0, 9}};
    for (std::size_t i = 0; i < places.size(); ++i)
        ASSERT_TRUE(
            path.add(0.25 * static_cast<double>(i), turned(places[i], static_cast<Real>(i))));
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_NEAR(
            glm::distance(path.at(0.25 * static_cast<double>(i)).position, places[i]), 0, 1e-6);
    EXPECT_FALSE(path.add(0.75, turned({}, 0))) << "not after the last one";
}

TEST(CameraPath, WhatIsWrittenIsReadAgain) {
    CameraPath path;
    for (int i = 0; i < 50; ++i)
        ASSERT_TRUE(path.add(
            i / 60.0,
            turned({0.1_r * static_cast<Real>(i), 1.7_r, -20.23_r}, 0.1_r * static_cast<Real>(i))));
    const auto again = CameraPath::parse(path.text(), "p");
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(again->size(), 50U);
    for (double t = 0; t < 0.9; t += 0.07) {
        EXPECT_NEAR(glm::distance(again->at(t).position, path.at(t).position), 0, 1e-5);
        EXPECT_NEAR(std::abs(glm::dot(again->at(t).orientation, path.at(t).orientation)), 1, 1e-6);
    }
}

// One line a frame: the direction, then the position.
TEST(CameraPath, ReadsTheReportsOwnFiles) {
    const auto path = CameraPath::parse(
        "0 0 -1 9.81 3.01 -20.23\r\n1 0 0 9.81 3.01 -20.25\n-2 0 0 9.81 3.01 -20.27", "p");
    ASSERT_TRUE(path.ok()) << path.error().message;
    EXPECT_EQ(path->size(), 3U);
    EXPECT_NEAR(path->length_s(), 2 / 60.0, 1e-9);
    EXPECT_NEAR(glm::distance(path->at(0).position, {9.81_r, 3.01_r, -20.23_r}), 0, 1e-6);
    EXPECT_NEAR(glm::distance(path->at(1 / 60.0).orientation * Vec3{0, 0, -1}, {1, 0, 0}), 0, 1e-5);
    EXPECT_NEAR(glm::distance(path->at(1).orientation * Vec3{0, 0, -1}, {-1, 0, 0}), 0, 1e-5);
}

TEST(CameraPath, NamesTheLineThatIsWrong) {
    const std::string head = "plumbline camera path 1\n# a comment\n\n0 1 2 3 1 0 0 0\n";
    EXPECT_EQ(fault_of(head), "read, 1 poses");
    EXPECT_EQ(fault_of(""), "p: holds no pose");
    EXPECT_EQ(fault_of("plumbline camera path 1\n"), "p: holds no pose");
    EXPECT_EQ(fault_of("plumbline camera path 2\n0 1 2 3 1 0 0 0\n"),
              "p:1: is version 2 of camera paths; this program reads 1");
    EXPECT_EQ(fault_of(head + "1 1 2 3 1 0\n"),
              "p:5: 6 numbers; expected 8 numbers: time_s x y z qw qx qy qz");
    EXPECT_EQ(fault_of(head + "1 1 2 3 1 0 0 0"), "p:5: breaks off in the middle of the line");
    EXPECT_EQ(fault_of(head + "1 1 nan 3 1 0 0 0\n"),
              "p:5: \"1 1 nan 3 1 0 0 0\"; expected 8 numbers: time_s x y z qw qx qy qz");
    EXPECT_EQ(fault_of(head + "1 1 1e9999 3 1 0 0 0\n"),
              "p:5: \"1 1 1e9999 3 1 0 0 0\"; expected 8 numbers: time_s x y z qw qx qy qz");
    EXPECT_EQ(fault_of(head + "0 1 2 3 1 0 0 0\n"), "p:5: 0 s is not after the line before");
    EXPECT_EQ(fault_of(head + "-1 1 2 3 1 0 0 0\n"),
              "p:5: -1 s; expected a time from 0 to 1000000 s");
    EXPECT_EQ(fault_of(head + "1 1 2 3 0 0 0 0\n"), "p:5: an orientation of length 0");
    EXPECT_EQ(fault_of(head + "1 1 2e6 3 1 0 0 0\n"), "p:5: a position beyond 100000 m");
    EXPECT_EQ(fault_of("0 0 -1 1 2 3\n0 0 -1 1 2\n"),
              "p:2: 5 numbers; expected 6 numbers: a direction and a position");
    EXPECT_EQ(fault_of("0 0 0 1 2 3\n"), "p:1: a direction of length 0");
    EXPECT_EQ(fault_of("hello\x1b[2J\n"),
              "p:1: \"hello\\x1b[2J\"; expected 6 numbers: a direction and a position");
}

TEST(CameraPath, AMillionLinesAreReadAndOneMoreIsNamed) {
    std::string text;
    for (std::size_t i = 0; i < CameraPath::kMostPoses; ++i) text += "0 0 -1 1 2 3\n";
    EXPECT_EQ(fault_of(text), "read, 1000000 poses");
    EXPECT_EQ(fault_of(text + "0 0 -1 1 2 3\n"),
              "p:1000001: one pose too many: at most 1000000 are read");
}

TEST(CameraPath, CutAtEveryLengthItIsReadOrNamed) {
    CameraPath path;
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(path.add(i, turned({0, 1, static_cast<Real>(i)}, 0)));
    const std::string whole = path.text();
    const std::size_t poses = whole.find("\n0.000000") + 1;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const std::string said = fault_of(whole.substr(0, length));
        const bool ends_with_line = length > poses && whole[length - 1] == '\n';
        EXPECT_EQ(said.starts_with("read"), ends_with_line) << length << ": " << said;
    }
}

TEST(CameraPath, AFileThatIsNotThereIsNamed) {
    const test::TemporaryFolder folder;
    const auto missing = CameraPath::read(folder / "none.path");
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().message.find("none.path"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
