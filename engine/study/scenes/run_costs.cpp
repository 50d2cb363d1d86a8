#include "engine/study/scenes/run_costs.h"

#include "engine/study/scenes/scene_grid.h"

#include <fmt/format.h>

#include <algorithm>

namespace plumbline::study {
namespace {

constexpr double kHandling_s = 0.02;
constexpr int kCopiesLeast = 3;

}  // namespace

double RunCosts::of_one_s(const Setting& setting) const {
    for (const Point& point : points_) {
        if (point.status == RunStatus::Done && same_but_rate(point.setting, setting))
            return point.cost.ms_per_s_median * 1e-3 * seconds_ * setting.step_hz /
                   point.setting.step_hz;
    }
    if (!setting.fidelity.empty()) {
        Setting own = setting;
        own.fidelity.clear();
        return of_one_s(own) * guessed_cost(setting) / guessed_cost(own);
    }
    return guessed_cost(setting) * second_cpu_s_ * seconds_;
}

double RunCosts::of_all_s(const Setting& setting) const {
    const double one_s = of_one_s(setting);
    if (counts.chaotic) return counts.copies * one_s + kHandling_s;
    return one_s + std::min(counts.repeats * one_s, counts.repeat_s + one_s) + kHandling_s;
}

double RunCosts::sum_s(std::span<const Setting> settings) const {
    double sum_s = 0;
    for (const Setting& setting : settings) sum_s += of_all_s(setting);
    return sum_s;
}

void RunCosts::fit(std::span<const Setting> grid, double cpu_left_s) {
    if (counts.chaotic) {
        while (counts.copies > kCopiesLeast && sum_s(grid) > cpu_left_s) counts.copies -= 2;
    } else {
        while (counts.repeats > 0 && sum_s(grid) > cpu_left_s) --counts.repeats;
    }
}

std::string clock_note(std::span<const Point> points) {
    std::vector<double> spreads;
    for (const Point& point : points) {
        if (point.cost.repeats < 2 || point.cost.ms_per_s_min <= 0) continue;
        spreads.push_back(point.cost.ms_per_s_median / point.cost.ms_per_s_min - 1.0);
    }
    if (spreads.empty()) return {};
    std::ranges::sort(spreads);
    const double middle = spreads[spreads.size() / 2];
    if (middle <= 0.1) return {};
    return fmt::format(
        "noisy clock: half of the settings had a median {:.0f} % or more above their least time",
        middle * 100.0);
}

}  // namespace plumbline::study
