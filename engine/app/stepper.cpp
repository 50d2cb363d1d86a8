#include "engine/app/stepper.h"

#include "engine/core/hash.h"
#include "engine/core/log.h"
#include "engine/core/time/stopwatch.h"
#include "engine/scene/simulation/entity_lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace plumbline::app {
namespace {

constexpr std::uint64_t kStepsBetweenHashes = 60;

TapeHeader header_of(const Session& session, std::uint64_t seed) {
    return {.scene = session.description().file.filename().string(),
            .scene_hash = hex_of(session.description().content_hash),
            .precision = kPrecisionName,
            .step_s = session.simulation->step_s(),
            .seed = seed};
}

/// Two bytes a moving body: of its pose and velocity bits, 0 for those that are gone.
std::vector<std::uint16_t> body_prints(const scene::Simulation& simulation) {
    std::vector<std::uint16_t> prints;
    prints.reserve(simulation.moving_bodies().size());
    for (const scene::MovingBody& moving : simulation.moving_bodies()) {
        prints.push_back(0);
        if (!simulation.physics.contains(moving.body)) continue;
        const physics::BodyState state = simulation.physics.state(moving.body);
        Hasher hasher;
        hasher.add(&state.world_from_body.position, sizeof(state.world_from_body.position));
        hasher.add(&state.world_from_body.orientation, sizeof(state.world_from_body.orientation));
        hasher.add(&state.velocity_mps, sizeof(state.velocity_mps));
        hasher.add(&state.angular_velocity_radps, sizeof(state.angular_velocity_radps));
        prints.back() = static_cast<std::uint16_t>(hasher.digest());
    }
    return prints;
}

/// "first after step 83".
std::string first_step_apart(const TapeState& there, const TapeState& here, std::uint64_t steps) {
    if (there.steps.size() == here.steps.size()) {
        const auto [first, ignored] = std::ranges::mismatch(there.steps, here.steps);
        const auto same = static_cast<std::size_t>(first - there.steps.begin());
        if (same < there.steps.size())
            return fmt::format("first after step {}", steps - there.steps.size() + same + 1);
    }
    return fmt::format("at or before step {}", steps);
}

/// "; body "crate" is elsewhere by step 120, and 3 more".
std::string bodies_apart(const TapeState& there,
                         const TapeState& here,
                         const scene::Simulation& simulation) {
    if (there.bodies.empty()) return {};
    if (there.bodies.size() != here.bodies.size())
        return fmt::format(
            "; {} moving bodies there, {} here", there.bodies.size(), here.bodies.size());
    std::string first;
    std::size_t more = 0;
    for (std::size_t i = 0; i < here.bodies.size(); ++i) {
        if (there.bodies[i] == here.bodies[i]) continue;
        if (!first.empty())
            ++more;
        else
            first = describe(simulation, simulation.moving_bodies()[i].entity);
    }
    if (first.empty()) return {};
    return fmt::format(
        "; {} is elsewhere{}", first, more > 0 ? fmt::format(", and {} more", more) : "");
}

}  // namespace

Stepper::Stepper(Session& session, const StepperDef& def)
    : session_(&session),
      seed_(def.seed),
      record_(def.record),
      recorder_(header_of(session, def.seed), def.record),
      steps_(def.first_step) {
    if (def.random_seed) random_actions_.emplace(*def.random_seed);
}

Result<Stepper> Stepper::create(Session& session, const StepperDef& def) {
    Stepper stepper(session, def);
    if (!def.replay.empty()) {
        Result<TapePlayer> player = TapePlayer::open(def.replay, header_of(session, def.seed));
        if (!player) return player.error();
        if (!player->whole())
            log_warning("{}: the recording breaks off after {} steps: it is replayed up to there",
                        def.replay.string(),
                        player->steps());
        stepper.player_ = std::move(*player);
        // Each line tells what changed since the one before.
        for (std::uint64_t step = 0; step < def.first_step; ++step) stepper.player_->step(step);
    }
    return stepper;
}

