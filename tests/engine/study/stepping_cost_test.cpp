#include "engine/study/stepping_cost.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Lap lap(double cpu_ms) {
    Lap made{.cpu_ms = cpu_ms, .clock_ms = 0.6 * cpu_ms, .simulated_s = 2, .work = 100};
    for (int i = 0; i < 100; ++i) made.step_ms.push_back(static_cast<float>(i));
    return made;
}

TEST(Measure, CostIsPerSimulatedSecondOfTheLaps) {
    const std::vector<Lap> laps{lap(30), lap(10), lap(20)};
    const RunCost cost = cost_of(laps);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_min, 5);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_median, 10);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_max, 15);
    EXPECT_DOUBLE_EQ(cost.clock_ms_per_s, 3) << "the least";
    EXPECT_EQ(cost.repeats, 3);
    EXPECT_DOUBLE_EQ(cost.work_per_s, 50);
    EXPECT_NEAR(cost.step_ms_median, 50, 1);
    EXPECT_NEAR(cost.step_ms_p99, 98, 1);
    EXPECT_EQ(cost_of({}).repeats, 0);
}

TEST(Measure, TimeOfHelpersIsCpuTimeAndNotTimeOnTheClock) {
    StepMeter alone;
    StepMeter helped;
    for (StepMeter* meter : {&alone, &helped}) {
        meter->resume();
        meter->stepped({.helpers_ms = meter == &helped ? 1e6 : 0.0}, 0.01);
        meter->pause();
    }
    EXPECT_GE(helped.lap().cpu_ms, 1e6);
    EXPECT_LT(alone.lap().cpu_ms, 1e5);
    EXPECT_LT(helped.lap().clock_ms, 1e5);
    EXPECT_GT(helped.lap().clock_ms, 0);
}

TEST(Measure, ABudgetEndsTheLapsButNotBeforeTheFirst) {
    int taken = 0;
    const auto slow = [&] {
        ++taken;
        return lap(400);
    };
    EXPECT_EQ(take_laps(slow, {.wanted = 5, .budget_s = 1}).size(), 3U);
    EXPECT_EQ(take_laps(slow, {.wanted = 5, .budget_s = 0}).size(), 1U);
    EXPECT_EQ(take_laps(slow, {.wanted = 2, .budget_s = 10}).size(), 2U);
    EXPECT_EQ(taken, 6);
}

TEST(Measure, AFrameIsTheStepsOfASixtiethAndTheWorstIsNotAHiccup) {
    // 1 s at 240 Hz: four steps a frame, each of 1 ms, but one frame of 4 x 3 ms.
    Lap plain{.cpu_ms = 240, .simulated_s = 1};
    for (int i = 0; i < 240; ++i) plain.step_ms.push_back(i / 4 == 7 ? 3.0F : 1.0F);
    Lap disturbed = plain;
    disturbed.cpu_ms = 200;  // the fastest, with a step that waited for another process
    disturbed.step_ms[100] = 50;
    const RunCost cost = cost_of(std::vector{plain, disturbed});
    EXPECT_DOUBLE_EQ(cost.frame_ms_max, 12);
    EXPECT_DOUBLE_EQ(cost.step_ms_max, 3);
    EXPECT_DOUBLE_EQ(cost.step_ms_median, 1);
    // At 30 Hz every step is a frame of its own.
    Lap slow{.cpu_ms = 30, .simulated_s = 1};
    for (int i = 0; i < 30; ++i) slow.step_ms.push_back(static_cast<float>(i));
    EXPECT_DOUBLE_EQ(cost_of(std::vector{slow}).frame_ms_max, 29);
}

TEST(Measure, WorkIsThatOfTheLastLapWhicheverIsFastest) {
    Lap first = lap(10);
    first.work = 60;
    EXPECT_DOUBLE_EQ(cost_of(std::vector{first, lap(20)}).work_per_s, 50);
    EXPECT_DOUBLE_EQ(cost_of(std::vector{lap(20), first}).work_per_s, 30);
}

}  // namespace
}  // namespace plumbline::study
