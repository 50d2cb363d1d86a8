// A recording: what every step was told, whoever told it, in a file that replays it bit for bit.
//
// File: "PLUMTAPE", the format (u32), then records. A record is the size of its body (u32), that size
// with every bit turned round, the XXH3 of the body (u64), and the body: kind, step, and what stands in
// the kind's serialize(). The header comes first, then what happened in the order in which it did. A step
// without a record was told the same as the one before. Every 60 steps there is the state after so many,
// and at the end one record that says so. Records are appended as they are made: where a program was
// killed the end is missing, and the recording is good up to there.
#pragma once

#include "engine/core/actions.h"
#include "engine/core/io/archive.h"
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

    void serialize(Archive& archive) { archive(scene, scene_hash, precision, step_s, seed); }
};

/// Fingerprints of a state, short ones: they find where two runs parted, the full hash says that
/// they did.
struct TapeState {
    std::uint64_t hash{0};
    std::vector<std::uint32_t> steps{};   ///< one a step since the state before, the latest last
    std::vector<std::uint16_t> bodies{};  ///< one a moving body, in the simulation's order

    void serialize(Archive& archive) { archive(hash, steps, bodies); }
};

/// Appends what steps are told to a file, at once: however long the session, it takes no memory.
class TapeRecorder {
public:
    /// Beyond this much the recording ends, and is good up to there.
    static constexpr std::size_t kMostBytes = 250ULL * 1024 * 1024;

    /// `file` is made, in place of what is there, with the first record. Empty, or no regular file: a
    /// temporary file without a name stands for it, for save().
    explicit TapeRecorder(TapeHeader header,
                          std::filesystem::path file = {},
                          std::size_t most_bytes = kMostBytes);

    void add_step(std::uint64_t step,
                  const Actions& actions);  ///< steps like the last cost nothing
    /// What is done to the world before the step, in the caller's own form.
    void add_request(std::uint64_t step, std::string request);
    void add_state(std::uint64_t steps, TapeState state);

    /// What there is so far, ended after `steps`, where the state's hash is `hash`: the recorder's own
    /// file is closed by it, any other gets a copy, and the recording goes on.
    Result<Done> save(const std::filesystem::path& file, std::uint64_t steps, std::uint64_t hash);

private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    void add(const std::string& record);
    bool open();
    void fail();

    TapeHeader header_;
    std::filesystem::path file_;
    std::size_t most_bytes_;
    std::unique_ptr<std::FILE, CloseFile> out_;
    std::string fault_;  ///< why nothing more is written; empty: it is
    std::size_t bytes_{0};
    Actions before_{};
    /// The latest state, where a full recording ends.
    std::uint64_t state_after_{0};
    std::uint64_t state_hash_{0};
    bool full_{false};
};

struct TapeRecord;

/// Plays a file back. Holds its bytes, and reads a record when its step has come.
class TapePlayer {
public:
    /// Refuses what is no recording or a damaged one, and one of another scene, precision or step (exit
    /// code 5, the message names both sides).
    static Result<TapePlayer> open(const std::filesystem::path& file, const TapeHeader& expected);
    /// ... of bytes that are there already; `file` is for the message.
    static Result<TapePlayer> from(std::string bytes,
                                   const std::filesystem::path& file,
                                   const TapeHeader& expected);

    /// Before step number `step` since the start: what it is told, and what is done to the world before it,
    /// in order. Call with 0, 1, 2, …
    struct Told {
        Actions actions{};
        std::vector<std::string> requests{};
    };
    Told step(std::uint64_t step);
    /// The recorded state after so many steps, where the file has one. After step(steps - 1).
    std::optional<TapeState> state_after(std::uint64_t steps);
    bool ended(std::uint64_t steps) const { return steps >= steps_; }
    std::uint64_t steps() const { return steps_; }
    /// False: the end is missing, as after a crash.
    bool whole() const { return whole_; }
    std::uint64_t seed() const { return seed_; }

private:
    TapePlayer() = default;
    std::string read_header(const TapeHeader& expected);
    std::string read_all();
    std::optional<TapeRecord> peek(std::size_t& next, std::string& fault) const;
    Actions told_by(const TapeRecord& record) const;

    std::string bytes_;
    std::size_t at_{0};  ///< where the first record begins that was not played
    std::vector<std::optional<Action>> actions_;  ///< by the numbers that the file gives them
    std::uint64_t steps_{0};
    std::uint64_t seed_{0};
    bool whole_{false};
    Actions now_{};
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
