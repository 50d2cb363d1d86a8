#include "engine/study/findings/pareto.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

Point point(double ms_a_frame, std::vector<double> errors) {
    Point point;
    point.errors = std::move(errors);
    point.cost.ms_per_s_min = ms_a_frame * 60.0;
    point.cost.repeats = 5;
    return point;
}

Point failed(RunStatus status) {
    Point failed = point(0.001, {0.0});
    failed.status = status;
    return failed;
}

// Cost rises, error falls, but for the third, which the second beats in both.
std::vector<Point> four_points() {
    return {point(0.1, {0.08}), point(0.2, {0.02}), point(0.3, {0.03}), point(1.0, {0.0005})};
}

TEST(Pareto, ErrorIsTheWorstMetricsMagnitude) {
    EXPECT_DOUBLE_EQ(error_of(point(1, {0.01, -0.04, 0.02})), 0.04);
}

TEST(Pareto, WhatHasNoNumberHasNoErrorAndNoCost) {
    EXPECT_TRUE(std::isinf(error_of(failed(RunStatus::NotFinite))));
    EXPECT_TRUE(std::isinf(ms_per_frame(failed(RunStatus::Exploded))));
    EXPECT_TRUE(std::isinf(error_of(point(1, {0.1, std::nan("")}))));
    EXPECT_TRUE(std::isinf(error_of(point(1, {}))));
    Point untimed = point(1, {0.1});
    untimed.cost.repeats = 0;
    EXPECT_TRUE(std::isinf(ms_per_frame(untimed)));
}

TEST(Pareto, CostToReachTakesTheCheapestThatIsGoodEnough) {
    EXPECT_EQ(cheapest_within(four_points(), 0.05), 1U);
    EXPECT_EQ(cheapest_within(four_points(), 0.01), 3U);
    EXPECT_EQ(cheapest_within(four_points(), 0.001), 3U);
    EXPECT_FALSE(cheapest_within(four_points(), 1e-4));
}

TEST(Pareto, ErrorAtBudgetTakesTheMostAccurateThatIsCheapEnough) {
    EXPECT_FALSE(most_accurate_within(four_points(), 0.05));
    EXPECT_EQ(most_accurate_within(four_points(), 0.1), 0U) << "exactly the budget is within it";
    EXPECT_EQ(most_accurate_within(four_points(), 0.5), 1U);
    EXPECT_EQ(most_accurate_within(four_points(), 2.0), 3U);
}

TEST(Pareto, TheFrontLeavesOutWhatIsBeatenInBoth) {
    EXPECT_EQ(pareto_front(four_points()), (std::vector<std::size_t>{0, 1, 3}));
}

TEST(Pareto, TheFrontKeepsTheFirstOfEquals) {
    const std::vector<Point> equals{point(1, {0.1}), point(1, {0.1}), point(2, {0.1})};
    EXPECT_EQ(pareto_front(equals), (std::vector<std::size_t>{0}));
}

TEST(Pareto, FailedPointsAreNeverChosen) {
    std::vector<Point> points = four_points();
    points.push_back(failed(RunStatus::Exploded));
    points.push_back(point(0.0001, {std::nan("")}));
    EXPECT_EQ(pareto_front(points), pareto_front(four_points()));
    EXPECT_EQ(choose_for_tolerance(points, 0.05)->point, 1U);
    const std::vector<Point> none{failed(RunStatus::NotFinite)};
    EXPECT_TRUE(pareto_front(none).empty());
    EXPECT_FALSE(choose_for_tolerance(none, 1.0));
    EXPECT_FALSE(choose_for_budget(none, 1.0));
}

TEST(Pareto, AnUnreachableToleranceGetsTheMostAccurate) {
    const auto chosen = choose_for_tolerance(four_points(), 1e-6);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->point, 3U);
    EXPECT_FALSE(chosen->met);
}

TEST(Pareto, AnUnreachableBudgetGetsTheCheapest) {
    const auto chosen = choose_for_budget(four_points(), 0.01);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->point, 0U);
    EXPECT_FALSE(chosen->met);
}

// For every tolerance the point chosen lies on the front, and costs less as the tolerance grows.
TEST(Pareto, ChoicesLieOnTheFront) {
    const std::vector<Point> points = four_points();
    const std::vector<std::size_t> front = pareto_front(points);
    double cost_before = 1e9;
    for (double tolerance = 1e-4; tolerance < 0.2; tolerance *= 1.5) {
        const auto chosen = choose_for_tolerance(points, tolerance);
        ASSERT_TRUE(chosen);
        EXPECT_NE(std::ranges::find(front, chosen->point), front.end());
        if (!chosen->met) continue;
        EXPECT_LE(ms_per_frame(points[chosen->point]), cost_before);
        cost_before = ms_per_frame(points[chosen->point]);
    }
}

}  // namespace
}  // namespace plumbline::study
