#include "engine/study/stepping_cost.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Lap lap(double cpu_ms) {
    Lap made{.cpu_ms = cpu_ms, .simulated_s = 2, .work = 100};
    for (int i = 0; i < 100; ++i) made.step_ms.push_back(static_cast<float>(i));
    return made;
}

TEST(Measure, CostIsPerSimulatedSecondOfTheLaps) {
    const std::vector<Lap> laps{lap(30), lap(10), lap(20)};
    const RunCost cost = cost_of(laps);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_min, 5);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_median, 10);
    EXPECT_DOUBLE_EQ(cost.ms_per_s_max, 15);
    EXPECT_EQ(cost.repeats, 3);
    EXPECT_DOUBLE_EQ(cost.work_per_s, 50);
    EXPECT_NEAR(cost.step_ms_median, 50, 1);
    EXPECT_NEAR(cost.step_ms_p99, 98, 1);
    EXPECT_EQ(cost_of({}).repeats, 0);
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

TEST(Measure, EveryLapStepsAFreshWorld) {
    int made = 0;
    int stepped = 0;
    const physics::StepCost cost{.row_solves = 3, .contacts = 2, .pairs = 1};
    const auto make = [&]() -> Result<Stepping> {
        ++made;
        return Stepping{.step = [&] { ++stepped; },
                        .cost = [&]() -> const physics::StepCost& { return cost; },
                        .step_s = 0.5};
    };
    const Result<RunCost> measured = measure_stepping(make, 4, {.wanted = 3, .budget_s = 1e9});
    ASSERT_TRUE(measured.ok());
    EXPECT_EQ(made, 4) << "one to warm up";
    EXPECT_EQ(stepped, 16);
    EXPECT_EQ(measured->repeats, 3);
    EXPECT_DOUBLE_EQ(measured->work_per_s, 12);
}

TEST(Measure, WhatCannotBeMadeIsRefused) {
    const auto make = []() -> Result<Stepping> { return Error{.message = "no world"}; };
    const Result<RunCost> measured = measure_stepping(make, 4, {});
    ASSERT_FALSE(measured.ok());
    EXPECT_EQ(measured.error().message, "no world");
}

}  // namespace
}  // namespace plumbline::study
