// Which settings a scenario is run at.
#include "engine/study/scenarios/scenario_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace plumbline::study {
namespace {

TEST(Scenarios, GridsTurnEveryKnobFarEnoughForAVerdict) {
    for (const Scenario& scenario : scenarios()) {
        for (const Effort effort : {Effort::Quick, Effort::Full}) {
            std::set<std::string> texts;
            for (const Setting& setting : grid_of(scenario, effort)) {
                EXPECT_TRUE(texts.insert(setting_text(setting)).second)
                    << scenario.id << ": " << setting_text(setting) << " twice";
                EXPECT_GE(setting.step_hz, scenario.knobs.least_hz);
                EXPECT_LE(setting.step_hz, scenario.knobs.most_hz);
                EXPECT_EQ(1920 % setting.step_hz, 0) << "moments that every step divides";
            }
            EXPECT_GE(texts.size(), 4U) << scenario.id;
        }
    }
}

std::set<int> rates_in(const std::vector<Setting>& grid) {
    std::set<int> rates;
    for (const Setting& setting : grid) rates.insert(setting.step_hz);
    return rates;
}

TEST(ScenarioGrid, TurnsOnlyTheKnobsThatAreWorthIt) {
    Scenario scenario;
    scenario.knobs = {
        .substeps = false, .iterations = false, .most_hz = 240, .least_hz = 60, .doubled = false};
    const std::vector<Setting> grid = grid_of(scenario, Effort::Full);
    EXPECT_EQ(rates_in(grid), (std::set<int>{60, 120, 240}));
    // small_step on demand and Bullet's four, at three rates.
    EXPECT_EQ(grid.size(), 5U * 3U);
    for (const Setting& setting : grid) EXPECT_EQ(setting.precision, Precision::Float32);
    scenario.knobs.doubled = true;
    EXPECT_EQ(grid_of(scenario, Effort::Full).size(), 7U * 3U);
}

TEST(ScenarioGrid, TheQuickOneHalvesThreeTimesBelow480Hz) {
    Scenario scenario;
    EXPECT_EQ(rates_in(grid_of(scenario, Effort::Quick)), (std::set<int>{60, 120, 240, 480}));
    EXPECT_EQ(grid_of(scenario, Effort::Quick).size(), 8U);
    scenario.knobs.most_hz = 240;
    EXPECT_EQ(rates_in(grid_of(scenario, Effort::Quick)), (std::set<int>{30, 60, 120, 240}));
}

}  // namespace
}  // namespace plumbline::study
