#include "engine/study/order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

/// e(h) at 30, 60, ... Hz.
std::vector<ErrorAt> series_of(int count, double (*error)(double h)) {
    std::vector<ErrorAt> series;
    for (int i = 0; i < count; ++i) {
        const double hz = 30 * std::exp2(i);
        series.push_back({.fineness = hz, .error = error(1 / hz)});
    }
    return series;
}

TEST(ObservedOrder, IsThePowerOfTheStep) {
    const double rounding = rounding_level(Precision::Float64);
    const auto first = observed_order(series_of(6, [](double h) { return 3 * h; }), rounding);
    EXPECT_EQ(first.trend, Trend::Converges);
    EXPECT_NEAR(*first.order, 1, 1e-12);
    EXPECT_EQ(first.halvings, 5);
    const auto second = observed_order(series_of(6, [](double h) { return h * h; }), rounding);
    EXPECT_NEAR(*second.order, 2, 1e-12);
}

TEST(ObservedOrder, TellsStallingFromGrowing) {
    const double rounding = rounding_level(Precision::Float32);
    const auto stalls = observed_order(series_of(6, [](double h) { return 0.1 + h; }), rounding);
    EXPECT_EQ(stalls.trend, Trend::Stalls);
    const auto grows =
        observed_order(series_of(6, [](double h) { return 1e-3 / std::sqrt(h); }), rounding);
    EXPECT_EQ(grows.trend, Trend::Diverges);
    EXPECT_NEAR(*grows.order, -0.5, 1e-12);
}

TEST(ObservedOrder, EndsWhereRoundingBegins) {
    const double rounding = rounding_level(Precision::Float32);
    // Second order down to 1e-6, which is below rounding.
    const auto falls =
        observed_order(series_of(8, [](double h) { return std::max(h * h, 1e-6); }), rounding);
    EXPECT_EQ(falls.trend, Trend::Converges);
    EXPECT_NEAR(*falls.order, 2, 0.01);
    EXPECT_LT(falls.halvings, 7);
    const auto exact = observed_order(series_of(5, [](double) { return 1e-7; }), rounding);
    EXPECT_EQ(exact.trend, Trend::Exact);
    EXPECT_FALSE(exact.order);
    const auto zero = observed_order(series_of(5, [](double) { return 0.0; }), rounding);
    EXPECT_EQ(zero.trend, Trend::Exact);
}

TEST(ObservedOrder, AsksForThreeHalvings) {
    const double rounding = rounding_level(Precision::Float32);
    EXPECT_EQ(observed_order(series_of(3, [](double h) { return h; }), rounding).trend,
              Trend::TooFew);
    EXPECT_EQ(observed_order(series_of(4, [](double h) { return h; }), rounding).trend,
              Trend::Converges);
    EXPECT_EQ(observed_order({}, rounding).trend, Trend::TooFew);
}

Point point(const Setting& setting, double error) {
    return {.setting = setting, .errors = {error}};
}

TEST(Verdicts, TurnOneKnobAtATime) {
    std::vector<Point> points;
    for (const int hz : {30, 60, 120, 240}) {
        points.push_back(point({.step_hz = hz, .substeps = 4}, 1.0 / hz));
        points.push_back(point(
            {.solver = physics::Solver::BulletSi, .step_hz = hz, .substeps = 1, .iterations = 10},
            -0.5));
    }
    for (const int substeps : {1, 2, 8})
        points.push_back(point({.step_hz = 60, .substeps = substeps}, 4.0 / 60 / substeps));
    // Crashed: counts as nothing.
    points.push_back({.setting = {.step_hz = 480, .substeps = 4}, .status = RunStatus::Crashed});
    const auto theory = [](const Setting& setting, std::string_view knob) {
        return setting.solver == physics::Solver::SmallStep && knob == "step rate"
                   ? std::optional<double>(1)
                   : std::nullopt;
    };
    const std::vector<KnobVerdict> verdicts = verdicts_of(points, theory);
    ASSERT_EQ(verdicts.size(), 3U);
    EXPECT_EQ(verdicts[0].knob, "step rate");
    EXPECT_EQ(verdicts[0].held, "x 4, float32");
    EXPECT_EQ(verdicts[0].trend, Trend::Converges);
    EXPECT_NEAR(*verdicts[0].order, 1, 1e-12);
    EXPECT_EQ(verdicts[0].theory, 1);
    EXPECT_EQ(verdicts[1].solver, physics::Solver::BulletSi);
    EXPECT_EQ(verdicts[1].trend, Trend::Stalls);
    EXPECT_EQ(verdicts[1].held, "x 1, 10 it, float32");
    EXPECT_EQ(verdicts[2].knob, "sub-steps");
    EXPECT_EQ(verdicts[2].halvings, 3);
    EXPECT_NEAR(*verdicts[2].order, 1, 1e-12);
}

}  // namespace
}  // namespace plumbline::study
