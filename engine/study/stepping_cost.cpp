#include "engine/study/stepping_cost.h"

#include <algorithm>
#include <cmath>

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

/// What the steps of each frame took together, at kFrames_per_s. A step that is longer than a frame
/// is one frame's.
std::vector<float> frames_of(const Lap& lap) {
    const double steps_per_s = static_cast<double>(lap.step_ms.size()) / lap.simulated_s;
    const auto steps =
        std::max(std::size_t{1}, static_cast<std::size_t>(steps_per_s / kFrames_per_s + 0.5));
    std::vector<float> frames_ms;
    for (std::size_t i = 0; i < lap.step_ms.size(); ++i) {
        if (i % steps == 0) frames_ms.push_back(0);
        frames_ms.back() += lap.step_ms[i];
    }
    return frames_ms;
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
    const Lap& last = *by_time.back();
    std::ranges::sort(by_time, {}, [](const Lap* lap) { return lap->cpu_ms / lap->simulated_s; });
    const Lap& fastest = *by_time.front();
    const auto per_s = [](const Lap& lap) { return lap.cpu_ms / lap.simulated_s; };
    const std::vector<float> frames_ms = frames_of(fastest);
    double clock_ms_per_s = HUGE_VAL;
    double step_ms_max = HUGE_VAL;
    double frame_ms_max = HUGE_VAL;
    for (const Lap* lap : by_time) {
        clock_ms_per_s = std::min(clock_ms_per_s, lap->clock_ms / lap->simulated_s);
        step_ms_max = std::min(step_ms_max, quantile_of(lap->step_ms, 1));
        frame_ms_max = std::min(frame_ms_max, quantile_of(frames_of(*lap), 1));
    }
    return {.ms_per_s_min = per_s(fastest),
            .ms_per_s_median = per_s(*by_time[by_time.size() / 2]),
            .ms_per_s_max = per_s(*by_time.back()),
            .clock_ms_per_s = clock_ms_per_s,
            .repeats = static_cast<int>(by_time.size()),
            .step_ms_median = quantile_of(fastest.step_ms, 0.5),
            .step_ms_p99 = quantile_of(fastest.step_ms, 0.99),
            .step_ms_max = step_ms_max,
            .frame_ms_p99 = quantile_of(frames_ms, 0.99),
            .frame_ms_max = frame_ms_max,
            .work_per_s = last.work / last.simulated_s};
}

}  // namespace plumbline::study
