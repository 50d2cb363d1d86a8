#include "engine/study/scenarios/scenario.h"

#include <algorithm>
#include <cmath>

namespace plumbline::study {
namespace {

// Nothing in the scenarios moves nearly as fast, and what is stepped once does not get there.
constexpr double kExploded_mps = 1e3;

RunStatus status_of(const ScenarioWorld& world) {
    if (world.broken()) return RunStatus::NotFinite;
    for (const physics::BodyId id : world.movers) {
        if (glm::length(world.velocity(id)) > kExploded_mps) return RunStatus::Exploded;
    }
    return RunStatus::Done;
}

}  // namespace

void Course::run(ScenarioWorld& world, double seconds, const Hooks& hooks) {
    const double step_s = world.step_s();
    const int steps = static_cast<int>(std::lround(seconds / step_s));
    const bool looks = mode_ == Mode::Looked;
    if (!looks) meter_.resume();
    for (int i = 0; i < steps; ++i) {
        if (hooks.before) hooks.before(i);
        world.physics.step();
        if (looks) {
            if (hooks.after) hooks.after(i);
        } else {
            meter_.stepped(world.physics.cost(), step_s);
        }
        if (hooks.until && hooks.until()) break;
    }
    if (!looks) meter_.pause();
    const RunStatus found = status_of(world);
    if (status_ == RunStatus::Done) status_ = found;
}

Point run_scenario(const Scenario& scenario, const Setting& setting, const Repeats& repeats) {
    Point point{.setting = setting};
    Course looked(Course::Mode::Looked);
    point.errors = scenario.run(setting, looked);
    point.status = looked.status();
    if (point.status == RunStatus::Refused) {
        point.why = looked.why_refused();
        return point;
    }
    PL_ASSERT(point.errors.size() == scenario.metrics.size(), "an error for every metric");
    if (point.status == RunStatus::Done &&
        !std::ranges::all_of(point.errors, [](double error) { return std::isfinite(error); }))
        point.status = RunStatus::NotFinite;
    if (point.status != RunStatus::Done) {
        point.why = point.status == RunStatus::Exploded ? "a body was faster than 1000 m/s"
                                                        : "a number of the state was none";
        point.errors.clear();
    }
    // The run that was looked at has warmed up caches and the allocator.
    const auto lap = [&] {
        Course timed(Course::Mode::Timed);
        scenario.run(setting, timed);
        return timed.lap();
    };
    point.cost = cost_of(take_laps(lap, repeats));
    return point;
}

TheoryOf orders_in_step(std::optional<double> small_step, std::optional<double> bullet) {
    return [=](const Setting& setting, std::string_view knob) -> std::optional<double> {
        if (knob != "step rate") return std::nullopt;
        return setting.solver == physics::Solver::SmallStep ? small_step : bullet;
    };
}

}  // namespace plumbline::study
