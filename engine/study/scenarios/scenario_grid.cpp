#include "engine/study/scenarios/scenario_study.h"

#include <algorithm>

namespace plumbline::study {
namespace {

using physics::Solver;

constexpr int kGameHz = 60;
/// Where knobs other than sub-steps are turned.
constexpr int kMiddleSubsteps = 4;
constexpr int kBulletIterations = 10;

class Grid {
public:
    explicit Grid(const Knobs& knobs) : knobs_(knobs) {}

    void rates(Setting setting) {
        for (int hz = 30; hz <= knobs_.most_hz; hz *= 2) {
            if (hz < knobs_.least_hz) continue;
            setting.step_hz = hz;
            add(setting);
        }
    }
    void substeps(Setting setting, std::initializer_list<int> values) {
        if (!knobs_.substeps) return;
        for (const int value : values) {
            setting.substeps = value;
            add(setting);
        }
    }
    void iterations(Setting setting, std::initializer_list<int> values) {
        if (!knobs_.iterations) return;
        for (const int value : values) {
            setting.iterations = value;
            add(setting);
        }
    }
    std::vector<Setting> take() { return std::move(settings_); }

private:
    void add(const Setting& setting) {
        if (std::ranges::find(settings_, setting) == settings_.end()) settings_.push_back(setting);
    }
    const Knobs& knobs_;
    std::vector<Setting> settings_;
};

Setting bullet(Solver solver) {
    return {.solver = solver,
            .step_hz = kGameHz,
            .substeps = 1,
            .substeps_max = 1,
            .iterations = kBulletIterations};
}

Setting doubled(Setting setting) {
    setting.precision = Precision::Float64;
    return setting;
}

std::vector<Setting> quick_grid(const Scenario& scenario) {
    Knobs knobs = scenario.knobs;
    knobs.most_hz = std::min(480, knobs.most_hz);
    knobs.least_hz = std::max(knobs.least_hz, knobs.most_hz / 8);  // three halvings
    Grid grid(knobs);
    grid.rates({});
    grid.rates(bullet(Solver::BulletSi));
    return grid.take();
}

}  // namespace

std::vector<Setting> grid_of(const Scenario& scenario, Effort effort) {
    if (effort == Effort::Quick) return quick_grid(scenario);
    const Setting on_demand{};
    const Setting fixed{.substeps = kMiddleSubsteps};
    Grid grid(scenario.knobs);
    grid.rates(on_demand);
    if (scenario.knobs.substeps) {
        grid.rates(fixed);
        grid.substeps(fixed, {1, 2, 4, 8, 16});
    }
    grid.iterations(fixed, {1, 2, 4, 8});
    if (scenario.knobs.doubled) grid.rates(doubled(scenario.knobs.substeps ? fixed : on_demand));
    for (const Solver solver :
         {Solver::BulletSi, Solver::BulletNncg, Solver::BulletDantzig, Solver::BulletPgs}) {
        grid.rates(bullet(solver));
        // Dantzig's method is direct, and bullet_pgs sweeps the same rows as bullet_si.
        if (solver == Solver::BulletSi || solver == Solver::BulletNncg)
            grid.iterations(bullet(solver), {10, 20, 40, 80});
        if (solver == Solver::BulletSi && scenario.knobs.doubled)
            grid.rates(doubled(bullet(solver)));
    }
    return grid.take();
}

}  // namespace plumbline::study
