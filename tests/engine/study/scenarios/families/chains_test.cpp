// A14, A15: chains that hang.
#include "engine/study/scenarios/scenario_study.h"

#include <gtest/gtest.h>

namespace plumbline::study {
namespace {

Errors errors_of(const char* id, const Setting& setting) {
    const Point point = run_scenario(*scenario_of(id), setting, {.wanted = 1, .budget_s = 0});
    EXPECT_EQ(point.status, RunStatus::Done) << point.why;
    return point.errors;
}

// The balance is the exact one: what is solved exactly stays in it.
TEST(Chains, TheCatenaryHangsWhereItStarts) {
    const Errors errors = errors_of("A14", {.step_hz = 120, .substeps = 4});
    ASSERT_EQ(errors.size(), 3U);
    EXPECT_NEAR(errors[0], 0, 1e-3) << "the pull of 59.17 N";
    EXPECT_NEAR(errors[1], 0, 1e-3) << "the sag";
    EXPECT_LT(errors[2], 1e-5) << "gaps";
}

TEST(Chains, TheFirstJointCarriesTheWholeWeight) {
    const Errors direct = errors_of("A15 100:1", {.step_hz = 60, .substeps = 4});
    ASSERT_EQ(direct.size(), 4U);
    EXPECT_LT(direct[1], 1e-6) << "a chain that is solved exactly does not stretch";
    EXPECT_NEAR(direct[2], 0, 1e-4);
    const Errors swept = errors_of(
        "A15 100:1",
        {.solver = physics::Solver::BulletSi, .step_hz = 60, .substeps = 1, .iterations = 10});
    EXPECT_GT(swept[1], 1e-3) << "one that is swept does";
}

}  // namespace
}  // namespace plumbline::study
