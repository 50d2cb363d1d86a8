#include "engine/study/report/diagrams/diagrams.h"

#include "engine/study/report/setting_names.h"
#include "tests/engine/study/report/sample_findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::study {

namespace {

const Curve* curve_named(const Plot& plot, const std::string& name) {
    const auto found = std::ranges::find(plot.curves, name, &Curve::name);
    return found == plot.curves.end() ? nullptr : &*found;
}

bool holds_point(const Curve& curve, double x, double y) {
    return std::ranges::any_of(curve.points, [&](const PlotPoint& point) {
        return std::abs(point.x / x - 1) < 1e-12 && std::abs(point.y / y - 1) < 1e-12;
    });
}

TEST(DrawnError, ZeroIsDrawnWhereArithmeticEnds) {
    EXPECT_EQ(drawn_error(0, Precision::Float32), 1.2e-7);
    EXPECT_EQ(drawn_error(0, Precision::Float64), 2.2e-16);
    EXPECT_EQ(drawn_error(-0.25, Precision::Float32), 0.25);
    EXPECT_FALSE(drawn_error(std::nan(""), Precision::Float32));
    EXPECT_FALSE(drawn_error(HUGE_VAL, Precision::Float32));
}

TEST(WorkPrecision, EveryPointIsOnTheLineOfItsRate) {
    const Subject subject = test::sample_subject("A01");
    const auto plot = work_precision_plot(subject, {});
    ASSERT_TRUE(plot);
    for (const Point& point : subject.points) {
        const Curve* curve = curve_named(*plot, family_name(point.setting));
        ASSERT_NE(curve, nullptr) << family_name(point.setting);
        EXPECT_TRUE(holds_point(*curve, point.cost.ms_per_s_min, point.errors.front()))
            << setting_text(point.setting);
        EXPECT_LT(plot->x.least, point.cost.ms_per_s_min);
        EXPECT_GT(plot->x.most, point.cost.ms_per_s_min);
        EXPECT_LT(plot->y.least, point.errors.front());
        EXPECT_GT(plot->y.most, point.errors.front());
    }
}

TEST(WorkPrecision, RingsAreThePointsThatNobodyBeats) {
    Subject subject = test::sample_subject("A01");
    // Nothing that costs more than the rest may be ringed, unless it is nearer: bullet_si never is.
    const auto plot = work_precision_plot(subject, {});
    const Curve* rings = curve_named(*plot, "cheapest for its error");
    ASSERT_NE(rings, nullptr);
    for (const Point& point : subject.points) {
        if (point.setting.solver != physics::Solver::BulletSi) continue;
        EXPECT_FALSE(holds_point(*rings, point.cost.ms_per_s_min, point.errors.front()));
    }
    EXPECT_TRUE(holds_point(*rings, 0.02 * 0.5, 0.02 * 2));  // the cheapest of all: 30 Hz x 1
}

TEST(WorkPrecision, RunsWithoutAnswerAreCrossesAtTheTop) {
    Subject subject = test::sample_subject("A01");
    subject.points[0].status = RunStatus::Exploded;
    subject.points[0].errors.clear();
    subject.points[1].errors = {std::nan("")};
    const auto plot = work_precision_plot(subject, {});
    const Curve* crosses = curve_named(*plot, "failed");
    ASSERT_NE(crosses, nullptr);
    EXPECT_EQ(crosses->points.size(), 2U);
    EXPECT_GT(crosses->points[0].y, 0.9 * plot->y.most);
    EXPECT_LE(crosses->points[0].y, plot->y.most);
}

TEST(WorkPrecision, PeersAreGreyAndNamed) {
    const std::vector<PeerPoint> peers{
        {"jolt", 1, 3, 0.09}, {"jolt", 2, 6, 0.02}, {"box3d", 1, 4, 0.04}};
    const auto plot = work_precision_plot(test::sample_subject("A15"), peers);
    const Curve* grey = curve_named(*plot, "other engines (peers)");
    ASSERT_NE(grey, nullptr);
    EXPECT_TRUE(holds_point(*grey, 4, 0.04));
    EXPECT_EQ(grey->points.front().label, "box3d");
    EXPECT_GT(plot->x.most, 6);
    const auto without = work_precision_plot(test::sample_subject("A15"), {});
    EXPECT_EQ(curve_named(*without, "other engines (peers)"), nullptr);
}

TEST(WorkPrecision, NothingToDrawIsNoDiagram) {
    Subject subject = test::sample_subject("A01");
    for (Point& point : subject.points) point.cost = {};
    EXPECT_FALSE(work_precision_plot(subject, {}));
    EXPECT_FALSE(work_precision_plot(Subject{}, {}));
    EXPECT_FALSE(step_plot(Subject{}));
}

TEST(WorkPrecision, OnePointIsADiagramAndNoStepDiagram) {
    Subject subject = test::sample_subject("A01");
    subject.points.resize(1);
    EXPECT_TRUE(work_precision_plot(subject, {}));
    EXPECT_FALSE(step_plot(subject));
}

TEST(StepPlot, SubStepsAndRateMakeTheSameStep) {
    // 120 Hz x 1 and 30 Hz x 4 both take 8.33 ms.
    const auto plot = step_plot(test::sample_subject("A01"));
    ASSERT_TRUE(plot);
    EXPECT_TRUE(holds_point(*curve_named(*plot, "small_step x 1"), 1000.0 / 120, 0.01));
    EXPECT_TRUE(holds_point(*curve_named(*plot, "small_step x 4"), 1000.0 / 120, 0.01));
}

TEST(StepPlot, SubStepsOnDemandAreDrawnAtTheirLongestStep) {
    Subject subject = test::sample_subject("A01");
    for (Point& point : subject.points) point.setting.substeps = 0;
    const int least = world_def({.substeps = 0}).substeps;
    const auto plot = step_plot(subject);
    ASSERT_TRUE(plot);
    EXPECT_TRUE(std::ranges::any_of(plot->curves, [&](const Curve& curve) {
        return holds_point(curve, 1000.0 / 60 / least, 0.02);
    }));
}

TEST(StepPlot, TheEulerFloorIsALineOfItsOwn) {
    const Subject subject = test::sample_subject("A01");
    const auto plot = step_plot(subject);
    const Curve* floor = curve_named(*plot, "Euler floor");
    ASSERT_NE(floor, nullptr);
    EXPECT_EQ(floor->points.size(), subject.euler_floor.size());
    EXPECT_TRUE(holds_point(*floor, 1000.0 / 60, 0.5 / 60));
    Subject bare = subject;
    bare.euler_floor.clear();
    EXPECT_EQ(curve_named(*step_plot(bare), "Euler floor"), nullptr);
}

TEST(StepPlot, SlopesRiseAsTheirOrderSays) {
    const auto plot = step_plot(test::sample_subject("A01"));
    for (const int order : {1, 2}) {
        const Curve* slope =
            curve_named(*plot, order == 1 ? "slope of order 1" : "slope of order 2");
        ASSERT_NE(slope, nullptr);
        const PlotPoint& a = slope->points.front();
        const PlotPoint& b = slope->points.back();
        EXPECT_NEAR(std::log(b.y / a.y) / std::log(b.x / a.x), order, 1e-9);
    }
}

}  // namespace

}  // namespace plumbline::study
