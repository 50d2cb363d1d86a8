// What a change must not make worse unseen: errors and counted work at the game's setting. Seconds
// are gated nowhere.
#include "engine/study/scenarios/scenario.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

struct Gate {
    const char* id;
    double error;       ///< most, of the first metric
    double work_per_s;  ///< most
};

// Measured at 60 Hz with sub-steps on demand, with room of about a half for errors above rounding
// and a fifth for work.
constexpr Gate kGates[]{{"A01", 1e-6, 0},
                        {"A05", 6e-3, 0},
                        {"A09 90 degrees", 4e-3, 11'000},
                        {"A13", 2.5e-4, 0},
                        {"A14", 1e-6, 110'000},
                        {"A15 1000:1", 1e-6, 280'000},
                        {"A20 H=1 e=0.5", 1e-5, 160},
                        {"A22 10:1", 1e-6, 120},
                        {"A24 gap=0", 1e-6, 5'000},
                        {"A28", 1e-5, 17'000},
                        {"A29 holds", 2e-4, 17'000},
                        {"A30", 1e-5, 7'500},
                        {"A32", 2e-4, 7'500},
                        {"A39 tower", 1e-5, 330'000}};

TEST(Gate, ErrorsAndWorkStayWithinWhatTheyWere) {
    for (const Gate& gate : kGates) {
        const Scenario* scenario = scenario_of(gate.id);
        ASSERT_NE(scenario, nullptr) << gate.id;
        const Point point = run_scenario(*scenario, Setting{}, {.wanted = 1, .budget_s = 0});
        ASSERT_EQ(point.status, RunStatus::Done) << gate.id;
        EXPECT_LE(std::abs(point.errors[0]), gate.error) << gate.id;
        EXPECT_LE(point.cost.work_per_s, gate.work_per_s) << gate.id;
    }
}

}  // namespace
}  // namespace plumbline::study
