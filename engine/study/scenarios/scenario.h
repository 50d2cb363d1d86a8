// A scenario: a small world whose future is known, run at a setting and held against it.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/findings/order.h"
#include "engine/study/scenarios/world/scenario_world.h"
#include "engine/study/stepping_cost.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline::study {

/// How a scenario's worlds are stepped: once to be looked at, then again, only timed.
class Course {
public:
    enum class Mode { Looked, Timed };
    explicit Course(Mode mode) : mode_(mode) {}

    struct Hooks {
        /// Belongs to the run: forces, what drives kinematic bodies. Before step i, from 0.
        std::function<void(int i)> before{};
        /// Looks. Not called where the run is timed: what later worlds depend on is read off a world.
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

private:
    Mode mode_;
    RunStatus status_{RunStatus::Done};
    std::string why_;
    StepMeter meter_;
};

/// Which knobs are worth turning. The step rate always is.
struct Knobs {
    bool substeps{true};
    bool iterations{true};
    int most_hz{960};  ///< 30 times a power of two
    int least_hz{30};
    bool doubled{true};  ///< in float64 too
};

/// Errors of the metrics, in their order, all relative to their scale.
using Errors = std::vector<double>;

struct Scenario {
    std::string id;
    std::string title;
    std::string set_up;
    std::string reference;
    Tier tier{Tier::ClosedForm};
    std::vector<Metric> metrics;
    std::function<Errors(const Setting& setting, Course& course)> run;
    /// Of the first metric, for a semi-implicit Euler body at a step; none where it says nothing.
    std::function<double(double step_s)> euler_floor{};
    std::string peer_scene{};
    Knobs knobs{};
    TheoryOf theory{};
    std::vector<std::string> notes{};
};

/// All that the features allow, in the order of their ids.
const std::vector<Scenario>& scenarios();
/// Null where there is none.
const Scenario* scenario_of(const std::string& id);

/// Cases of the same catalogue that are not run, and why.
struct LeftOut {
    std::string_view what;
    std::string_view why;
};
std::span<const LeftOut> left_out();

// A family per file.
void add_flight(std::vector<Scenario>& all);
void add_tops(std::vector<Scenario>& all);
void add_pendulums(std::vector<Scenario>& all);
void add_chains(std::vector<Scenario>& all);
void add_bounces(std::vector<Scenario>& all);
void add_impacts(std::vector<Scenario>& all);
void add_sliding(std::vector<Scenario>& all);
void add_rolling(std::vector<Scenario>& all);
void add_supports(std::vector<Scenario>& all);
void add_leaving(std::vector<Scenario>& all);
void add_invariances(std::vector<Scenario>& all);
void add_peer_scenes(std::vector<Scenario>& all);

/// Runs it once to be looked at and, unless that went wrong, again and again to be timed.
Point run_scenario(const Scenario& scenario, const Setting& setting, const Repeats& repeats);

/// Of the step rate: 1 for bullet_*, which moves bodies by semi-implicit Euler, and what is given
/// for small_step.
TheoryOf orders_in_step(std::optional<double> small_step, std::optional<double> bullet);

}  // namespace plumbline::study
