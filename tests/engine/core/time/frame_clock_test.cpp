#include "engine/core/time/frame_clock.h"

#include "engine/core/math.h"

#include <gtest/gtest.h>

#include <algorithm>
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
    FrameClock clock(kStep_s);
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
    FrameClock clock(kStep_s);
    const FrameTime time = clock.advance(1e6);
    EXPECT_EQ(time.steps, 0);
    EXPECT_EQ(time.lost_s, 0.0);
}

TEST(FrameClock, BlendIsTheShareOfTheStepThatHasPassed) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    const FrameTime quarter = clock.advance(kStep_s * 0.25);
    EXPECT_EQ(quarter.steps, 0);
    EXPECT_NEAR(quarter.blend, Real{0.25}, 1e-6);
    const FrameTime more = clock.advance(kStep_s * 2.75);
    EXPECT_EQ(more.steps, 2);
    EXPECT_NEAR(more.blend, Real{0.75}, 1e-6);
}

// EXPERIENCE A16: half a second a frame, and all of it is simulated.
TEST(FrameClock, ASlowImageLosesNoTime) {
    for (const double frames_per_s : {0.3, 1.0, 2.0, 4.0})
        EXPECT_EQ(steps_at(frames_per_s, 50.0), 6000) << frames_per_s << " frames a second";
}

// EXPERIENCE H3, I5
TEST(FrameClock, AHourlongHoleIsNotRun) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    const FrameTime time = clock.advance(kHour_s);
    EXPECT_EQ(time.steps, 30) << "a quarter of a second";
    EXPECT_NEAR(time.lost_s, kHour_s - 30 * kStep_s, 1e-9);
    EXPECT_EQ(clock.lost_s(), time.lost_s);
    EXPECT_EQ(clock.too_slow_s(), 0.0) << "nothing was too slow";
    EXPECT_EQ(clock.advance(kHour_s + kStep_s).steps, 1) << "what is lost is not caught up with";
}

TEST(FrameClock, ThreeQuartersOfAFrameAreForStepping) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    EXPECT_EQ(clock.advance(1.0).budget_s, 0.75);
    EXPECT_EQ(clock.advance(1.01).budget_s, 0.05) << "short frames may take 50 ms all the same";
    EXPECT_EQ(clock.advance(kHour_s).budget_s, 0.75 * 0.25) << "a hole is no long frame";
}

TEST(FrameClock, StepsThatDidNotRunAreLostAndCounted) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    EXPECT_EQ(clock.advance(kStep_s * 10.5).steps, 10);
    clock.drop(6);
    EXPECT_NEAR(clock.lost_s(), kStep_s * 6, 1e-12);
    EXPECT_NEAR(clock.too_slow_s(), kStep_s * 6, 1e-12);
    EXPECT_EQ(clock.advance(kStep_s * 11).steps, 1) << "what is lost is not caught up with";
}

/// A machine on a clock of its own: drawing takes `draw_s` a frame and a step costs `cost_s`.
struct Machine {
    double draw_s;
    double cost_s;
    double now_s{0};
    double longest_frame_s{0};

    /// Simulated seconds within `seconds` of wall time.
    double play(FrameClock& clock, double seconds) {
        const double end_s = now_s + seconds;
        int steps = 0;
        clock.advance(now_s);
        while (now_s < end_s) {
            const double start_s = now_s;
            now_s += draw_s;
            const FrameTime time = clock.advance(now_s);
            double spent_s = 0;
            int run = 0;
            for (; run < time.steps && (run == 0 || spent_s <= time.budget_s); ++run)
                spent_s += cost_s;
            clock.drop(time.steps - run);
            steps += run;
            now_s += spent_s;
            longest_frame_s = std::max(longest_frame_s, now_s - start_s);
        }
        return steps * clock.step_s();
    }
};

TEST(FrameClock, PhysicsThatKeepsUpLosesNothingHoweverSlowTheImage) {
    for (const double draw_s : {0.001, 0.016, 0.1, 0.4}) {
        for (const double load : {0.01, 0.3, 0.6}) {
            FrameClock clock(kStep_s);
            Machine machine{.draw_s = draw_s, .cost_s = load * kStep_s};
            const double simulated_s = machine.play(clock, 60.0);
            EXPECT_EQ(clock.lost_s(), 0.0) << draw_s << " s an image, load " << load;
            EXPECT_NEAR(simulated_s, machine.now_s, machine.longest_frame_s + kStep_s);
        }
    }
}

