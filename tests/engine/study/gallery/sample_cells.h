// Small tables of stability, without a run.
#pragma once

#include "engine/study/gallery/stability.h"

#include <string>

namespace plumbline::study {

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

/// Two cases with two solvers: a pass, a clear failure, a failure, and one that has not run.
inline StabilityTable sample_table() {
    StabilityTable table = plan_table({entry("H01"), entry("H02")},
                                      {physics::Solver::SmallStep, physics::Solver::BulletSi},
                                      {60});
    table.runs[0].result = result(true, 0.63);
    table.runs[1].result = result(false, -3);
    table.runs[2].result = result(false, -0.25);
    return table;
}

/// The same with everything that a cell can tell.
inline StabilityTable awkward_table() {
    StabilityTable table = sample_table();
    table.complete = false;
    table.no_images = "no images: <why>";
    table.images[0] = "Ma";  // "TWE=" in base 64
    table.runs[0].result->interventions = {.braked_J = 0.25, .braked_islands = 2};
    table.runs[1].result = CaseResult{.why = "its worker <crashed>"};
    table.cases[1].hard.nightly = true;
    table.cases[1].hard.known_to_fail = "most & all";
    table.cases[1].hard.known_red = {{.rule = "sag_m", .reached = 2, .why = "not <yet>"},
                                     {.rule = "height_m", .gone = true, .why = "so"}};
    return table;
}

}  // namespace plumbline::study
