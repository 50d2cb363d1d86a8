// Runs the steps that a frame owes, whoever asks for their actions: the person at the keys, a
// recording, or random input; records them with what was changed between them, and checks a replay's
// hashes as it goes.
#pragma once

#include "engine/app/controls/action_tape.h"
#include "engine/app/frame_report.h"
#include "engine/app/session.h"
#include "engine/input/action_latch.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace plumbline::app {

struct StepperDef {
    std::filesystem::path replay{};              ///< empty: none
    std::filesystem::path record{};              ///< grows with every step; empty: none
    std::optional<std::uint64_t> random_seed{};  ///< --random-input
    std::uint64_t seed{1};                       ///< of the simulation, noted in recordings
    std::uint64_t first_step{0};  ///< where the session's saved game stood; 0: at the start
};

class Stepper {
public:
    /// Refuses a recording that does not belong to the session.
    static Result<Stepper> create(Session& session, const StepperDef& def);

    /// Called after every step; may be empty.
    std::function<void()> after_step;

    /// Up to `count` fixed steps, no further one once they have taken `budget_s` of wall time; how
    /// many there were. The latch gives the person's actions; replays and random input only drain it.
    int run(int count, double budget_s, input::ActionLatch& latch, FrameReport& report);
    /// Does it before the next step, and records it. Refused in a replay, which does its own.
    Result<Done> apply(const WorldRequest& request);
    /// The session has read another scene, or a saved game: steps count on from here, and so does the
    /// recording.
    void begin_anew(std::uint64_t first_step = 0);

    bool replaying() const { return player_.has_value(); }
    bool ended() const { return player_ && player_->ended(steps_); }
    std::uint64_t steps() const { return steps_; }
    /// What differed first in a replay, or empty.
    const std::string& divergence() const { return divergence_; }
    /// Presses per action that steps were told of.
    const std::array<std::uint64_t, kActionCount>& presses() const { return presses_; }

    Result<Done> save_recording(const std::filesystem::path& file);

private:
    Stepper(Session& session, const StepperDef& def);
    void step(input::ActionLatch& latch, FrameReport& report);
    Actions next_actions(input::ActionLatch& latch);
    void note_state();
    void check(const TapeState& here);
    void replay(const std::vector<std::string>& requests);
    void end_replay();
    Result<Done> change(WorldRequest request);

    Session* session_;
    std::uint64_t seed_;
    std::filesystem::path record_;
    TapeRecorder recorder_;
    std::optional<TapePlayer> player_;
    std::optional<RandomActions> random_actions_;
    std::uint64_t steps_;  ///< since the start, across resets
    std::array<std::uint64_t, kActionCount> presses_{};
    std::vector<std::uint32_t> prints_;  ///< of the states since the last one that was noted
    std::string divergence_;
};

}  // namespace plumbline::app
