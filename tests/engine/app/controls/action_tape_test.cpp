#include "engine/app/controls/action_tape.h"

#include "engine/core/hash.h"
#include "engine/core/io/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace plumbline::app {
namespace {

const TapeHeader kHeader{.scene = "a.toml",
                         .scene_hash = "0011",
                         .precision = "float32",
                         .step_s = 1.0 / 60.0,
                         .seed = 3};

/// One a process: tests run side by side.
std::filesystem::path tape_file() {
    return std::filesystem::path(testing::TempDir()) /
           ("action_tape_test_" + std::to_string(getpid()) + ".tape");
}

bool same(const Actions& a, const Actions& b) {
    return a.held == b.held && a.pressed == b.pressed && a.amount == b.amount &&
           a.look_yaw_rad == b.look_yaw_rad && a.look_pitch_rad == b.look_pitch_rad &&
           a.pointer == b.pointer;
}

TapeState state(std::uint64_t hash, std::vector<std::uint16_t> bodies = {}) {
    TapeState made{.hash = hash, .bodies = std::move(bodies)};
    for (std::uint32_t i = 0; i < 60; ++i)
        made.steps.push_back(i * 77 + static_cast<std::uint32_t>(hash));
    return made;
}

TEST(ActionTape, GivesBackEveryBitOfARandomSitting) {
    RandomActions random_input(11);
    std::vector<Actions> made;
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 500; ++step) {
        if (step == 100) recorder.add_request(step, "again");
        made.push_back(random_input.next());
        recorder.add_step(step, made.back());
        if ((step + 1) % 60 == 0) recorder.add_state(step + 1, state(step * 7919));
    }
    ASSERT_TRUE(recorder.save(tape_file(), 500, 42).ok());

    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    for (std::uint64_t step = 0; step < 500; ++step) {
        const TapePlayer::Told told = player->step(step);
        EXPECT_EQ(told.requests.size(), step == 100 ? 1U : 0U);
        EXPECT_TRUE(same(told.actions, made[step])) << "step " << step;
        const std::optional<TapeState> there = player->state_after(step + 1);
        EXPECT_EQ(there.has_value(), (step + 1) % 60 == 0 || step == 499) << step;
        if ((step + 1) % 60 != 0 || !there) continue;
        EXPECT_EQ(there->hash, step * 7919);
        EXPECT_EQ(there->steps, state(step * 7919).steps);
    }
    EXPECT_TRUE(player->ended(500));
    EXPECT_FALSE(player->ended(499));
    EXPECT_EQ(player->seed(), 3U);
}

TEST(ActionTape, KeepsEveryBodysFingerprint) {
    TapeRecorder recorder(kHeader);
    recorder.add_state(60, state(1, {10, 20, 30}));
    recorder.add_state(120, state(2, {10, 21, 30, 40}));
    recorder.add_state(180, state(3, {10, 21}));
    ASSERT_TRUE(recorder.save(tape_file(), 180, 3).ok());
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    EXPECT_EQ(player->state_after(60)->bodies, (std::vector<std::uint16_t>{10, 20, 30}));
    EXPECT_EQ(player->state_after(120)->bodies, (std::vector<std::uint16_t>{10, 21, 30, 40}));
    EXPECT_EQ(player->state_after(180)->bodies, (std::vector<std::uint16_t>{10, 21}));
}

TEST(ActionTape, AKeyThatIsHeldIsWrittenOnce) {
    TapeRecorder recorder(kHeader);
    TapeRecorder empty(kHeader);
    ASSERT_TRUE(empty.save(tape_file(), 0, 1).ok());
    const auto empty_bytes = std::filesystem::file_size(tape_file());
    Actions walking;
    walking.held[static_cast<std::size_t>(Action::Forward)] = true;
    walking.amount[static_cast<std::size_t>(Action::Forward)] = 1.0F;
    for (std::uint64_t step = 0; step < 1000; ++step) recorder.add_step(step, walking);
    recorder.add_step(1000, {});
    ASSERT_TRUE(recorder.save(tape_file(), 1001, 1).ok());
    EXPECT_LT(std::filesystem::file_size(tape_file()), empty_bytes + 150U);
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok());
    for (std::uint64_t step = 0; step < 1000; ++step)
        ASSERT_TRUE(same(player->step(step).actions, walking)) << step;
    EXPECT_TRUE(same(player->step(1000).actions, {}));
}

