#include "engine/study/report/diagrams/plot.h"

#include "tests/engine/study/report/sample_findings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace plumbline::study {

namespace {

std::string plain(double value) {
    return fmt::format("{:g}", value);
}

Plot sample() {
    Plot plot;
    plot.name = "sample";
    plot.x = log_axis("cost", 0.1, 100, 10, plain);
    plot.y = log_axis("error", 1e-4, 1, 10, plain);
    return plot;
}

TEST(LogAxis, HasRoomAtBothEndsAndTheDecadesAsTicks) {
    const Axis axis = log_axis("cost", 0.1, 100, 10, plain);
    EXPECT_LT(axis.least, 0.1);
    EXPECT_GT(axis.most, 100);
    ASSERT_EQ(axis.ticks.size(), 4U);
    EXPECT_EQ(axis.ticks.front().text, "0.1");
    EXPECT_EQ(axis.ticks.back().text, "100");
}

TEST(LogAxis, OnePointIsWidened) {
    const Axis axis = log_axis("cost", 3, 3, 10, plain);
    EXPECT_GE(axis.most / axis.least, 10);
    EXPECT_NEAR(axis.most * axis.least, 9, 1e-9);  // in the middle
    EXPECT_GE(axis.ticks.size(), 2U);
}

TEST(GnuplotScript, EveryPointInsideIsThere) {
    Plot plot = sample();
    Curve curve;
    curve.name = "small_step";
    for (int i = 0; i < 5; ++i) curve.points.push_back({0.125 * (i + 1), 0.25 / (i + 1), {}});
    curve.points.push_back({1e6, 1, {}});   // right of the axes
    curve.points.push_back({1, -0.5, {}});  // no place on a logarithmic axis
    plot.curves.push_back(curve);
    const std::string script = gnuplot_script(plot);
    for (int i = 0; i < 5; ++i) {
        EXPECT_TRUE(
            test::holds(script, fmt::format("\n{:.9g} {:.9g}\n", 0.125 * (i + 1), 0.25 / (i + 1))));
    }
    EXPECT_FALSE(test::holds(script, "1000000"));
    EXPECT_FALSE(test::holds(script, "-0.5\n"));
    EXPECT_TRUE(test::holds(script, "title 'small_step'"));
}

TEST(GnuplotScript, TextStaysText) {
    Plot plot = sample();
    Curve curve;
    curve.name = "it's `date`\n$c0 \"@x\"";
    curve.symbol = 7;
    curve.points.push_back({1, 0.01, "'; system 'date"});
    plot.curves.push_back(curve);
    const std::string script = gnuplot_script(plot);
    EXPECT_TRUE(test::holds(script, "title 'it''s `date` $c0 \"@x\"'"));
    EXPECT_TRUE(test::holds(script, "set label '''; system ''date'"));
    EXPECT_TRUE(test::holds(script, "noenhanced"));
}

TEST(GnuplotScript, TicksArePlainText) {
    Plot plot = sample();
    plot.y.ticks = {{0.01, "1 %"}};
    EXPECT_TRUE(test::holds(gnuplot_script(plot), "'1 %%' 0.01"));
}

TEST(GnuplotScript, LabelsWithoutRoomAreLeftOut) {
    Plot plot = sample();
    Curve curve;
    curve.symbol = 7;
    for (int i = 0; i < 40; ++i) curve.points.push_back({1, 0.01, fmt::format("label {}", i)});
    plot.curves.push_back(curve);
    const std::string script = gnuplot_script(plot);
    EXPECT_TRUE(test::holds(script, "'label 0'"));
    EXPECT_FALSE(test::holds(script, "'label 39'"));
}

TEST(GnuplotScript, WithoutPointsThereAreAxes) {
    const std::string script = gnuplot_script(sample());
    EXPECT_TRUE(test::holds(script, "plot 1/0 notitle"));
}

}  // namespace

}  // namespace plumbline::study
