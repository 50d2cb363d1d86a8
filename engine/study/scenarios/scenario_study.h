// The study of the scenarios: the grid of settings, the runs in workers, and their findings.
#pragma once

#include "engine/core/result.h"
#include "engine/study/scenarios/scenario.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

enum class Effort {
    Quick,  ///< two solvers, four step rates: minutes less, for a first look and for CI
    Full,
};

/// The settings that a scenario is run at: each parameter varies alone, from the same default.
std::vector<Setting> grid_of(const Scenario& scenario, Effort effort);

struct ScenarioStudyOptions {
    std::vector<const Scenario*> scenarios;
    Effort effort{Effort::Full};
    std::optional<Shard> shard{};  ///< its runs only
    int workers{1};
    /// After every run: the share of all that is done, and seconds left.
    std::function<void(double share, double left_s)> progress{};
};

struct ScenarioStudy {
    std::vector<Subject> subjects;  ///< those with any run done, in the order asked for
    std::size_t runs{0};            ///< of the whole, whoever does them
    double clock_spread{0};         ///< as in Findings
    bool complete{true};            ///< false: interrupted
};
/// Median over the points of (median-min)/min of their repeats.
double clock_spread_of(std::span<const Subject> subjects);
/// Refused: the programs are not beside this one.
Result<ScenarioStudy> study_scenarios(const ScenarioStudyOptions& options);

/// The kind "scenario".
Result<std::string> run_scenario_job(const std::string& body);

}  // namespace plumbline::study