// SOURCES A33: what a free pointer was on is told bit for bit, and only when it moves.
TEST(ActionTape, AFreePointerIsWrittenWhereItMoves) {
    TapeRecorder recorder(kHeader);
    TapeRecorder empty(kHeader);
    ASSERT_TRUE(empty.save(tape_file(), 0, 1).ok());
    const auto empty_bytes = std::filesystem::file_size(tape_file());
    std::vector<Actions> made(40);
    for (std::size_t step = 10; step < 30; ++step) made[step].pointer = {0.1F / 3.0F, -0.7F};
    made[20].pointer = {1.25F, 0.333F};
    made[20].pressed[index_of(Action::Shoot)] = 1;
    for (std::size_t step = 0; step < made.size(); ++step) recorder.add_step(step, made[step]);
    ASSERT_TRUE(recorder.save(tape_file(), made.size(), 1).ok());
    EXPECT_LT(std::filesystem::file_size(tape_file()), empty_bytes + 300U);
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok());
    for (std::size_t step = 0; step < made.size(); ++step)
        EXPECT_TRUE(same(player->step(step).actions, made[step])) << step;
}

// Twenty minutes of random play were 55 MB.
TEST(ActionTape, TwentyMinutesOfRandomPlayAreBelowFifteenMegabytes) {
    RandomActions random_input(5);
    TapeRecorder recorder(kHeader);
    constexpr std::uint64_t kSteps = 7'200;  // two minutes stand for them
    for (std::uint64_t step = 0; step < kSteps; ++step) {
        recorder.add_step(step, random_input.next());
        if ((step + 1) % 60 == 0) recorder.add_state(step + 1, state(step));
    }
    ASSERT_TRUE(recorder.save(tape_file(), kSteps, 1).ok());
    EXPECT_LT(std::filesystem::file_size(tape_file()), 15'000'000U / 10U);
}

