#include "engine/study/report/setting_names.h"

#include <fmt/format.h>

namespace plumbline::study {

namespace {

/// " x 4", " x 2-16", ", 10 it"; nothing for what goes without saying.
std::string effort_text(const Setting& setting) {
    const physics::WorldDef def = world_def(setting);
    const bool is_ours = setting.solver == physics::Solver::SmallStep;
    std::string text;
    if (def.substeps_max > def.substeps) {
        text = fmt::format(" x {}-{}", def.substeps, def.substeps_max);
    } else if (is_ours || def.substeps > 1) {
        text = fmt::format(" x {}", def.substeps);
    }
    if (!is_ours || setting.iterations != 1) text += fmt::format(", {} it", setting.iterations);
    return text;
}

std::string_view precision_suffix(const Setting& setting) {
    return setting.precision == Precision::Float64 ? ", float64" : "";
}

}  // namespace

std::string short_setting(const Setting& setting) {
    return fmt::format("{} Hz{}", setting.step_hz, effort_text(setting));
}

std::string family_name(const Setting& setting) {
    return fmt::format("{}{}{}",
                       physics::solver_name(setting.solver),
                       effort_text(setting),
                       precision_suffix(setting));
}

std::string contender_name(const Setting& setting) {
    return fmt::format("{}{}", physics::solver_name(setting.solver), precision_suffix(setting));
}

}  // namespace plumbline::study
