#include "engine/study/findings/order.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

constexpr double kFine = 1e-11;
constexpr double kCoarse = 5e-6;

/// e(h) at 30, 60, ... Hz.
std::vector<ErrorAt> series_of(int count, double rounding, double (*error)(double h)) {
    std::vector<ErrorAt> series;
    for (int i = 0; i < count; ++i) {
        const double hz = 30 * std::exp2(i);
        series.push_back({.fineness = hz, .error = error(1 / hz), .rounding = rounding});
    }
    return series;
}

TEST(ObservedOrder, IsThePowerOfTheStep) {
    const auto first = observed_order(series_of(6, kFine, [](double h) { return 3 * h; }));
    EXPECT_EQ(first.trend, Trend::Converges);
    EXPECT_NEAR(*first.order, 1, 1e-12);
    EXPECT_EQ(first.halvings, 5);
    const auto second = observed_order(series_of(6, kFine, [](double h) { return h * h; }));
    EXPECT_NEAR(*second.order, 2, 1e-12);
}

TEST(ObservedOrder, TellsStallingFromGrowing) {
    const auto stalls = observed_order(series_of(6, kCoarse, [](double h) { return 0.1 + h; }));
    EXPECT_EQ(stalls.trend, Trend::Stalls);
    const auto grows =
        observed_order(series_of(6, kCoarse, [](double h) { return 1e-3 / std::sqrt(h); }));
    EXPECT_EQ(grows.trend, Trend::Diverges);
    EXPECT_NEAR(*grows.order, -0.5, 1e-12);
}

TEST(ObservedOrder, EndsWhereRoundingBegins) {
    // Second order down to 1e-6, which is below rounding.
    const auto falls =
        observed_order(series_of(8, kCoarse, [](double h) { return std::max(h * h, 1e-6); }));
    EXPECT_EQ(falls.trend, Trend::Converges);
    EXPECT_NEAR(*falls.order, 2, 0.01);
    EXPECT_LT(falls.halvings, 7);
    const auto exact = observed_order(series_of(5, kCoarse, [](double) { return 1e-7; }));
    EXPECT_EQ(exact.trend, Trend::Exact);
    EXPECT_FALSE(exact.order);
    const auto zero = observed_order(series_of(5, kCoarse, [](double) { return 0.0; }));
    EXPECT_EQ(zero.trend, Trend::Exact);
}

TEST(ObservedOrder, MoreStepsMayRoundMoreOften) {
    const double level = rounding_level({.step_hz = 60, .substeps = 2});
    EXPECT_DOUBLE_EQ(rounding_level({.step_hz = 30, .substeps = 1}), level);
    EXPECT_DOUBLE_EQ(rounding_level({.step_hz = 480, .substeps = 4}), 16 * level);
    EXPECT_LT(rounding_level({.precision = Precision::Float64}), 1e-4 * level);
}

TEST(ObservedOrder, AsksForThreeHalvings) {
    EXPECT_EQ(observed_order(series_of(3, kCoarse, [](double h) { return h; })).trend,
              Trend::TooFew);
    EXPECT_EQ(observed_order(series_of(4, kCoarse, [](double h) { return h; })).trend,
              Trend::Converges);
    EXPECT_EQ(observed_order({}).trend, Trend::TooFew);
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
    const std::vector<Convergence> verdicts = verdicts_of(points, theory);
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