TEST(ActionTape, AFullTapeEndsAtItsLatestStateAndIsGoodUpToThere) {
    TapeRecorder recorder(kHeader, {}, 20'000);
    RandomActions random_input(5);
    for (std::uint64_t step = 0; step < 6'000; ++step) {
        recorder.add_step(step, random_input.next());
        if ((step + 1) % 60 == 0) recorder.add_state(step + 1, state(step + 1));
    }
    ASSERT_TRUE(recorder.save(tape_file(), 6'000, 1).ok());
    EXPECT_LT(std::filesystem::file_size(tape_file()), 40'000U);
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    std::uint64_t steps = 0;
    std::uint64_t hash = 0;
    while (!player->ended(steps)) {
        player->step(steps++);
        if (const auto there = player->state_after(steps)) hash = there->hash;
    }
    EXPECT_LT(steps, 6'000U);
    EXPECT_EQ(steps % 60, 0U);
    EXPECT_EQ(hash, steps);
}

/// What a player says to these bytes.
Error refusal(const std::string& bytes) {
    const Result<TapePlayer> player = TapePlayer::from(bytes, "a.tape", kHeader);
    return player.ok() ? Error{} : player.error();
}

/// The bytes of a recording with `steps` steps of random input.
std::string random_tape(std::uint64_t steps, std::size_t bytes_beside_end = 0) {
    RandomActions random_input(2);
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < steps; ++step) recorder.add_step(step, random_input.next());
    EXPECT_TRUE(recorder.save(tape_file(), steps, 1).ok());
    return *read_file(tape_file(), 1 << 20) + std::string(bytes_beside_end, 'x');
}

/// Where the header's record of a recording ends, and that of its end begins.
std::size_t header_bytes() {
    constexpr std::size_t kEndBytes = 16 + 1 + 8 + 8;
    return random_tape(0).size() - kEndBytes;
}

// EXPERIENCE E7
TEST(ActionTape, RefusesANewerFormatAndAnotherSceneByName) {
    std::string newer = random_tape(1);
    newer[8] = 4;
    EXPECT_EQ(refusal(newer).message,
              "a.tape: a recording of format 4; this program reads format 3");
    EXPECT_EQ(refusal(R"({"format":2,"scene":"b.toml"})").message,
              "a.tape: a recording of an earlier version, which this program does not read");
    EXPECT_EQ(refusal("hello").message,
              "a.tape: not a recording: it does not begin with \"PLUMTAPE\"");
    EXPECT_EQ(refusal(newer).exit_code, ExitCode::Differs);
    TapeHeader other = kHeader;
    other.scene = "b.toml";
    other.scene_hash = "22";
    const Result<TapePlayer> player = TapePlayer::from(random_tape(1), "a.tape", other);
    ASSERT_FALSE(player.ok());
    EXPECT_EQ(player.error().message, "a.tape: recorded in the scene a.toml, this one is b.toml");
}

// Records with the right checksum, whose fields no recorder writes.
TEST(ActionTape, HostileLinesAreRefused) {
    const auto said = [](std::uint8_t kind, auto... fields) {
        Archive body;
        std::uint64_t step = 1;
        body(kind, step, fields...);
        Hasher hasher;
        hasher.add(body.written().data(), body.written().size());
        auto size = static_cast<std::uint32_t>(body.written().size());
        std::uint32_t turned = ~size;
        std::uint64_t sum = hasher.digest();
        Archive head;
        head(size, turned, sum);
        return refusal(random_tape(0).substr(0, header_bytes()) + head.written() + body.written())
            .message;
    };
    constexpr std::uint8_t kStep = 1;
    constexpr std::uint8_t kState = 3;
    constexpr std::uint8_t kEnd = 4;
    const std::array<float, 2> level{};
    // One change: number of the action, held, pressed, amount; then the look and no pointer.
    const auto change = [&](std::uint8_t action, double amount, std::array<float, 2> look) {
        return said(kStep, std::uint64_t{1}, action, true, std::uint8_t{1}, amount, look, false);
    };
    EXPECT_EQ(change(0, 1, level), "");
    EXPECT_TRUE(change(0, 1e7, level).ends_with(": 10000000 is no amount"));
    EXPECT_TRUE(change(0, 1e300, level).ends_with(": a number is not finite"));
    EXPECT_TRUE(change(250, 1, level).ends_with(": there is no action 250"));
    EXPECT_TRUE(change(0, 1, {0, 2e6F}).ends_with(": 2000000 is no angle"));
    EXPECT_TRUE(said(9).ends_with(": a choice is none of those there are"));
    EXPECT_TRUE(said(kStep, ~std::uint64_t{0}).ends_with(": its state ends early"));
    EXPECT_TRUE(said(kState, std::uint64_t{7}, std::uint64_t{1} << 40U)
                    .ends_with(": its state ends early"));
    EXPECT_TRUE(
        said(kEnd, std::uint64_t{0}, std::uint8_t{0}).ends_with(": it goes on after its end"));
}

// EXPERIENCE E6
TEST(ActionTape, AFlippedByteIsRefused) {
    const std::string whole = random_tape(30);
    for (std::size_t at = 0; at < whole.size(); at += 11) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 1);
        EXPECT_FALSE(refusal(flipped).message.empty()) << "flipped at " << at;
    }
    EXPECT_FALSE(refusal(random_tape(5, 1)).message.empty());
}

TEST(ActionTape, ASceneNameThatIsNoTextStillGivesATape) {
    TapeHeader odd = kHeader;
    odd.scene = "caf\xe9.toml";
    TapeRecorder recorder(odd);
    ASSERT_TRUE(recorder.save(tape_file(), 1, 1).ok());
    EXPECT_TRUE(TapePlayer::open(tape_file(), odd).ok());
}

TEST(ActionTape, RefusesWhatBelongsElsewhereAndNamesBothSides) {
    TapeRecorder recorder(kHeader);
    ASSERT_TRUE(recorder.save(tape_file(), 1, 1).ok());
    TapeHeader other = kHeader;
    other.precision = "float64";
    const Result<TapePlayer> player = TapePlayer::open(tape_file(), other);
    ASSERT_FALSE(player.ok());
    EXPECT_EQ(player.error().exit_code, ExitCode::Differs);
    EXPECT_NE(player.error().message.find("recorded with precision float32, this run has float64"),
              std::string::npos)
        << player.error().message;
}

// `play --record` left nothing behind a crash: the file was written at the end.
TEST(ActionTape, EveryTruncationIsGoodUpToThere) {
    RandomActions random_input(2);
    std::vector<Actions> made;
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 20; ++step) {
        made.push_back(random_input.next());
        recorder.add_step(step, made.back());
    }
    ASSERT_TRUE(recorder.save(tape_file(), 20, 1).ok());
    const std::string whole = *read_file(tape_file(), 1 << 20);
    std::uint64_t most = 0;
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        Result<TapePlayer> player = TapePlayer::from(whole.substr(0, size), "a.tape", kHeader);
        if (!player.ok()) {
            EXPECT_EQ(most, 0U) << "refused at " << size;
            continue;
        }
        EXPECT_FALSE(player->whole());
        EXPECT_GE(player->steps(), most);
        most = player->steps();
        for (std::uint64_t step = 0; step < most; ++step)
            ASSERT_TRUE(same(player->step(step).actions, made[step])) << size << ": " << step;
    }
    EXPECT_EQ(most, 20U);
}

