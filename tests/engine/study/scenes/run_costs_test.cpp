#include "engine/study/scenes/run_costs.h"

#include "engine/study/scenes/scene_grid.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Point measured(const Setting& setting, double ms_per_s) {
    return {.setting = setting, .cost = {.ms_per_s_min = ms_per_s, .ms_per_s_median = ms_per_s}};
}

TEST(RunCosts, WhatWasMeasuredAtAnotherRateCountsBeforeGuesses) {
    std::vector<Point> points;
    const RunCosts costs(points, 0.1, 2);
    const Setting at_120{.step_hz = 120};
    EXPECT_DOUBLE_EQ(costs.of_one_s(at_120), guessed_cost(at_120) * 0.1 * 2);
    points.push_back(measured({}, 300));  // at 60 Hz
    EXPECT_DOUBLE_EQ(costs.of_one_s(at_120), 0.3 * 2 * 2);
    // A fidelity beside it costs as much more as is guessed.
    Setting draft{};
    draft.fidelity = {{"cloth", scene::Fidelity::Draft}};
    EXPECT_NEAR(costs.of_one_s(draft), 0.9 * 0.3 * 2, 1e-12);
}

TEST(RunCosts, RepeatsAndCopiesShrinkUntilTheGridFits) {
    const std::vector<Point> points{measured({}, 100)};
    const std::vector<Setting> grid{Setting{}};
    RunCosts costs(points, 0.1, 1);
    EXPECT_NEAR(costs.of_all_s({}), 0.1 + 0.5 + 0.02, 1e-9) << "with five repeats";
    costs.fit(grid, 0.35);
    EXPECT_EQ(costs.counts.repeats, 2);
    EXPECT_LE(costs.sum_s(grid), 0.35);
    costs.fit(grid, 0);
    EXPECT_EQ(costs.counts.repeats, 0);
    costs.counts = {.chaotic = true};
    EXPECT_NEAR(costs.sum_s(grid), 0.72, 1e-9) << "seven copies";
    costs.fit(grid, 0);
    EXPECT_EQ(costs.counts.copies, 3) << "fewer have no statistics";
}

TEST(RunCosts, ADisturbedClockIsSaid) {
    std::vector<Point> points{measured({}, 100)};
    points[0].cost.repeats = 5;
    EXPECT_EQ(clock_note(points), "");
    points[0].cost.ms_per_s_median = 150;
    EXPECT_NE(clock_note(points).find("50 %"), std::string::npos) << clock_note(points);
}

}  // namespace
}  // namespace plumbline::study
