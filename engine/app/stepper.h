// Runs the steps that a frame owes, whoever asks for their actions: the person at the keys, a
// recording, or a random monkey; writes them down, and checks a replay's hashes as it goes.
#pragma once

#include "engine/app/action_tape.h"
#include "engine/app/frame_report.h"
#include "engine/app/session.h"
#include "engine/input/action_latch.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace plumbline::app {

struct StepperDef {
    std::filesystem::path replay;                ///< empty: none
    std::optional<std::uint64_t> random_seed{};  ///< --random-input
    std::uint64_t seed{1};                       ///< of the simulation, noted in recordings
};

class Stepper {
public:
    /// Refuses a recording that does not belong to the session.
    static Result<Stepper> create(Session& session, const StepperDef& def);

    /// Called after every step; may be empty.
    std::function<void()> after_step;

    /// `count` fixed steps. The latch gives the person's actions; replays and monkeys only drain it.
    void run(int count, input::ActionLatch& latch, FrameReport& report);
    /// Builds the scene anew and notes it. In a replay the recording alone resets.
    void reset();

    bool replaying() const { return player_.has_value(); }
    bool ended() const { return player_ && player_->ended(steps_); }
    std::uint64_t steps() const { return steps_; }
    /// What differed first in a replay, or empty.
    const std::string& divergence() const { return divergence_; }
    /// Presses per action that steps were told of.
    const std::array<std::uint64_t, kActionCount>& presses() const { return presses_; }

    Result<Done> save_recording(const std::filesystem::path& file) const;

private:
    Stepper(Session& session, const StepperDef& def);
    Actions next_actions(input::ActionLatch& latch);
    void check(std::uint64_t hash);
    void rebuild();

    Session* session_;
    TapeRecorder recorder_;
    std::optional<TapePlayer> player_;
    std::optional<RandomActions> monkey_;
    std::uint64_t steps_{0};  ///< since the start, across resets
    std::array<std::uint64_t, kActionCount> presses_{};
    std::string divergence_;
};

}  // namespace plumbline::app
