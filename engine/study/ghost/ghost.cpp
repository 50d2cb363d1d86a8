#include "engine/study/ghost/ghost.h"

#include "engine/scene/simulation/entity_lookup.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "engine/study/workers/job.h"
#include "engine/study/workers/worker.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>

namespace plumbline::study {
namespace {

constexpr double kHistory_s = 20;
/// Simulated time between two questions: fine enough to be drawn, coarse enough to cost nothing.
constexpr double kGhostObservedEvery_s = 1.0 / 30;
/// A ghost so far behind will not come back.
constexpr double kLongestLag_s = 30;

}  // namespace

struct Ghost::Impl {
    /// The visible world at an instant that the ghost has yet to reach.
    struct Observation {
        double time_s{0};
        double cpu_ms{0};  ///< of the steps since the look before
        std::vector<Vec3d> positions_m;
    };

    Setting setting;
    std::optional<ChildProcess> worker;
    std::string received;
    bool waiting{false};  ///< for an answer
    bool ready{false};    ///< the first answer came
    std::deque<Observation> observations;
    double observed_s{0};
    double cpu_ms{0};
    double asked_s{0};  ///< where the ghost is or is on its way to
    GhostState latest;
    std::vector<physics::BodyId> bodies;
    std::vector<GhostDistance> history;
    std::string failure;

    void ask(const std::string& body) {
        waiting = worker->send_line(job_line({.kind = "ghost", .body = body}));
        if (!waiting) fail(fmt::format("its process {}", worker->end().words));
    }
    void ask_next() {
        if (waiting || observations.empty() || !failure.empty()) return;
        const double seconds = observations.front().time_s - asked_s;
        asked_s = observations.front().time_s;
        ask(go_on_body(seconds));
    }
    void fail(const std::string& why) {
        failure = why;
        worker.reset();
        observations.clear();
    }
    void take(GhostState state);
};

void Ghost::Impl::take(GhostState state) {
    latest = std::move(state);
    // The answer to the start belongs to no look.
    if (observations.empty() ||
        latest.time_s < observations.front().time_s - kGhostObservedEvery_s / 4)
        return;
    const Observation observed = std::move(observations.front());
    observations.pop_front();
    GhostDistance distance{.time_s = observed.time_s};
    const std::size_t count = std::min(observed.positions_m.size(), latest.bodies.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double apart = glm::distance(observed.positions_m[i], latest.bodies[i].position_m);
        distance.largest_m = std::max(distance.largest_m, apart);
        distance.mean_m += apart / static_cast<double>(count);
    }
    distance.visible_ms_per_s = observed.cpu_ms / kGhostObservedEvery_s;
    distance.ghost_ms_per_s = latest.cpu_ms / kGhostObservedEvery_s;
    history.push_back(distance);
    if (history.front().time_s < observed.time_s - kHistory_s) history.erase(history.begin());
}

Ghost::Ghost() : impl_(std::make_unique<Impl>()) {}
Ghost::~Ghost() = default;

Result<std::unique_ptr<Ghost>> Ghost::start(scene::Simulation& simulation, const Setting& setting) {
    const WorkerPrograms programs = sibling_programs();
    if (const Result<Done> there = check_programs(programs, std::array{setting.precision}); !there)
        return there.error();
    Result<ChildProcess> worker = start_worker(programs, setting.precision);
    if (!worker) return worker.error();
    std::unique_ptr<Ghost> ghost(new Ghost);
    Impl& impl = *ghost->impl_;
    impl.setting = setting;
    impl.worker.emplace(std::move(*worker));
    GhostStart start{
        .scene = simulation.description().file, .setting = setting, .time_s = simulation.time_s()};
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (!simulation.physics.contains(moving.body)) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        impl.bodies.push_back(moving.body);
        start.bodies.push_back({.name = name_of_mark(simulation, scene::mark_of(moving.entity)),
                                .position_m = Vec3d(state.world_from_body.position),
                                .orientation = Quatd(state.world_from_body.orientation)});
    }
    Archive archive;
    serialize_bodies_of_scene(simulation, archive);
    start.state = archive.take();
    impl.latest = {.time_s = start.time_s, .bodies = start.bodies};
    impl.observed_s = impl.asked_s = start.time_s;
    impl.ask(start_body(start));
    return ghost;
}

void Ghost::follow(const scene::Simulation& simulation) {
    Impl& impl = *impl_;
    if (!impl.failure.empty()) return;
    impl.cpu_ms += simulation.physics.report().cost.total_ms;
    if (simulation.time_s() < impl.observed_s + kGhostObservedEvery_s - simulation.step_s() / 4)
        return;
    impl.observed_s = simulation.time_s();
    Impl::Observation observed{.time_s = impl.observed_s, .cpu_ms = impl.cpu_ms};
    impl.cpu_ms = 0;
    for (std::size_t i = 0; i < impl.bodies.size(); ++i) {
        const bool there = simulation.physics.contains(impl.bodies[i]);
        observed.positions_m.push_back(
            there ? Vec3d(simulation.physics.state(impl.bodies[i]).world_from_body.position)
                  : impl.latest.bodies[i].position_m);
    }
    impl.observations.push_back(std::move(observed));
    if (behind_s() > kLongestLag_s)
        impl.fail(fmt::format("it fell {:g} s behind: too fine for this machine", kLongestLag_s));
    impl.ask_next();
}

void Ghost::take_answers() {
    Impl& impl = *impl_;
    while (impl.waiting && impl.failure.empty()) {
        if (!impl.worker->has_output()) return;
        const bool open = impl.worker->receive(impl.received);
        const std::size_t end = impl.received.find('\n');
        if (end == std::string::npos) {
            if (!open) impl.fail(fmt::format("its process {}", impl.worker->end().words));
            return;
        }
        const Result<Answer> answer = parse_answer_line(impl.received.substr(0, end));
        impl.received.erase(0, end + 1);
        impl.waiting = false;
        if (!answer || answer->status != AnswerStatus::Done)
            return impl.fail(answer ? answer->body : answer.error().message);
        Result<GhostState> state = parse_ghost_state(answer->body);
        if (!state || state->bodies.size() != impl.bodies.size())
            return impl.fail(state ? "its bodies are not ours" : state.error().message);
        impl.ready = true;
        impl.take(std::move(*state));
        impl.ask_next();
    }
}

bool Ghost::ready() const {
    return impl_->ready;
}
const GhostState& Ghost::latest() const {
    return impl_->latest;
}
std::span<const physics::BodyId> Ghost::bodies() const {
    return impl_->bodies;
}
std::span<const GhostDistance> Ghost::history() const {
    return impl_->history;
}
const Setting& Ghost::setting() const {
    return impl_->setting;
}
double Ghost::behind_s() const {
    return impl_->observations.empty() ? 0
                                       : impl_->observations.back().time_s - impl_->latest.time_s;
}
const std::string& Ghost::failure() const {
    return impl_->failure;
}

}  // namespace plumbline::study