TEST(ActionTape, GrowsWithEveryStepAndIsGoodWhereverTheProgramIsKilled) {
    std::filesystem::remove(tape_file());
    TapeRecorder recorder(kHeader, tape_file());
    EXPECT_FALSE(std::filesystem::exists(tape_file())) << "nothing was recorded";
    Actions walking;
    walking.held[index_of(Action::Forward)] = true;
    recorder.add_step(3, walking);
    const auto killed = [] {
        Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
        EXPECT_TRUE(player.ok()) << player.error().message;
        EXPECT_FALSE(player->whole());
        return player->steps();
    };
    EXPECT_EQ(killed(), 4U);
    recorder.add_request(9, "hour 12");
    EXPECT_EQ(killed(), 9U);
    recorder.add_state(60, state(7));
    EXPECT_EQ(killed(), 60U);
    ASSERT_TRUE(recorder.save(tape_file(), 75, 1).ok());
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok());
    EXPECT_TRUE(player->whole() && player->ended(75) && !player->ended(74));
    for (std::uint64_t step = 0; step < 12; ++step) {
        const TapePlayer::Told told = player->step(step);
        EXPECT_EQ(told.actions.is_held(Action::Forward), step >= 3) << step;
        EXPECT_EQ(told.requests.size(), step == 9 ? 1U : 0U) << step;
        if (step == 9) {
            EXPECT_EQ(told.requests.front(), "hour 12");
        }
    }
}

TEST(ActionTape, WhatCannotBeWrittenIsSaidAtTheEnd) {
    TapeRecorder recorder(kHeader, tape_file().parent_path() / "no such folder" / "a.tape");
    recorder.add_step(0, {});
    const Result<Done> saved =
        recorder.save(tape_file().parent_path() / "no such folder" / "a.tape", 1, 1);
    ASSERT_FALSE(saved.ok());
    EXPECT_NE(saved.error().message.find("the recording could not be kept: No such file"),
              std::string::npos)
        << saved.error().message;
}

}  // namespace
}  // namespace plumbline::app
