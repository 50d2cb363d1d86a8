// What stepping costs: CPU time of its threads, time on the clock, and work counted without a clock.
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
    double cpu_ms{0};    ///< of all threads
    double clock_ms{0};  ///< from the first to the last of them
    double simulated_s{0};
    double work{0};
    std::vector<float>
        step_ms;  ///< on the wall: a thread's CPU clock costs as much as a small step
};

/// The work of a step, the same on every machine: row solves, contact points and pairs.
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
        const double step_ms = step_clock_.lap_ms();
        lap_.step_ms.push_back(static_cast<float>(step_ms));
        lap_.clock_ms += step_ms;
        lap_.cpu_ms += cost.helpers_ms;
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

/// Takes laps until their number or the budget is reached.
std::vector<Lap> take_laps(const std::function<Lap()>& lap, const Repeats& repeats);
/// Medians and percentiles are those of the fastest lap; of the longest step and frame of each lap it
/// is the shortest, which leaves out what other processes delayed. All zero where there is none.
RunCost cost_of(std::span<const Lap> laps);

}  // namespace plumbline::study
