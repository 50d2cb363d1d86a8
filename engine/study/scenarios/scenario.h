// A scenario: a small world whose exact motion is known; a run at a setting is compared with it.
#pragma once

#include "engine/study/findings/findings.h"
#include "engine/study/findings/order.h"
#include "engine/study/scenarios/world/stepper.h"

#include <functional>
#include <string>
#include <vector>

namespace plumbline::study {

/// Which parameters the grid varies. It always varies the step rate.
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
    std::function<Errors(Stepper& stepper)> run;
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
std::vector<Scenario> flight_family();
std::vector<Scenario> tops_family();
std::vector<Scenario> pendulums_family();
std::vector<Scenario> chains_family();
std::vector<Scenario> bounces_family();
std::vector<Scenario> impacts_family();
std::vector<Scenario> sliding_family();
std::vector<Scenario> rolling_family();
std::vector<Scenario> supports_family();
std::vector<Scenario> leaving_family();
std::vector<Scenario> invariances_family();
std::vector<Scenario> peer_scenes_family();

/// Runs it once to measure errors and, unless that run was refused, several times to measure time.
Point run_scenario(const Scenario& scenario, const Setting& setting, const Repeats& repeats);

/// Of the step rate: 1 for bullet_*, which moves bodies by semi-implicit Euler, and what is given
/// for small_step.
TheoryOf orders_in_step(std::optional<double> small_step, std::optional<double> bullet);

}  // namespace plumbline::study
