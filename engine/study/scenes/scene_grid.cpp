#include "engine/study/scenes/scene_grid.h"

#include <algorithm>
#include <array>

namespace plumbline::study {
namespace {

using physics::Solver;

constexpr std::array kRates_hz{60, 30, 120, 240};
/// Sub-steps of small_step; 0: on demand.
constexpr std::array kSubsteps{0, 1, 2, 4, 8};

Setting small_step(int step_hz, int substeps) {
    return {.solver = Solver::SmallStep, .step_hz = step_hz, .substeps = substeps};
}

Setting bullet(Solver solver, int step_hz, int iterations) {
    return {.solver = solver, .step_hz = step_hz, .substeps = 1, .iterations = iterations};
}

/// All of one rate.
void add_rate(std::vector<Setting>& grid, int step_hz, GridSize size) {
    for (const int substeps : kSubsteps) grid.push_back(small_step(step_hz, substeps));
    grid.push_back(bullet(Solver::BulletSi, step_hz, 10));
    if (size == GridSize::Quick) return;
    grid.push_back(bullet(Solver::BulletSi, step_hz, 50));
    if (step_hz != 60 && step_hz != 240) return;
    for (const Solver solver : {Solver::BulletNncg, Solver::BulletDantzig, Solver::BulletPgs}) {
        grid.push_back(bullet(solver, step_hz, 10));
        grid.push_back(bullet(solver, step_hz, 50));
    }
    grid.push_back(small_step(step_hz, 4));
    grid.back().precision = Precision::Float64;
    grid.push_back(bullet(Solver::BulletSi, step_hz, 10));
    grid.back().precision = Precision::Float64;
}

}  // namespace

std::vector<Setting> scene_grid(GridSize size) {
    std::vector<Setting> grid;
    for (const int step_hz : kRates_hz) add_rate(grid, step_hz, size);
    return grid;
}

std::vector<Setting> with_fidelities(const Setting& setting,
                                     const std::vector<std::string>& effects) {
    std::vector<Setting> all;
    for (const scene::Fidelity fidelity : {scene::Fidelity::Draft, scene::Fidelity::Precise}) {
        Setting together = setting;
        for (const std::string& effect : effects) together.fidelity.push_back({effect, fidelity});
        all.push_back(together);
        if (effects.size() < 2) continue;
        for (const scene::EffectFidelity& each : together.fidelity) {
            all.push_back(setting);
            all.back().fidelity = {each};
        }
    }
    return all;
}

Setting reference_setting(int step_hz, const std::vector<std::string>& effects) {
    Setting setting = small_step(step_hz, 4);
    setting.precision = Precision::Float64;
    for (const std::string& effect : effects)
        setting.fidelity.push_back({effect, scene::Fidelity::Precise});
    return setting;
}

double guessed_cost(const Setting& setting) {
    double of_a_step = 1.0;
    if (setting.solver != Solver::SmallStep) {
        of_a_step = 0.6 + 0.02 * setting.iterations;
        if (setting.solver == Solver::BulletDantzig) of_a_step = 3.0;
    } else if (setting.substeps > 0) {
        of_a_step = 0.6 + 0.15 * setting.substeps;
    }
    if (setting.precision == Precision::Float64) of_a_step *= 1.3;
    for (const scene::EffectFidelity& each : setting.fidelity)
        of_a_step *= each.fidelity == scene::Fidelity::Precise ? 1.3 : 0.9;
    return of_a_step * setting.step_hz / 60.0;
}

double guessed_cost_of_study(GridSize size) {
    double sum = 6.0 * guessed_cost(reference_setting(120));
    for (const Setting& setting : scene_grid(size)) {
        if (setting.step_hz <= 120) sum += 1.3 * guessed_cost(setting);
    }
    return sum;
}

bool same_but_rate(const Setting& a, const Setting& b) {
    Setting at_rate_of_b = a;
    at_rate_of_b.step_hz = b.step_hz;
    return at_rate_of_b == b;
}

}  // namespace plumbline::study
