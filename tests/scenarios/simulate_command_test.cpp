// `simulate` from its options to its files: what is written, and that nothing but the scene and
// the settings decides the hash.

#include "game/commands/simulate_command.h"

#include "tests/scenarios/scene_run.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace plumbline::game {
namespace {

using nlohmann::json;
using test::TemporaryFolder;

/// Crates and a plank that come down on each other, a lift and a kill height.
constexpr const char* kBusyScene = R"(
[scene]
title = "Busy"
[world]
kill_below_m = -5
[[entity]]
name = "ground"
primitive = { box = [12, 1, 12] }
position_m = [0, -0.5, 0]
[entity.body]
kind = "static"
[[entity]]
name = "lift"
primitive = { box = [2, 0.2, 2] }
position_m = [4, 0.5, 0]
motion = { points_m = [[0, 0, 0], [0, 2, 0]], period_s = 3 }
[entity.body]
kind = "kinematic"
[[entity]]
name = "stray"
primitive = { sphere = 0.3 }
position_m = [30, 1, 0]
[entity.body]
kind = "dynamic"
mass_kg = 1
[[prefab]]
name = "crate"
primitive = { box = [1, 1, 1] }
[prefab.body]
kind = "dynamic"
mass_kg = 10
[[array]]
name = "heap"
prefab = "crate"
origin_m = [-1, 1.5, -1]
count = [3, 4, 2]
spacing_m = [0.95, 1.4, 1.3]
)";

class Simulate : public testing::Test {
protected:
    Simulate() {
        ::setenv("PLUMBLINE_DATA", PL_SOURCE_DIR, 1);
        options_.scene = folder_.write("busy.toml", kBusyScene).string();
        options_.seconds = 2;
        options_.state_file = folder_ / "state.json";
    }
    json state() const { return json::parse(folder_.read("state.json")); }
    std::string hash_of_run() {
        EXPECT_EQ(run_simulate(options_), ExitCode::Good);
        return state()["hash"];
    }

    TemporaryFolder folder_;
    SimulateOptions options_;
};

TEST_F(Simulate, GivesOneHashAtEveryFrameRate) {
    const std::string hash = hash_of_run();
    EXPECT_EQ(hash.size(), 16U);
    EXPECT_EQ(hash_of_run(), hash) << "a second run";
    for (const double fps : {15.0, 60.0, 144.0, 1000.0}) {
        options_.drive_fps = fps;
        EXPECT_EQ(hash_of_run(), hash) << fps << " frames a second";
        EXPECT_EQ(state()["lost_time_s"], 0.0) << fps << " frames a second";
    }
    options_.drive_fps.reset();
    options_.step_hz = 120;
    EXPECT_NE(hash_of_run(), hash) << "another step is another run";
}

TEST_F(Simulate, WritesTheStateOfTheEnd) {
    ASSERT_EQ(run_simulate(options_), ExitCode::Good);
    const json written = state();
    EXPECT_EQ(written["steps"], 120);
    EXPECT_DOUBLE_EQ(written["time_s"].get<double>(), 2.0);
    EXPECT_EQ(written["precision"], kPrecisionName);
    EXPECT_EQ(written["removed"], 1) << "the stray ball";
    EXPECT_EQ(written["bodies"].size(), 25U);
    EXPECT_EQ(written["bodies"][0]["name"], "lift");
    EXPECT_EQ(written["bodies"][1]["name"], "heap.0.0.0");
    EXPECT_EQ(written["bodies"][2]["name"], "heap.1.0.0");
    EXPECT_EQ(written["effects"].size(), effects::effect_table().size());
    EXPECT_GT(written["contacts"].size(), 10U);
    EXPECT_GT(written["cost"]["row_solves"], 0);
}

TEST_F(Simulate, TracesEveryInterval) {
    options_.trace_file = folder_ / "trace.jsonl";
    options_.trace_every_s = 0.5;
    ASSERT_EQ(run_simulate(options_), ExitCode::Good);
    std::istringstream lines(folder_.read("trace.jsonl"));
    std::vector<double> times_s;
    for (std::string line; std::getline(lines, line);) {
        times_s.push_back(json::parse(line)["time_s"]);
    }
    const std::vector<double> expected{0.0, 0.5, 1.0, 1.5, 2.0};
    EXPECT_EQ(times_s, expected);
}

TEST_F(Simulate, ComparesWithTheHashExpected) {
    options_.expect_hash = hash_of_run();
    EXPECT_EQ(run_simulate(options_), ExitCode::Good);
    options_.expect_hash = "0000000000000000";
    EXPECT_EQ(run_simulate(options_), ExitCode::Differs);
}

TEST_F(Simulate, RefusesWhatIsNoScene) {
    options_.scene = "no such scene";
    EXPECT_EQ(run_simulate(options_), ExitCode::Refused);
    options_.scene = folder_.write("bad.toml", "[scene]\ntitel = 3\n").string();
    EXPECT_EQ(run_simulate(options_), ExitCode::Refused);
    EXPECT_EQ(folder_.read("state.json"), "") << "nothing is written";
}

TEST_F(Simulate, SaysWhenAFileCannotBeWritten) {
    options_.state_file = folder_ / "no/such/folder/state.json";
    EXPECT_EQ(run_simulate(options_), ExitCode::RunFailed);
}

}  // namespace
}  // namespace plumbline::game
