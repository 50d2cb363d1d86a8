#include "engine/study/report/contenders.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline::study {
namespace {

Point measured_point(physics::Solver solver, int hz, double ms_per_s, double error) {
    Point point;
    point.setting = {.solver = solver, .step_hz = hz};
    point.errors = {error};
    point.cost.ms_per_s_min = ms_per_s;
    point.cost.repeats = 1;
    return point;
}

Subject two_solvers() {
    Subject subject;
    subject.points = {measured_point(physics::Solver::BulletSi, 60, 1, 0.05),
                      measured_point(physics::Solver::SmallStep, 60, 2, 0.02),
                      measured_point(physics::Solver::BulletSi, 240, 4, 0.009),
                      measured_point(physics::Solver::SmallStep, 240, 9, 0.001)};
    return subject;
}

TEST(Contenders, StandInTheOrderOfTheirFirstPoints) {
    const std::vector<Contender> contenders = contenders_of(two_solvers());
    ASSERT_EQ(contenders.size(), 2U);
    EXPECT_EQ(contenders[0].name, "bullet_si");
    EXPECT_EQ(contenders[1].name, "small_step");
    EXPECT_EQ(contenders[0].points.size(), 2U);
    EXPECT_TRUE(contenders_of({}).empty());
}

TEST(Contenders, TheCheapestThatIsGoodEnoughWins) {
    const std::vector<Contender> contenders = contenders_of(two_solvers());
    EXPECT_EQ(winner_at(contenders, 0.05, kFirstMetric), 0U);
    EXPECT_EQ(winner_at(contenders, 0.02, kFirstMetric), 1U);
    EXPECT_EQ(winner_at(contenders, 0.01, kFirstMetric), 0U) << "4 ms against 9";
    EXPECT_EQ(winner_at(contenders, 0.001, kFirstMetric), 1U);
    EXPECT_EQ(winner_at(contenders, 1e-4, kFirstMetric), 2U) << "nobody";
    EXPECT_EQ(cheapest_at(contenders[1], 0.02, kFirstMetric), &contenders[1].points[0]);
    EXPECT_EQ(cheapest_at(contenders[0], 1e-4, kFirstMetric), nullptr);
    // 2 ms a second are 0.033 ms a frame.
    EXPECT_EQ(best_for(contenders[1], 0.034, kFirstMetric), &contenders[1].points[0]);
    EXPECT_EQ(best_for(contenders[1], 0.2, kFirstMetric), &contenders[1].points[1]);
    EXPECT_EQ(best_for(contenders[1], 0.03, kFirstMetric), nullptr);
}

}  // namespace
}  // namespace plumbline::study
