#include "engine/study/stepping_cost.h"

#include <algorithm>

namespace plumbline::study {
namespace {

/// The value below which the share `quantile` of them lies; 0 where there are none.
double quantile_of(std::vector<float> values, double quantile) {
    if (values.empty()) return 0;
    const auto place =
        static_cast<std::ptrdiff_t>(quantile * static_cast<double>(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(place)]);
}

}  // namespace

double work_of(const physics::StepCost& cost) {
    return static_cast<double>(cost.row_solves) + static_cast<double>(cost.contacts) +
           static_cast<double>(cost.pairs);
}

std::vector<Lap> take_laps(const std::function<Lap()>& lap, const Repeats& repeats) {
    std::vector<Lap> laps;
    double spent_s = 0;
    do {
        laps.push_back(lap());
        spent_s += laps.back().cpu_ms * 1e-3;
    } while (static_cast<int>(laps.size()) < repeats.wanted && spent_s < repeats.budget_s);
    return laps;
}

RunCost cost_of(std::span<const Lap> laps) {
    std::vector<const Lap*> by_time;
    for (const Lap& lap : laps) {
        if (lap.simulated_s > 0) by_time.push_back(&lap);
    }
    if (by_time.empty()) return {};
    std::ranges::sort(by_time, {}, &Lap::cpu_ms);
    const Lap& fastest = *by_time.front();
    const auto per_s = [](const Lap& lap) { return lap.cpu_ms / lap.simulated_s; };
    return {.ms_per_s_min = per_s(fastest),
            .ms_per_s_median = per_s(*by_time[by_time.size() / 2]),
            .ms_per_s_max = per_s(*by_time.back()),
            .repeats = static_cast<int>(by_time.size()),
            .step_ms_median = quantile_of(fastest.step_ms, 0.5),
            .step_ms_p99 = quantile_of(fastest.step_ms, 0.99),
            .work_per_s = fastest.work / fastest.simulated_s};
}

Result<RunCost> measure_stepping(const std::function<Result<Stepping>()>& make,
                                 int steps,
                                 const Repeats& repeats) {
    std::optional<Error> refused;
    const auto lap = [&]() -> Lap {
        const Result<Stepping> stepping = make();
        if (!stepping) {
            refused = stepping.error();
            return {};
        }
        StepMeter meter;
        meter.resume();
        for (int i = 0; i < steps; ++i) {
            stepping->step();
            meter.stepped(stepping->cost(), stepping->step_s);
        }
        meter.pause();
        return meter.lap();
    };
    lap();
    if (refused) return *refused;
    const std::vector<Lap> laps = take_laps(lap, repeats);
    if (refused) return *refused;
    return cost_of(laps);
}

}  // namespace plumbline::study
