// How the worlds of a scenario are stepped and timed.
#pragma once

#include "engine/physics/force_field.h"
#include "engine/study/scenarios/world/scenario_world.h"
#include "engine/study/stepping_cost.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline::study {

/// Steps a scenario's worlds: once to measure errors, then again to measure time.
class Stepper {
public:
    enum class Mode { Errors, Time };
    Stepper(Mode mode, const Setting& setting) : mode_(mode), setting_(setting) {}

    /// What its worlds are made at.
    const Setting& setting() const { return setting_; }

    struct Hooks {
        /// Belongs to the run: forces, what drives kinematic bodies. Before step i, from 0.
        std::function<void(int i)> before{};
        /// Forces by where bodies are and how they move, asked for in every sub-step.
        physics::ForceField* field{nullptr};
        /// Measures errors; not called where time is measured, so no later world may depend on it.
        std::function<void(int i)> after{};
        /// Ends the run early. Always asked, so let it be cheap.
        std::function<bool()> until{};
    };
    /// Steps for so long, rounded to whole steps.
    void run(ScenarioWorld& world, double seconds, const Hooks& hooks);
    void run(ScenarioWorld& world, double seconds) { run(world, seconds, Hooks{}); }

    /// For a world that cannot be made: the run is refused, and says why.
    std::vector<double> refuse(const Error& error) {
        status_ = RunStatus::Refused;
        why_ = error.message;
        return {};
    }

    /// Of all worlds so far: the worst that became of one.
    RunStatus status() const { return status_; }
    const std::string& why_refused() const { return why_; }
    const Lap& lap() const { return meter_.lap(); }
    std::size_t bodies() const { return bodies_; }  ///< of the world with the most that move

private:
    Mode mode_;
    Setting setting_;
    RunStatus status_{RunStatus::Done};
    std::string why_;
    std::size_t bodies_{0};
    StepMeter meter_;
};

}  // namespace plumbline::study
