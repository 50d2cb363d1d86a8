#include "engine/app/accuracy/accuracy_choice.h"

#include "engine/scene/accuracy.h"

#include <array>

namespace plumbline::app {
namespace {

using physics::Solver;

constexpr std::array<int, 5> kRates_hz{30, 60, 120, 240, 480};

void use_numbers(study::Setting& setting, const scene::Preset& preset) {
    const bool small = setting.solver == Solver::SmallStep;
    setting.substeps = small ? 0 : preset.bullet_substeps;
    setting.substeps_max = preset.small_most;
    setting.iterations = small ? preset.small_iterations : preset.bullet_iterations;
}

}  // namespace

std::span<const int> offered_rates_hz() {
    return kRates_hz;
}

study::Setting with_solver(study::Setting setting, Solver solver) {
    setting.solver = solver;
    use_numbers(setting, scene::preset_of("balanced"));
    return setting;
}

study::Setting with_preset(study::Setting setting, std::string_view name) {
    const scene::Preset& preset = scene::preset_of(name);
    setting.step_hz = preset.step_hz;
    use_numbers(setting, preset);
    return setting;
}

}  // namespace plumbline::app
