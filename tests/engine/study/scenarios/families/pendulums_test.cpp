// A09 to A13, A18: what swings, and a motor.
#include "engine/study/scenarios/scenario_study.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

Errors errors_of_swing(const char* id) {
    const Point point = run_scenario(
        *scenario_of(id), {.step_hz = 240, .substeps = 4}, {.wanted = 1, .budget_s = 0});
    EXPECT_EQ(point.status, RunStatus::Done) << point.why;
    return point.errors;
}

// Steps of 1 ms are as good as exact: what is left would be the formula's.
TEST(Pendulums, FormulasAreWhatFineStepsComeTo) {
    for (const char* id : {"A09 30 degrees", "A09 90 degrees", "A10", "A11", "A13"}) {
        const Errors errors = errors_of_swing(id);
        ASSERT_FALSE(errors.empty()) << id;
        for (const double error : errors) EXPECT_LT(std::abs(error), 5e-4) << id;
    }
}

TEST(Pendulums, AMotorReachesItsSpeedAfterASecondAndNotAbove) {
    const Errors errors = errors_of_swing("A18");
    ASSERT_EQ(errors.size(), 3U);
    EXPECT_NEAR(errors[0], 0, 1e-4) << "half of it half way";
    EXPECT_NEAR(errors[1], 0, 1e-5);
    EXPECT_LT(errors[2], 1e-5);
}

}  // namespace
}  // namespace plumbline::study
