#include "engine/study/scenarios/scenario.h"

#include "engine/core/process/process_memory.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {

Point run_scenario(const Scenario& scenario, const Setting& setting, const Repeats& repeats) {
    Point point{.setting = setting};
    reset_peak_resident_bytes();
    Stepper stepper(Stepper::Mode::Errors, setting);
    point.errors = scenario.run(stepper);
    point.status = stepper.status();
    if (point.status == RunStatus::Refused) {
        point.why = stepper.why_refused();
        return point;
    }
    PL_ASSERT(point.errors.size() == scenario.metrics.size(), "an error for every metric");
    if (point.status == RunStatus::Done &&
        !std::ranges::all_of(point.errors, [](double error) { return std::isfinite(error); }))
        point.status = RunStatus::NotFinite;
    if (point.status != RunStatus::Done) {
        point.why = point.status == RunStatus::Exploded ? "a body was faster than 1000 m/s"
                                                        : "a number of the state was not finite";
        point.errors.clear();
    }
    // The run that measured the errors has warmed up caches and the allocator.
    const auto lap = [&] {
        Stepper timed(Stepper::Mode::Time, setting);
        scenario.run(timed);
        return timed.lap();
    };
    point.cost = cost_of(take_laps(lap, repeats));
    point.cost.bodies = stepper.bodies();
    point.cost.peak_bytes = peak_resident_bytes();
    return point;
}

TheoryOf orders_in_step(std::optional<double> small_step, std::optional<double> bullet) {
    return [=](const Setting& setting, std::string_view knob) -> std::optional<double> {
        if (knob != "step rate") return std::nullopt;
        return setting.solver == physics::Solver::SmallStep ? small_step : bullet;
    };
}

}  // namespace plumbline::study
