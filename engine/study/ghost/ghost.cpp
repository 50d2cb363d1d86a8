#include "engine/study/ghost/ghost.h"

#include "engine/scene/simulation/entity_lookup.h"
#include "engine/study/workers/worker.h"
#include "engine/study/workers/worker_pool.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace plumbline::study {
namespace {

constexpr double kHistory_s = 20;
/// Simulated time between two questions: fine enough to be drawn, coarse enough to cost nothing.
constexpr double kGhostObservedEvery_s = 1.0 / 30;
/// A ghost so far behind will not come back.
constexpr double kLongestLag_s = 30;

}  // namespace

void Ghost::ask(const std::string& body) {
    waiting_ = worker_->send_line(job_line({.kind = "ghost", .body = body}));
    if (!waiting_) fail(fmt::format("its process {}", worker_->end().words));
}

void Ghost::ask_next() {
    if (waiting_ || observations_.empty() || !failure_.empty()) return;
    const double seconds = observations_.front().time_s - asked_s_;
    asked_s_ = observations_.front().time_s;
    ask(go_on_body(seconds));
}

void Ghost::fail(const std::string& why) {
    failure_ = why;
    worker_.reset();
    observations_.clear();
}

void Ghost::take(GhostState state) {
    latest_ = std::move(state);
    // The answer to the start belongs to no look.
    if (observations_.empty() ||
        latest_.time_s < observations_.front().time_s - kGhostObservedEvery_s / 4)
        return;
    const Observation observed = std::move(observations_.front());
    observations_.pop_front();
    GhostDistance distance{.time_s = observed.time_s};
    const std::size_t count = std::min(observed.positions_m.size(), latest_.bodies.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double apart = glm::distance(observed.positions_m[i], latest_.bodies[i].position_m);
        distance.largest_m = std::max(distance.largest_m, apart);
        distance.mean_m += apart / static_cast<double>(count);
    }
    distance.visible_ms_per_s = observed.cpu_ms / kGhostObservedEvery_s;
    distance.ghost_ms_per_s = latest_.cpu_ms / kGhostObservedEvery_s;
    history_.push_back(distance);
    if (history_.front().time_s < observed.time_s - kHistory_s) history_.erase(history_.begin());
}

Result<Ghost> Ghost::start(scene::Simulation& simulation, const Setting& setting) {
    const WorkerPrograms programs = sibling_programs();
    if (const Result<Done> there = check_programs(programs, std::array{setting.precision}); !there)
        return there.error();
    Result<ChildProcess> worker = start_worker(programs, setting.precision);
    if (!worker) return worker.error();
    Ghost ghost(std::move(*worker), setting);
    GhostStart start{.scene = simulation.description().file,
                     .setting = setting,
                     .from = scene_start_of(simulation)};
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        if (!simulation.physics.contains(moving.body)) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        ghost.bodies_.push_back(moving.body);
        start.bodies.push_back({.name = name_of_mark(simulation, scene::mark_of(moving.entity)),
                                .position_m = Vec3d(state.world_from_body.position),
                                .orientation = Quatd(state.world_from_body.orientation)});
    }
    ghost.latest_ = {.time_s = start.from.time_s, .bodies = start.bodies};
    ghost.observed_s_ = ghost.asked_s_ = start.from.time_s;
    ghost.ask(start_body(start));
    return ghost;
}

void Ghost::follow(const scene::Simulation& simulation) {
    if (!failure_.empty()) return;
    cpu_ms_ += simulation.physics.report().cost.total_ms;
    if (simulation.time_s() < observed_s_ + kGhostObservedEvery_s - simulation.step_s() / 4) return;
    observed_s_ = simulation.time_s();
    Observation observed{.time_s = observed_s_, .cpu_ms = cpu_ms_};
    cpu_ms_ = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const bool there = simulation.physics.contains(bodies_[i]);
        observed.positions_m.push_back(
            there ? Vec3d(simulation.physics.state(bodies_[i]).world_from_body.position)
                  : latest_.bodies[i].position_m);
    }
    observations_.push_back(std::move(observed));
    if (behind_s() > kLongestLag_s)
        fail(fmt::format("it fell {:g} s behind: too fine for this machine", kLongestLag_s));
    ask_next();
}

void Ghost::take_answers() {
    while (waiting_ && failure_.empty()) {
        if (!worker_->has_output()) return;
        const bool open = worker_->receive(received_);
        const std::size_t end = received_.find('\n');
        if (end == std::string::npos) {
            if (!open) fail(fmt::format("its process {}", worker_->end().words));
            return;
        }
        const Result<Answer> answer = parse_answer_line(received_.substr(0, end));
        received_.erase(0, end + 1);
        waiting_ = false;
        if (!answer || answer->status != RunStatus::Done)
            return fail(answer ? answer->body : answer.error().message);
        Result<GhostState> state = parse_ghost_state(answer->body);
        if (!state || state->bodies.size() != bodies_.size())
            return fail(state ? "its bodies are not ours" : state.error().message);
        ready_ = true;
        take(std::move(*state));
        ask_next();
    }
}

double Ghost::behind_s() const {
    return observations_.empty() ? 0 : observations_.back().time_s - latest_.time_s;
}

}  // namespace plumbline::study
