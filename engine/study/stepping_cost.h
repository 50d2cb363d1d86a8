// What stepping costs: CPU time on the thread's own clock, and work counted without a clock.
#pragma once

#include "engine/core/result.h"
#include "engine/core/time/stopwatch.h"
#include "engine/study/findings/findings.h"

#include <functional>
#include <span>
#include <vector>

namespace plumbline::study {

/// One repeat of a run: all its steps.
struct Lap {
    double cpu_ms{0};
    double simulated_s{0};
    double work{0};
    std::vector<float>
        step_ms;  ///< on the wall: a thread's CPU clock costs as much as a small step
};

/// Row solves, contact points and pairs looked after: what a step did, whatever the machine.
double work_of(const physics::StepCost& cost);

/// Times the steps of one lap. CPU time counts between resume() and pause() only.
class StepMeter {
public:
    void resume() {
        start_s_ = thread_cpu_s();
        step_clock_.start();
    }
    /// After each step, which took the time since resume() or since the step before.
    void stepped(const physics::StepCost& cost, double step_s) {
        lap_.step_ms.push_back(static_cast<float>(step_clock_.lap_ms()));
        lap_.work += work_of(cost);
        lap_.simulated_s += step_s;
    }
    void pause() { lap_.cpu_ms += (thread_cpu_s() - start_s_) * 1e3; }
    const Lap& lap() const { return lap_; }

private:
    Lap lap_;
    LapTimer step_clock_;
    double start_s_{0};
};

/// How often a run is timed.
struct Repeats {
    int wanted{5};
    double budget_s{1};  ///< CPU time: fewer where so many would take longer, but at least one
};

/// Takes laps until there are enough, by the budget.
std::vector<Lap> take_laps(const std::function<Lap()>& lap, const Repeats& repeats);
/// Percentiles are those of the steps of the fastest lap. All zero where there is none.
RunCost cost_of(std::span<const Lap> laps);

/// Something that is stepped at a fixed rate: a world, or a scene with all that belongs to it.
struct Stepping {
    std::function<void()> step;
    std::function<const physics::StepCost&()> cost;  ///< of the latest step
    double step_s{0};
};
/// Makes it anew for every lap, after one that only warms caches up, and times `steps` steps.
Result<RunCost> measure_stepping(const std::function<Result<Stepping>()>& make,
                                 int steps,
                                 const Repeats& repeats);

}  // namespace plumbline::study
