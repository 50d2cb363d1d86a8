// The museum's plaques agree with their formulas; the workshop's machine runs through, the same way every time.
#include "tests/scenarios/scene_run.h"

#include <map>

namespace plumbline {
namespace {

using test::SceneRun;

TEST(Museum, EveryPlaqueIsWithinAPercentOfItsFormula) {
    SceneRun run("museum.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 30);
    int plaques = 0;
    for (auto [entity, plaque] : run.simulation->registry.view<const scene::Plaque>()) {
        ++plaques;
        ASSERT_TRUE(plaque.meter.measured()) << plaque.says.title;
        const double error = *plaque.meter.measured() / plaque.says.expected - 1;
        RecordProperty(plaque.says.of, std::to_string(100 * error) + " %");
        EXPECT_LT(std::abs(error), 0.01) << plaque.says.title << ": " << *plaque.meter.measured();
    }
    EXPECT_EQ(plaques, 8);
}

/// Seconds until each stage of the machine was through.
struct Passage {
    std::map<std::string, double> at_s;
    std::uint64_t hash{0};
};

Passage run_machine(const scene::SimulationOverrides& overrides = {}) {
    SceneRun run("workshop.toml", overrides);
    Passage passage;
    if (!run.simulation) return passage;
    const auto note = [&](const char* stage, bool through) {
        if (through) passage.at_s.try_emplace(stage, run.simulation->time_s());
    };
    const auto x_m = [&](const char* name) { return run.state(name).world_from_body.position.x; };
    while (run.simulation->time_s() < 20) {
        run.step(1);
        const auto there = [&](const char* name) {
            return run.simulation->registry.alive(run.simulation->find(name));
        };
        note("1 weight", run.state("weight").world_from_body.position.y < 2);
        note("2 ball", x_m("runner") > -1.4_r);
        note("3 dominoes", run.state("domino_13").world_from_body.position.y < 0.94_r);
        note("4 magnets", x_m("second_ball") > 1.35_r);
        note("5 charge", x_m("bob") < 3.3_r);
        note("6 vase", !there("vase"));
        for (const std::string& message : run.simulation->messages)
            note("7 lamp", message == "The machine ran through");
    }
    passage.hash = run.simulation->state_hash();
    return passage;
}

TEST(Workshop, TheMachineRunsThroughInItsOrderTheSameWayEveryTime) {
    const Passage first = run_machine();
    ASSERT_EQ(first.at_s.size(), 7U);
    double before_s = 0;
    for (const auto& [stage, at_s] : first.at_s) {
        EXPECT_GT(at_s, before_s) << stage;
        before_s = at_s;
    }
    EXPECT_EQ(run_machine().hash, first.hash);
}

class WorkshopSetting : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, WorkshopSetting, testing::Values(50, 120, 240));

TEST_P(WorkshopSetting, RunsThroughAtOtherRatesToo) {
    const Passage as_is = run_machine();
    const Passage other = run_machine({.step_hz = GetParam()});
    ASSERT_EQ(other.at_s.size(), 7U);
    // The weight falls when it did, to a step; what follows hangs on impacts.
    EXPECT_NEAR(other.at_s.at("1 weight"), as_is.at_s.at("1 weight"), 0.05);
    EXPECT_NEAR(other.at_s.at("6 vase"), as_is.at_s.at("6 vase"), 0.5);
}

}  // namespace
}  // namespace plumbline
