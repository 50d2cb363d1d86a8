#include "engine/study/scenarios/scenario_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plumbline::study {
namespace {

using physics::Solver;

const Repeats kOnce{.wanted = 1, .budget_s = 0};

Setting bullet(int hz) {
    return {.solver = Solver::BulletSi,
            .step_hz = hz,
            .substeps = 1,
            .substeps_max = 1,
            .iterations = 10};
}
Setting small(int hz, int substeps) {
    return {.step_hz = hz, .substeps = substeps};
}

TEST(Scenarios, AreAllThereAndSayWhatTheyAre) {
    std::set<std::string> ids;
    for (const Scenario& scenario : scenarios()) {
        EXPECT_TRUE(ids.insert(scenario.id).second) << scenario.id << " twice";
        EXPECT_EQ(scenario_of(scenario.id), &scenario);
        EXPECT_FALSE(scenario.title.empty()) << scenario.id;
        EXPECT_FALSE(scenario.set_up.empty()) << scenario.id;
        EXPECT_FALSE(scenario.reference.empty()) << scenario.id;
        EXPECT_FALSE(scenario.metrics.empty()) << scenario.id;
    }
    for (const char* family :
         {"A01", "A02", "A03", "A04", "A05", "A06", "A07", "A08", "A09", "A10", "A11", "A13", "A14",
          "A15", "A18", "A20", "A21", "A22", "A23", "A24", "A25", "A26", "A28", "A29", "A30", "A31",
          "A32", "A33", "A34", "A35", "A36", "A38", "A39", "A40", "A41", "A42", "A43", "A44"}) {
        EXPECT_TRUE(std::ranges::any_of(ids, [&](const std::string& id) {
            return id.starts_with(family);
        })) << family;
    }
    EXPECT_EQ(scenario_of("A99"), nullptr);
}

/// The check line of the whole study: nothing but the step decides how far a body of semi-implicit
/// Euler falls short, g T h / 2. One that nothing pushes flies on the closed form instead.
TEST(Scenarios, BulletFallsOnTheEulerFloor) {
    const Scenario& fall = *scenario_of("A01 along a wall");
    // Beyond, float32's own rounding of a height of 20 m shows.
    for (const int hz : {30, 60, 120, 240, 480, 960}) {
        const Point point = run_scenario(fall, bullet(hz), kOnce);
        ASSERT_EQ(point.status, RunStatus::Done);
        const double line = kG_mps2 * 2 / hz / 2;
        const double off_m = std::abs(point.errors[0]) * 0.5 * kG_mps2 * 4;
        EXPECT_NEAR(off_m, line, 0.02 * line) << hz;
        EXPECT_NEAR(std::abs(point.errors[0]), fall.euler_floor(1.0 / hz), 0.02 / hz) << hz;
        const Point alone = run_scenario(*scenario_of("A01"), bullet(hz), kOnce);
        EXPECT_LT(std::abs(alone.errors[0]), 2e-6) << hz;
    }
}

struct Ordered {
    const char* id;
    Setting setting;
    double order;
};

TEST(Scenarios, OrdersAreThoseOfTheory) {
    const Ordered rows[] = {{"A01 along a wall", bullet(60), 1},
                            {"A03", bullet(60), 1},
                            {"A04", small(60, 1), 2},
                            {"A09 90 degrees", small(60, 1), 2},
                            {"A10", small(60, 1), 2},
                            {"A11", small(60, 1), 2}};
    for (const Ordered& row : rows) {
        const Scenario& scenario = *scenario_of(row.id);
        std::vector<Point> points;
        for (const int hz : {30, 60, 120, 240}) {
            Setting setting = row.setting;
            setting.step_hz = hz;
            points.push_back(run_scenario(scenario, setting, kOnce));
        }
        const std::vector<Convergence> verdicts = verdicts_of(points, scenario.theory);
        ASSERT_EQ(verdicts.size(), 1U) << row.id;
        EXPECT_EQ(verdicts[0].trend, Trend::Converges) << row.id;
        ASSERT_TRUE(verdicts[0].order) << row.id;
        EXPECT_NEAR(*verdicts[0].order, row.order, 0.15) << row.id;
        ASSERT_TRUE(verdicts[0].theory) << row.id;
        EXPECT_EQ(*verdicts[0].theory, row.order) << row.id;
    }
}

/// The other half of work that is counted: it is the same every time, and so are the numbers.
TEST(Scenarios, RunsRepeatToTheLastBit) {
    for (const char* id : {"A01", "A09 90 degrees", "A20 H=1 e=0.5", "A28", "A39 tower"}) {
        for (const Setting& setting : {small(60, 4), Setting{}, bullet(60)}) {
            const Scenario& scenario = *scenario_of(id);
            const Point first = run_scenario(scenario, setting, kOnce);
            const Point second = run_scenario(scenario, setting, kOnce);
            EXPECT_EQ(first.errors, second.errors) << id << ' ' << setting_text(setting);
            EXPECT_EQ(first.cost.work_per_s, second.cost.work_per_s)
                << id << ' ' << setting_text(setting);
        }
    }
}

TEST(Scenarios, AJobAnswersWithAPoint) {
    const std::string answer =
        run_scenario_job(
            R"({"scenario": "A01", "setting": {"solver": "bullet_si", "step_hz": 60, "substeps": 1,
            "substeps_max": 1, "iterations": 10, "precision": "float32"},
            "repeats": 2, "budget_s": 1})")
            .value();
    EXPECT_NE(answer.find("\"status\":\"done\""), std::string::npos) << answer;
    EXPECT_NE(answer.find("\"repeats\":2"), std::string::npos) << answer;
    EXPECT_ANY_THROW(static_cast<void>(run_scenario_job(R"({"scenario": "A99"})")));
    EXPECT_ANY_THROW(static_cast<void>(run_scenario_job("no json")));
}

}  // namespace
}  // namespace plumbline::study