Actions Stepper::next_actions(input::ActionLatch& latch) {
    // Taken in any case, so that nothing of the person's waits for the end of a replay.
    const Actions person = latch.take();
    if (player_) {
        const TapePlayer::Told told = player_->step(steps_);
        replay(told.requests);
        return told.actions;
    }
    if (random_actions_) return random_actions_->next();
    return person;
}

int Stepper::run(int count, double budget_s, input::ActionLatch& latch, FrameReport& report) {
    const double start_s = wall_s();
    int done = 0;
    for (; done < count && !ended(); ++done) {
        if (done > 0 && wall_s() - start_s > budget_s) break;
        step(latch, report);
    }
    return done;
}

void Stepper::step(input::ActionLatch& latch, FrameReport& report) {
    const Actions actions = next_actions(latch);
    recorder_.add_step(steps_, actions);
    for (std::size_t a = 0; a < kActionCount; ++a) presses_[a] += actions.pressed[a];
    effects::advance(*session_->simulation, *session_->effects, *session_->game, actions);
    // A toggled grab that found or kept nothing is over.
    if (!session_->game->holds()) latch.release(Action::Grab);
    session_->warning_log.log_new(*session_->simulation);
    if (session_->judge) session_->judge->after_step(*session_->simulation);
    report.add_step(session_->simulation->physics.report().cost);
    if (after_step) after_step();
    ++steps_;
    note_state();
    if (ended()) end_replay();
}

void Stepper::replay(const std::vector<std::string>& requests) {
    for (const std::string& bytes : requests) {
        Archive archive(bytes);
        WorldRequest request;
        archive(request);
        const Result<Done> done =
            archive.failed() ? Error{.message = archive.fault()} : change(std::move(request));
        if (!done) log_error("replay, before step {}: {}", steps_, done.error().message);
    }
}

// What was changed after the last step belongs to the state at the end.
void Stepper::end_replay() {
    const std::vector<std::string> last = player_->step(steps_).requests;
    if (last.empty()) return;
    replay(last);
    check({.hash = session_->simulation->state_hash()});
}

void Stepper::note_state() {
    TapeState state{.hash = session_->simulation->state_hash()};
    prints_.push_back(static_cast<std::uint32_t>(state.hash ^ (state.hash >> 32U)));
    const bool due = steps_ % kStepsBetweenHashes == 0;
    if (!due && !ended()) return;
    state.steps = prints_;
    state.bodies = body_prints(*session_->simulation);
    check(state);
    if (!due) return;
    recorder_.add_state(steps_, state);
    prints_.clear();
}

void Stepper::check(const TapeState& here) {
    if (!player_ || !divergence_.empty()) return;
    const std::optional<TapeState> there = player_->state_after(steps_);
    if (!there || there->hash == here.hash) return;
    divergence_ = fmt::format("the replay differs from its recording {}: state {} there, {} here{}",
                              first_step_apart(*there, here, steps_),
                              hex_of(there->hash),
                              hex_of(here.hash),
                              bodies_apart(*there, here, *session_->simulation));
    log_error("{}", divergence_);
}

Result<Done> Stepper::change(WorldRequest request) {
    const Result<Done> done = session_->apply(request);
    if (!done) return done;
    Archive archive;
    archive(request);
    recorder_.add_request(steps_, archive.take());
    return done;
}

Result<Done> Stepper::apply(const WorldRequest& request) {
    if (player_) return Error{.message = "a replay runs: the scene stays as it was recorded"};
    return change(request);
}

void Stepper::begin_anew(std::uint64_t first_step) {
    recorder_ = TapeRecorder(header_of(*session_, seed_), record_);
    steps_ = first_step;
    prints_.clear();
}

Result<Done> Stepper::save_recording(const std::filesystem::path& file) {
    return recorder_.save(file, steps_, session_->simulation->state_hash());
}

}  // namespace plumbline::app
