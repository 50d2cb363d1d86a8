// Where the actions of a step come from: the person, a recording, or chance. Whatever the source,
// what a step was told can be written down, and the file replays it bit for bit.
//
// File: one JSON object a line. First a header {format, scene, scene_hash, precision, step_s, seed};
// then steps in order, {n, held, pressed, amount, look} with only what is not zero, or
// {n, reset: true}; every 60 steps {n, hash}; at the end {n, end: true, hash}.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/random.h"
#include "engine/core/result.h"

#include <cstdint>
#include <filesystem>
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

/// One line of the file.
struct TapeEntry {
    std::uint64_t step{0};
    std::optional<Actions> actions{};
    std::optional<std::uint64_t> hash{};  ///< of the state after `step` steps
    bool reset{false};
    bool end{false};
};

/// Collects entries in memory; written atomically when asked, so that a crash loses no old file.
class TapeRecorder {
public:
    explicit TapeRecorder(const TapeHeader& header);
    void add_step(std::uint64_t step, const Actions& actions);  ///< idle steps cost nothing
    void add_reset(std::uint64_t step);
    void add_hash(std::uint64_t step, std::uint64_t hash);
    Result<Done> save(const std::filesystem::path& file,
                      std::uint64_t steps,
                      std::uint64_t hash) const;

private:
    std::string text_;
};

/// Plays a file back.
class TapePlayer {
public:
    /// Refuses what is not a recording, or one of another scene, precision or step (exit code 5,
    /// the message names both sides).
    static Result<TapePlayer> open(const std::filesystem::path& file, const TapeHeader& expected);

    /// Actions of the step that is number `step` since the start. Call with 0, 1, 2, …
    Actions actions_of(std::uint64_t step);
    bool reset_before(std::uint64_t step);
    /// The recorded state hash after so many steps, where the file has one.
    std::optional<std::uint64_t> hash_after(std::uint64_t steps) const;
    bool ended(std::uint64_t steps) const { return steps >= steps_; }
    std::uint64_t seed() const { return seed_; }

private:
    std::vector<TapeEntry> entries_;
    std::size_t next_{0};
    std::uint64_t steps_{0};
    std::uint64_t seed_{0};
};

/// A monkey: any action at any time, the same ones for the same seed (--random-input).
class RandomActions {
public:
    explicit RandomActions(std::uint64_t seed) : random_(seed) {}
    Actions next();

private:
    Random random_;
    Actions now_{};
};

}  // namespace plumbline::app
