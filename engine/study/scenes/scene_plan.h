// The time budget of a scene's study: how much wall time is left on the workers, predicted from what
// runs cost so far. It also hands runs to workers.
#pragma once

#include "engine/study/scenes/scene_run.h"
#include "engine/study/workers/worker_pool.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumbline::study {

struct StudyProgress {
    double share{0};  ///< 0…1 of the time it will probably take
    double left_s{0};
};
using ReportProgress = std::function<void(const StudyProgress&)>;

class ScenePlan {
public:
    ScenePlan(double wall_s, Workers workers, ReportProgress report);

    int workers() const { return workers_.count; }
    double spent_s() const;
    double left_s() const { return wall_s_ - spent_s(); }
    /// CPU time that all workers together have left, or would have at a share of the wall time, if
    /// they go on to get as much of their cores as so far.
    double cpu_left_s(double share_of_wall = 1.0) const;
    void extend(double wall_s) { wall_s_ = expected_s_ = wall_s; }
    /// Until so much CPU time is left, but not for more than `most` times the wall time left so far.
    void extend_for(double cpu_s, double most);
    /// The rest of the study will probably take so much CPU time: what the progress tells.
    void expect(double cpu_s);
    bool interrupted() const { return interrupted_; }

    /// Runs them all, and hands each answer over as it comes.
    struct Finished {
        std::size_t run{0};
        RunStatus status{RunStatus::Done};
        std::string why{};  ///< of a status other than Done: there is no answer
        SceneAnswer answer{};
    };
    Result<Done> run(std::span<const SceneRun> runs,
                     const std::function<void(const Finished&)>& done);

private:
    void report() const;
    /// What a worker got of its core so far: CPU time by wall time.
    double share_of_core() const;

    double start_s_;
    double wall_s_;
    double expected_s_;
    Workers workers_;
    ReportProgress report_;
    bool interrupted_{false};
    double got_cpu_s_{0};
    double in_wall_s_{0};
};

}  // namespace plumbline::study
