#include "engine/study/scenes/scene_threads.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace plumbline::study {
namespace {

/// Runs for the clock of one number of threads, and the CPU time after which no other begins.
constexpr int kRepeats = 5;
constexpr double kRepeat_s = 10;

bool same_moment(const Moment& a, const Moment& b) {
    return std::ranges::equal(a.bodies, b.bodies, [](const BodyPose& p, const BodyPose& q) {
        return p.position_m == q.position_m && p.orientation == q.orientation && p.there == q.there;
    });
}

bool same_poses(const SceneAnswer& a, const SceneAnswer& b) {
    return std::ranges::equal(a.traces, b.traces, [](const Trace& of_a, const Trace& of_b) {
        return std::ranges::equal(of_a.moments, of_b.moments, same_moment);
    });
}

}  // namespace

Result<std::vector<ThreadsPoint>> measure_threads(ScenePlan& plan,
                                                  const SceneProbe& probe,
                                                  std::span<const int> threads) {
    std::vector<ThreadsPoint> points;
    std::optional<SceneAnswer> first;
    for (const int number : threads) {
        const SceneRun run{.scene = probe.scene,
                           .start = probe.start,
                           .threads = scene::thread_count(number),
                           .moments = probe.moments,
                           .repeats = kRepeats,
                           .repeat_s = kRepeat_s};
        ThreadsPoint point{.threads = run.threads};
        const Result<Done> done =
            plan.run(std::vector{run}, [&](const ScenePlan::Finished& finished) {
                point.status = finished.status;
                point.why = finished.why;
                if (finished.status != RunStatus::Done) return;
                const Trace& trace = finished.answer.traces.front();
                point.status = trace.status;
                point.why = trace.why;
                point.cost = finished.answer.cost;
                if (!first) first = finished.answer;
                point.same = same_poses(*first, finished.answer);
            });
        if (!done) return done.error();
        if (plan.interrupted()) break;
        points.push_back(std::move(point));
    }
    return points;
}

}  // namespace plumbline::study
