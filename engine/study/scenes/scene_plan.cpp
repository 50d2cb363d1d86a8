#include "engine/study/scenes/scene_plan.h"

#include "engine/core/process/interrupt.h"
#include "engine/core/time/stopwatch.h"

#include <algorithm>

namespace plumbline::study {
namespace {

/// Beyond a run's own limit of CPU time: loading, sharing a core, handing over.
constexpr double kLimitFactor = 3.0;
constexpr double kLimitExtra_s = 60.0;

ScenePlan::Finished finished(std::size_t run, const Answer& answer) {
    if (answer.status != RunStatus::Done)
        return {.run = run, .status = answer.status, .why = answer.body};
    Result<SceneAnswer> parsed = parse_scene_answer(answer.body);
    if (!parsed) return {.run = run, .status = RunStatus::Refused, .why = parsed.error().message};
    return {.run = run, .answer = std::move(*parsed)};
}

}  // namespace

ScenePlan::ScenePlan(double wall_limit_s, Workers workers, ReportProgress report)
    : start_s_(wall_s()),
      wall_s_(wall_limit_s),
      expected_s_(wall_limit_s),
      workers_(std::move(workers)),
      report_(std::move(report)) {
    workers_.count = std::max(1, workers_.count);
}

double ScenePlan::spent_s() const {
    return wall_s() - start_s_;
}

double ScenePlan::share_of_core() const {
    return in_wall_s_ > 0 ? std::clamp(got_cpu_s_ / in_wall_s_, 0.05, 1.0) : 1.0;
}

double ScenePlan::cpu_left_s(double share_of_wall) const {
    return std::max(0.0, share_of_wall * wall_s_ - spent_s()) * workers_.count * share_of_core();
}

void ScenePlan::extend_for(double cpu_s, double most) {
    const double longer = std::clamp(cpu_s / std::max(cpu_left_s(), 1e-9), 1.0, most);
    if (longer > 1) extend(spent_s() + longer * left_s());
}

void ScenePlan::expect(double cpu_s) {
    const double left_cpu_s = std::max(cpu_left_s(), 1e-9);
    expected_s_ = spent_s() + left_s() * std::min(1.0, cpu_s / left_cpu_s);
}

void ScenePlan::report() const {
    if (!report_) return;
    const double spent = spent_s();
    const double left = std::max(0.0, expected_s_ - spent);
    report_({.share = spent / std::max(spent + left, 1e-9), .left_s = left});
}

Result<Done> ScenePlan::run(std::span<const SceneRun> runs,
                            const std::function<void(const Finished&)>& done) {
    if (interrupted_ || runs.empty()) return Done{};
    std::vector<Job> jobs;
    for (const SceneRun& run : runs) {
        const int passes = run.copies + run.repeats;
        jobs.push_back(
            {.kind = "scene",
             .body = scene_job_body(run),
             .precision = run.setting.precision,
             .limit_s = kLimitExtra_s + kLimitFactor * run.cpu_limit_s * passes / share_of_core()});
    }
    report();
    const Result<bool> all = run_jobs(jobs, workers_, [&](std::size_t job, const Answer& answer) {
        const Finished result = finished(job, answer);
        got_cpu_s_ += result.answer.cpu_s;
        in_wall_s_ += result.answer.wall_s;
        done(result);
        report();
    });
    if (!all) return all.error();
    interrupted_ = !*all;
    return Done{};
}

}  // namespace plumbline::study
