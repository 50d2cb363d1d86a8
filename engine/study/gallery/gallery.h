// The gallery of hard cases: one run of a case, and its result.
#pragma once

#include "engine/core/result.h"
#include "engine/physics/physics_world.h"
#include "engine/study/engine_setting.h"
#include "engine/study/gallery/hard_case_judge.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::study {

/// One run: the scene's own setting but for the solver and the rate.
struct CaseRun {
    std::filesystem::path scene;
    physics::Solver solver{physics::Solver::SmallStep};
    int step_hz{60};
    /// By another engine, at the same rate; `solver` counts for nothing then.
    std::optional<EngineSetting> engine{};
    double cpu_limit_s{60};  ///< of stepping; beyond it the run is given up
};

/// One rule of a run that ended, as the table shows it.
struct RuleResult {
    std::string text;
    Allowed allowed{};
    double value{0};  ///< the worst; no number where the body was gone
    double margin{0};
    bool passed{false};
    std::string worst_of;
    double worst_at_s{0};
};

struct CaseResult {
    bool ran{false};      ///< false: `why` says what went wrong, and it counts as failed
    bool refused{false};  ///< ... it was not begun
    bool passed{false};
    /// Time ran out before a rule had failed: neither passed nor failed, the machine was too slow.
    bool gave_up{false};
    std::string why;  ///< of a run that was given up, too
    double simulated_s{0};
    double cpu_ms_per_s{0};  ///< thread CPU time of stepping, per simulated second
    double step_ms_max{0};
    double work_per_s{0};  ///< row solves + contact points, per simulated second; no clock
    physics::Interventions interventions{};
    std::vector<RuleResult> rules;

    /// The rule with the smallest margin; null when nothing ran.
    const RuleResult* worst() const;
};

/// Runs it in this process, to the end of its time or to the first rule that fails for good.
/// Refused: what open_scene(), build() and the judge refuse; of another engine, what it lacks and rules that watch forces.
Result<CaseResult> run_case(const CaseRun& run);

/// The job kind "hard_case" (job.h): a CaseRun as JSON in, a CaseResult as JSON out.
Result<std::string> run_hard_case_job(const std::string& body);
std::string case_job_body(const CaseRun& run);
std::string case_result_json(const CaseResult& result);
/// Refused: text that is not what case_result_json() writes.
Result<CaseResult> parse_case_result(const std::string& json);

}  // namespace plumbline::study
