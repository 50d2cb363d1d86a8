#include "engine/study/setting.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

using physics::Solver;

/// Where islands choose their sub-steps, the least that the preset "balanced" gives them.
int least_substeps(const Setting& setting) {
    return std::min(scene::preset_of("balanced").small_least, setting.substeps_max);
}

bool on_demand(const Setting& setting) {
    return setting.solver == Solver::SmallStep && setting.substeps <= 0;
}

}  // namespace

std::string setting_text(const Setting& setting) {
    const std::string substeps =
        on_demand(setting) ? fmt::format("{}-{}", least_substeps(setting), setting.substeps_max)
                           : fmt::format("{}", std::max(1, setting.substeps));
    std::string text = fmt::format(
        "{} {} Hz x {}", physics::solver_name(setting.solver), setting.step_hz, substeps);
    if (setting.solver != Solver::SmallStep || setting.iterations != 1)
        text += fmt::format(", {} it", setting.iterations);
    text += fmt::format(", {}", word_of(setting.precision));
    return setting.fidelity.empty() ? text : text + ", " + fidelity_text(setting);
}

std::string fidelity_text(const Setting& setting) {
    std::string text;
    for (const scene::EffectFidelity& each : setting.fidelity)
        text +=
            fmt::format("{}{} {}", text.empty() ? "" : ", ", each.effect, word_of(each.fidelity));
    return text;
}

std::string accuracy_lines(const Setting& setting) {
    std::string lines = fmt::format(
        "solver = \"{}\"\nstep_hz = {}\n", physics::solver_name(setting.solver), setting.step_hz);
    if (on_demand(setting)) {
        lines += fmt::format(
            "substeps = {}\nsubsteps_max = {}\n", least_substeps(setting), setting.substeps_max);
    } else {
        lines += fmt::format("substeps = {}\n", std::max(1, setting.substeps));
    }
    lines += fmt::format("iterations = {}\n", setting.iterations);
    for (const scene::EffectFidelity& each : setting.fidelity)
        lines +=
            fmt::format("[effects.{}]\nfidelity = \"{}\"\n", each.effect, word_of(each.fidelity));
    return lines;
}

physics::WorldDef world_def(const Setting& setting) {
    const int substeps =
        on_demand(setting) ? least_substeps(setting) : std::max(1, setting.substeps);
    return {.step_s = 1.0 / setting.step_hz,
            .substeps = substeps,
            .substeps_max = on_demand(setting) ? setting.substeps_max : substeps,
            .iterations = setting.iterations,
            .solver = setting.solver};
}

scene::SimulationOverrides overrides(const Setting& setting) {
    const physics::WorldDef def = world_def(setting);
    return {.solver = def.solver,
            .step_hz = setting.step_hz,
            .substeps = def.substeps,
            .substeps_max = def.substeps_max,
            .iterations = def.iterations,
            .fidelity = setting.fidelity};
}

}  // namespace plumbline::study
