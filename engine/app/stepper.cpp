#include "engine/app/stepper.h"

#include "engine/core/hash.h"
#include "engine/core/log.h"

#include <fmt/format.h>

namespace plumbline::app {
namespace {

constexpr std::uint64_t kStepsBetweenHashes = 60;

TapeHeader header_of(const Session& session, std::uint64_t seed) {
    return {.scene = session.description.file.filename().string(),
            .scene_hash = hex_of(session.description.content_hash),
            .precision = kPrecisionName,
            .step_s = session.simulation->step_s(),
            .seed = seed};
}

}  // namespace

Stepper::Stepper(Session& session, const StepperDef& def)
    : session_(&session), recorder_(header_of(session, def.seed)) {
    if (def.random_seed) monkey_.emplace(*def.random_seed);
}

Result<Stepper> Stepper::create(Session& session, const StepperDef& def) {
    Stepper stepper(session, def);
    if (!def.replay.empty()) {
        Result<TapePlayer> player = TapePlayer::open(def.replay, header_of(session, def.seed));
        if (!player) return player.error();
        stepper.player_ = std::move(*player);
    }
    return stepper;
}

Actions Stepper::next_actions(input::ActionLatch& latch) {
    // Taken in any case, so that nothing of the person's waits for the end of a replay.
    const Actions person = latch.take();
    if (player_) return player_->actions_of(steps_);
    if (monkey_) return monkey_->next();
    return person;
}

void Stepper::run(int count, input::ActionLatch& latch, FrameReport& report) {
    for (int i = 0; i < count && !ended(); ++i) {
        if (player_ && player_->reset_before(steps_)) rebuild();
        const Actions actions = next_actions(latch);
        recorder_.add_step(steps_, actions);
        for (std::size_t a = 0; a < kActionCount; ++a) presses_[a] += actions.pressed[a];
        effects::advance(*session_->simulation, *session_->effects, *session_->game, actions);
        if (session_->judge) session_->judge->after_step(*session_->simulation);
        report.add_step(session_->simulation->physics.cost());
        if (after_step) after_step();
        ++steps_;
        if (steps_ % kStepsBetweenHashes == 0 || ended()) {
            const std::uint64_t hash = session_->simulation->state_hash();
            if (steps_ % kStepsBetweenHashes == 0) recorder_.add_hash(steps_, hash);
            check(hash);
        }
    }
}

void Stepper::check(std::uint64_t hash) {
    if (!player_ || !divergence_.empty()) return;
    const std::optional<std::uint64_t> recorded = player_->hash_after(steps_);
    if (!recorded || *recorded == hash) return;
    divergence_ = fmt::format(
        "the replay differs from its recording at or before step {}: state {} there, {} here",
        steps_,
        hex_of(*recorded),
        hex_of(hash));
    log_error("{}", divergence_);
}

void Stepper::rebuild() {
    recorder_.add_reset(steps_);
    if (const Result<Done> reset = session_->reset(); !reset)
        log_error("{}", reset.error().message);
}

void Stepper::reset() {
    if (!player_) rebuild();
}

Result<Done> Stepper::save_recording(const std::filesystem::path& file) const {
    return recorder_.save(file, steps_, session_->simulation->state_hash());
}

}  // namespace plumbline::app
