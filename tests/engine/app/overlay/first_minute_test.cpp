#include "engine/app/overlay/first_minute.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace plumbline::app {
namespace {
namespace fs = std::filesystem;

constexpr HintScene kHintScene{.has_flashlight = true};

class FirstMinuteTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name();
        fs::remove_all(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::uint64_t& presses(Action action) { return seen_[static_cast<std::size_t>(action)]; }
    fs::path file() const { return folder_ / "first_minute"; }

    fs::path folder_;
    std::array<std::uint64_t, kActionCount> seen_{};
};

TEST_F(FirstMinuteTest, SaysOneThingAtATimeUntilItHasBeenDone) {
    FirstMinute minute({});
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Look);
    presses(Action::Look) = 10;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Walk);
    presses(Action::Left) = 1;  // any direction is walking
    presses(Action::Throw) = 1;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Drop);
    presses(Action::Drop) = 1;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Grab);  // thrown before it was asked for
    presses(Action::Grab) = 1;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Flashlight);
    EXPECT_EQ(minute.now({}), FirstStep::Menu);  // there is none in this scene
    presses(Action::Menu) = 1;
    presses(Action::Flashlight) = 1;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), std::nullopt);
}

TEST_F(FirstMinuteTest, AtAModelItSaysWhatOneDoesWithModels) {
    FirstMinute minute({});
    constexpr HintScene kModel{.looks_at_model = true};
    constexpr std::array kSteps{
        FirstStep::TurnModel, FirstStep::ShiftModel, FirstStep::ComeNear, FirstStep::Menu};
    for (const FirstStep step : kSteps) {
        EXPECT_EQ(minute.now(kModel), step);
        presses(action_of(step)) = 1;
        minute.see(seen_);
    }
    EXPECT_EQ(minute.now(kModel), std::nullopt);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Look);  // nothing of it was playing
}

// With a free pointer no mouse looks around: what cannot be done is not asked for.
TEST_F(FirstMinuteTest, WithAFreePointerItSaysWhatThatDoes) {
    FirstMinute minute({});
    constexpr HintScene kPointer{.by_pointer = true};
    constexpr std::array kSteps{
        FirstStep::TurnAbout, FirstStep::Drag, FirstStep::Shoot, FirstStep::Menu};
    for (const FirstStep step : kSteps) {
        EXPECT_EQ(minute.now(kPointer), step);
        presses(action_of(step)) = 1;
        minute.see(seen_);
    }
    EXPECT_EQ(minute.now(kPointer), std::nullopt);
    EXPECT_EQ(minute.now({}), FirstStep::Look) << "elsewhere all is still to be said";
}

TEST_F(FirstMinuteTest, WhatWasDoneDoesNotComeAgainInTheNextSitting) {
    {
        FirstMinute minute(file());
        presses(Action::Look) = 50;
        presses(Action::Forward) = 2;
        minute.see(seen_);
    }
    EXPECT_EQ(FirstMinute(file()).now(kHintScene), FirstStep::Drop);
}

TEST_F(FirstMinuteTest, ForgettingSaysAllAgainAndCountsFromThere) {
    FirstMinute minute(file());
    presses(Action::Look) = 50;
    minute.see(seen_);
    minute.forget();
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Look);
    EXPECT_EQ(FirstMinute(file()).now(kHintScene), FirstStep::Look);
    presses(Action::Look) = 60;
    minute.see(seen_);
    EXPECT_EQ(minute.now(kHintScene), FirstStep::Walk);
}

TEST_F(FirstMinuteTest, ADamagedFileCountsAsEmpty) {
    fs::create_directories(folder_);
    std::ofstream(file()) << std::string(5000, 'x');
    EXPECT_EQ(FirstMinute(file()).now(kHintScene), FirstStep::Look);
    std::ofstream(file()) << "look\n\x1b[31m nonsense walk";
    EXPECT_EQ(FirstMinute(file()).now(kHintScene), FirstStep::Drop);
}

}  // namespace
}  // namespace plumbline::app
