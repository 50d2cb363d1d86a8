// A small table of stability, without a run.
#pragma once

#include "engine/core/io/files.h"
#include "engine/study/gallery/stability.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace plumbline::study {

inline const std::filesystem::path kAssets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
inline const DataFolders kFolders{
    .assets = kAssets, .shaders = {}, .config = std::filesystem::path(PL_SOURCE_DIR) / "config"};

inline CaseEntry entry(const std::string& id) {
    CaseEntry made{.scene = id + ".toml", .title = "a <tower>"};
    made.hard.id = id;
    made.hard.shows = "It stands.";
    return made;
}

inline CaseResult result(bool passed, double margin) {
    return {.ran = true,
            .passed = passed,
            .simulated_s = 10,
            .cpu_ms_per_s = 1.5,
            .step_ms_max = 0.25,
            .work_per_s = 1000,
            .rules = {{.text = "sag_m at most 1",
                       .allowed = {Allowed::Kind::Below, 1, 0},
                       .value = 1 - margin,
                       .margin = margin,
                       .passed = passed,
                       .worst_of = "box",
                       .worst_at_s = 2}}};
}

class StabilityTableTest : public testing::Test {
protected:
    StabilityTableTest()
        : table(plan_table({entry("H01"), entry("H02")},
                           {physics::Solver::SmallStep, physics::Solver::BulletSi},
                           {60})) {
        table.runs[0].result = result(true, 0.63);
        table.runs[1].result = result(false, -3);
        table.runs[2].result = result(false, -0.25);
    }
    StabilityTable table;
};

}  // namespace plumbline::study
