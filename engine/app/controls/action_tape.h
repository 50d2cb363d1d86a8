// Where the actions of a step come from: the person, a recording, or chance. Whatever the source,
// what a step was told can be written down, and the file replays it bit for bit.
//
// File: one JSON object a line. First a header {format, scene, scene_hash, precision, step_s, seed};
// then steps in order, {n, down, up, pressed, amount, look, pointer}: which actions went down and up,
// which amounts changed, how often each was pressed, how far the look turned in this step, and where
// a free pointer went to (null: there is none any more). A step
// without a line holds what the one before held. {n, reset: true} is before step n. Every 60 steps
// {n, hash, steps, bodies}: the state after n steps, eight hex digits of the hash after each of the
// latest steps, and "index:four digits" of every body whose fingerprint changed since the line
// before. At the end {n, end: true, hash, sum}, the sum being that of all lines above. Format 1, with {held, pressed, amount} whole in each line
// and no fingerprints, is read as well.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/random.h"
#include "engine/core/result.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::app {

/// What a recording belongs to. A replay with another header is refused.
struct TapeHeader {
    std::string scene;
    std::string scene_hash;
    std::string precision;
    double step_s{0};
    std::uint64_t seed{0};
};

/// Fingerprints of a state, short ones: they find where two runs parted, the full hash says that
/// they did.
struct TapeState {
    std::uint64_t hash{0};
    std::vector<std::uint32_t> steps;   ///< one a step since the state before, the latest last
    std::vector<std::uint16_t> bodies;  ///< one a moving body, in the simulation's order
};

/// Collects what steps were told, in a temporary file without a name: however long the session, it
/// takes no memory, and a killed program leaves nothing behind.
class TapeRecorder {
public:
    /// Beyond this much text the recording ends, and is good up to there.
    static constexpr std::size_t kMostBytes = 250ULL * 1024 * 1024;

    explicit TapeRecorder(const TapeHeader& header, std::size_t most_bytes = kMostBytes);

    void add_step(std::uint64_t step,
                  const Actions& actions);  ///< steps like the last cost nothing
    void add_reset(std::uint64_t step);
    /// `state.bodies` may grow and shrink; what stays the same costs nothing.
    void add_state(std::uint64_t steps, const TapeState& state);

    /// Writes what there is so far, ended after `steps`, where the state's hash is `hash`. It goes on.
    Result<Done> save(const std::filesystem::path& file, std::uint64_t steps, std::uint64_t hash);

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void add_line(const std::string& line);

    std::unique_ptr<std::FILE, CloseFile> spool_;
    std::string failed_;  ///< why nothing more is written; empty: it is
    std::size_t bytes_{0};
    std::size_t most_bytes_;
    Actions before_{};
    std::vector<std::uint16_t> bodies_;
    /// The latest state, where a full tape ends.
    std::uint64_t state_after_{0};
    std::uint64_t state_hash_{0};
    bool full_{false};
};

/// Plays a file back. Holds its text, and reads a line when its step has come.
class TapePlayer {
public:
    /// Refuses what is not a recording, or one of another scene, precision or step (exit code 5,
    /// the message names both sides).
    static Result<TapePlayer> open(const std::filesystem::path& file, const TapeHeader& expected);
    TapePlayer(TapePlayer&&) noexcept;
    TapePlayer& operator=(TapePlayer&&) noexcept;
    ~TapePlayer();

    /// Before step number `step` since the start: what it is told, and whether the scene is built
    /// anew for it. Call with 0, 1, 2, …
    struct Told {
        Actions actions{};
        bool reset{false};
    };
    Told step(std::uint64_t step);
    /// The recorded state after so many steps, where the file has one. After step(steps - 1).
    std::optional<TapeState> state_after(std::uint64_t steps);
    bool ended(std::uint64_t steps) const { return steps >= steps_; }
    std::uint64_t seed() const { return seed_; }

private:
    struct Line;
    TapePlayer();
    /// The first line that is not played, or null at the end. Throws where it is none.
    const Line* next();
    TapeState state_of(const Line& line);

    std::string text_;
    std::size_t at_{0};  ///< where the line after next_ begins
    std::unique_ptr<Line> next_;
    int format_{0};
    std::uint64_t steps_{0};
    std::uint64_t seed_{0};
    Actions now_{};
    std::vector<std::uint16_t> bodies_;
};

/// Random input: any action at any time, the same ones for the same seed (--random-input).
class RandomActions {
public:
    explicit RandomActions(std::uint64_t seed) : random_(seed) {}
    Actions next();

private:
    Random random_;
    Actions now_{};
};

}  // namespace plumbline::app
