#include "engine/core/frame_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline {
namespace {

constexpr double kStep_s = 1.0 / 120.0;
constexpr double kHour_s = 3600.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Steps in `seconds` at an even frame rate, beginning at an uneven time of day.
int steps_at(double frames_per_s, double seconds) {
    constexpr double kStart_s = 12'345.678;
    FrameClock clock(kStep_s, 30);
    const int frames = static_cast<int>(std::lround(frames_per_s * seconds));
    int steps = 0;
    for (int i = 0; i <= frames; ++i) steps += clock.advance(kStart_s + i / frames_per_s).steps;
    EXPECT_EQ(clock.lost_s(), 0.0);
    return steps;
}

TEST(FrameClock, FrameRateDoesNotChangeTheNumberOfSteps) {
    for (const double frames_per_s : {15.0, 60.0, 144.0, 1000.0}) {
        EXPECT_EQ(steps_at(frames_per_s, 10.0), 1200) << frames_per_s << " frames a second";
    }
}

TEST(FrameClock, FirstFrameOwesNothing) {
    FrameClock clock(kStep_s, 8);
    const FrameTime time = clock.advance(1e6);
    EXPECT_EQ(time.steps, 0);
    EXPECT_EQ(time.lost_s, 0.0);
}

TEST(FrameClock, BlendIsTheShareOfTheStepThatHasPassed) {
    FrameClock clock(kStep_s, 8);
    clock.advance(0.0);
    const FrameTime quarter = clock.advance(kStep_s * 0.25);
    EXPECT_EQ(quarter.steps, 0);
    EXPECT_NEAR(quarter.blend, Real{0.25}, 1e-6);
    const FrameTime more = clock.advance(kStep_s * 2.75);
    EXPECT_EQ(more.steps, 2);
    EXPECT_NEAR(more.blend, Real{0.75}, 1e-6);
}

TEST(FrameClock, TimeBeyondTheCapIsLostAndCounted) {
    FrameClock clock(kStep_s, 4);
    clock.advance(0.0);
    const FrameTime time = clock.advance(kStep_s * 10.5);
    EXPECT_EQ(time.steps, 4);
    EXPECT_NEAR(time.lost_s, kStep_s * 6.5, 1e-12);
    EXPECT_EQ(clock.advance(kStep_s * 10.5).steps, 0) << "what is lost is not caught up with";
    clock.advance(kStep_s * 20.5);
    EXPECT_NEAR(clock.lost_s(), kStep_s * (6.5 + 6.0), 1e-12);
}

TEST(FrameClock, AHourlongGapIsCappedNotRun) {
    FrameClock clock(kStep_s, 30);
    clock.advance(0.0);
    const FrameTime time = clock.advance(kHour_s);
    EXPECT_EQ(time.steps, 30);
    EXPECT_NEAR(time.lost_s, kHour_s - 30 * kStep_s, 1e-9);
    EXPECT_EQ(clock.advance(kHour_s + kStep_s).steps, 1);
}

TEST(FrameClock, NonFiniteTimesOweNothingAndLeaveNoTrace) {
    for (const double broken_s : {kNan, kInfinity, -kInfinity}) {
        FrameClock clock(kStep_s, 8);
        clock.advance(0.0);
        EXPECT_EQ(clock.advance(broken_s).steps, 0);
        const FrameTime after = clock.advance(kStep_s * 3);
        EXPECT_EQ(after.steps, 3);
        EXPECT_TRUE(std::isfinite(after.blend));
        EXPECT_EQ(clock.lost_s(), 0.0);
    }
}

TEST(FrameClock, ANonFiniteFirstTimeIsNoFirstTime) {
    FrameClock clock(kStep_s, 8);
    clock.advance(kNan);
    EXPECT_EQ(clock.advance(kHour_s).steps, 0);
    EXPECT_EQ(clock.advance(kHour_s + kStep_s).steps, 1);
}

TEST(FrameClock, TimeThatStandsStillOrGoesBackOwesNothing) {
    FrameClock clock(kStep_s, 8);
    clock.advance(100.0);
    EXPECT_EQ(clock.advance(100.0).steps, 0);
    EXPECT_EQ(clock.advance(100.0 + 1e-9).steps, 0);
    EXPECT_EQ(clock.advance(40.0).steps, 0);
    EXPECT_EQ(clock.advance(40.0 + kStep_s * 2).steps, 2)
        << "it counts on from where it went back to";
    EXPECT_EQ(clock.lost_s(), 0.0);
}

TEST(FrameClock, PausedTimeIsNeitherRunNorLost) {
    FrameClock clock(kStep_s, 8);
    clock.advance(0.0);
    clock.advance(kStep_s * 1.5);
    clock.set_paused(true);
    const FrameTime paused = clock.advance(kHour_s);
    EXPECT_EQ(paused.steps, 0);
    EXPECT_EQ(paused.blend, Real{1}) << "a still picture shows the latest step itself";
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(kHour_s + kStep_s * 0.5).steps, 1) << "half a step before, half after";
    EXPECT_EQ(clock.lost_s(), 0.0);
}

TEST(FrameClock, ARequestedStepRunsOnceEvenWhilePaused) {
    FrameClock clock(kStep_s, 8);
    clock.advance(0.0);
    clock.set_paused(true);
    clock.request_step();
    clock.request_step();
    EXPECT_EQ(clock.advance(1.0).steps, 1);
    EXPECT_EQ(clock.advance(2.0).steps, 0);
    clock.set_paused(false);
    clock.request_step();
    EXPECT_EQ(clock.advance(2.0 + kStep_s).steps, 2);
}

TEST(FrameClock, SpeedScalesWallTime) {
    FrameClock clock(kStep_s, 100);
    clock.set_speed(2.0);
    clock.advance(0.0);
    EXPECT_EQ(clock.advance(kStep_s * 10).steps, 20);
    clock.set_speed(0.25);
    EXPECT_EQ(clock.advance(kStep_s * 50).steps, 10);
}

TEST(FrameClock, SpeedStaysInItsRange) {
    FrameClock clock(kStep_s, 8);
    clock.set_speed(1000.0);
    EXPECT_EQ(clock.speed(), 4.0);
    clock.set_speed(0.0);
    EXPECT_EQ(clock.speed(), 1.0 / 16.0);
    clock.set_speed(kNan);
    EXPECT_EQ(clock.speed(), 1.0 / 16.0);
}

TEST(FrameClockDeathTest, NeedsAPositiveStep) {
    EXPECT_DEATH(FrameClock(0.0, 8), "a positive step and cap");
    EXPECT_DEATH(FrameClock(kStep_s, 0), "a positive step and cap");
}

}  // namespace
}  // namespace plumbline