// EXPERIENCE A16
TEST(FrameClock, PhysicsThatIsTooSlowGivesSlowMotionNotASpiral) {
    FrameClock clock(kStep_s);
    Machine machine{.draw_s = 0.05, .cost_s = 3.0 * kStep_s};
    const double simulated_s = machine.play(clock, 60.0);
    EXPECT_LE(machine.longest_frame_s, 4 * 0.05 + 2 * machine.cost_s);
    EXPECT_NEAR(simulated_s, 60.0 * 0.75 / 3.0, 2.0) << "three quarters go into steps";
    EXPECT_NEAR(clock.too_slow_s() + simulated_s, machine.now_s, machine.longest_frame_s + kStep_s);
}

TEST(FrameClock, NonFiniteTimesOweNothingAndLeaveNoTrace) {
    for (const double broken_s : {kNan, kInfinity, -kInfinity}) {
        FrameClock clock(kStep_s);
        clock.advance(0.0);
        EXPECT_EQ(clock.advance(broken_s).steps, 0);
        const FrameTime after = clock.advance(kStep_s * 3);
        EXPECT_EQ(after.steps, 3);
        EXPECT_TRUE(std::isfinite(after.blend));
        EXPECT_EQ(clock.lost_s(), 0.0);
    }
}

TEST(FrameClock, ANonFiniteFirstTimeIsNoFirstTime) {
    FrameClock clock(kStep_s);
    clock.advance(kNan);
    EXPECT_EQ(clock.advance(kHour_s).steps, 0);
    EXPECT_EQ(clock.advance(kHour_s + kStep_s).steps, 1);
}

TEST(FrameClock, TimeThatStandsStillOrGoesBackOwesNothing) {
    FrameClock clock(kStep_s);
    clock.advance(100.0);
    EXPECT_EQ(clock.advance(100.0).steps, 0);
    EXPECT_EQ(clock.advance(100.0 + 1e-9).steps, 0);
    EXPECT_EQ(clock.advance(40.0).steps, 0);
    EXPECT_EQ(clock.advance(40.0 + kStep_s * 2).steps, 2)
        << "it counts on from where it went back to";
    EXPECT_EQ(clock.lost_s(), 0.0);
}

TEST(FrameClock, PausedTimeIsNeitherRunNorLost) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    clock.advance(kStep_s * 1.5);
    clock.set_paused(true);
    const FrameTime paused = clock.advance(kHour_s);
    EXPECT_EQ(paused.steps, 0);
    EXPECT_EQ(paused.blend, Real{1}) << "a still image shows the latest step itself";
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(kHour_s + kStep_s * 0.5).steps, 1) << "half a step before, half after";
    EXPECT_EQ(clock.lost_s(), 0.0);
}

TEST(FrameClock, AHoldIsAPauseOfItsOwn) {
    FrameClock clock(kStep_s);
    clock.advance(0.0);
    clock.hold(true);
    EXPECT_TRUE(clock.stands_still());
    EXPECT_FALSE(clock.paused());
    EXPECT_EQ(clock.advance(kHour_s).steps, 0);
    clock.set_paused(true);
    clock.hold(false);
    EXPECT_TRUE(clock.stands_still()) << "the person's pause outlasts it";
    EXPECT_EQ(clock.advance(kHour_s + 1.0).steps, 0);
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(kHour_s + 1.0 + kStep_s).steps, 1);
    EXPECT_EQ(clock.lost_s(), 0.0);
}

TEST(FrameClock, ARequestedStepRunsOnceEvenWhilePaused) {
    FrameClock clock(kStep_s);
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
    FrameClock clock(kStep_s);
    clock.set_speed(2.0);
    clock.advance(0.0);
    EXPECT_EQ(clock.advance(kStep_s * 10).steps, 20);
    clock.set_speed(0.25);
    EXPECT_EQ(clock.advance(kStep_s * 50).steps, 10);
}

TEST(FrameClock, SpeedStaysInItsRange) {
    FrameClock clock(kStep_s);
    clock.set_speed(1000.0);
    EXPECT_EQ(clock.speed(), 4.0);
    clock.set_speed(0.0);
    EXPECT_EQ(clock.speed(), 1.0 / 16.0);
    clock.set_speed(kNan);
    EXPECT_EQ(clock.speed(), 1.0 / 16.0);
}

TEST(FrameClockDeathTest, NeedsAPositiveStep) {
    EXPECT_DEATH(FrameClock(0.0), "a positive step");
}

}  // namespace
}  // namespace plumbline
