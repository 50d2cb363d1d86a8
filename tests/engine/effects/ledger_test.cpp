#include "engine/effects/effect_runtime.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plumbline::effects {
namespace {

std::vector<LedgerLine> two_lines() {
    return {{.name = "fog",
             .called_for_by = {"[fog] (a.toml:3)", "switch fog"},
             .constructions = 2,
             .calls = 30,
             .cpu_ms = 0.5,
             .gpu_ms = -1,
             .bytes_cpu = 64,
             .bytes_gpu = 128},
            {.name = "continuous_collision", .called_for_by = {}}};
}

TEST(Ledger, JsonHasTheFieldsOfTheContract) {
    const nlohmann::json expected = {{{"name", "fog"},
                                      {"called_for_by", {"[fog] (a.toml:3)", "switch fog"}},
                                      {"constructions", 2},
                                      {"calls", 30},
                                      {"cpu_ms", 0.5},
                                      {"gpu_ms", -1},
                                      {"bytes_cpu", 64},
                                      {"bytes_gpu", 128}},
                                     {{"name", "continuous_collision"},
                                      {"called_for_by", nlohmann::json::array()},
                                      {"constructions", 0},
                                      {"calls", 0},
                                      {"cpu_ms", 0},
                                      {"gpu_ms", 0},
                                      {"bytes_cpu", 0},
                                      {"bytes_gpu", 0}}};
    EXPECT_EQ(nlohmann::json::parse(ledger_json(two_lines())), expected);
}

TEST(Ledger, TableIsAligned) {
    EXPECT_EQ(
        ledger_table(two_lines()),
        "effect                 made     calls     CPU ms     GPU ms   CPU bytes   GPU bytes  "
        "called for by\n"
        "fog                       2        30      0.500    unknown          64         128  "
        "[fog] (a.toml:3), switch fog\n"
        "continuous_collision      0         0      0.000      0.000           0           0  "
        "-\n");
}

}  // namespace
}  // namespace plumbline::effects
