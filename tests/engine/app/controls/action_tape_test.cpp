#include "engine/app/controls/action_tape.h"

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
        if (step == 100) recorder.add_reset(step);
        made.push_back(random_input.next());
        recorder.add_step(step, made.back());
        if ((step + 1) % 60 == 0) recorder.add_state(step + 1, state(step * 7919));
    }
    ASSERT_TRUE(recorder.save(tape_file(), 500, 42).ok());

    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    for (std::uint64_t step = 0; step < 500; ++step) {
        const TapePlayer::Told told = player->step(step);
        EXPECT_EQ(told.reset, step == 100);
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

TEST(ActionTape, KeepsEveryBodysFingerprintAndWritesOnlyThoseThatChanged) {
    TapeRecorder recorder(kHeader);
    recorder.add_state(60, state(1, {10, 20, 30}));
    recorder.add_state(120, state(2, {10, 21, 30, 40}));
    recorder.add_state(180, state(3, {10, 21}));
    recorder.add_state(240, state(4, {10, 21, 99}));
    ASSERT_TRUE(recorder.save(tape_file(), 240, 4).ok());
    const std::string text = *read_file(tape_file(), 1 << 20);
    EXPECT_NE(text.find(R"("bodies":"1:0015 3:0028")"), std::string::npos) << text;

    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    EXPECT_EQ(player->state_after(60)->bodies, (std::vector<std::uint16_t>{10, 20, 30}));
    EXPECT_EQ(player->state_after(120)->bodies, (std::vector<std::uint16_t>{10, 21, 30, 40}));
    EXPECT_EQ(player->state_after(180)->bodies, (std::vector<std::uint16_t>{10, 21}));
    EXPECT_EQ(player->state_after(240)->bodies, (std::vector<std::uint16_t>{10, 21, 99}));
}

TEST(ActionTape, AKeyThatIsHeldIsWrittenOnce) {
    TapeRecorder recorder(kHeader);
    Actions walking;
    walking.held[static_cast<std::size_t>(Action::Forward)] = true;
    walking.amount[static_cast<std::size_t>(Action::Forward)] = 1.0F;
    for (std::uint64_t step = 0; step < 1000; ++step) recorder.add_step(step, walking);
    recorder.add_step(1000, {});
    ASSERT_TRUE(recorder.save(tape_file(), 1001, 1).ok());
    EXPECT_LT(std::filesystem::file_size(tape_file()), 600U);
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok());
    for (std::uint64_t step = 0; step < 1000; ++step)
        ASSERT_TRUE(same(player->step(step).actions, walking)) << step;
    EXPECT_TRUE(same(player->step(1000).actions, {}));
}

// SOURCES A33: what a free pointer was on is told bit for bit, and only when it moves.
TEST(ActionTape, AFreePointerIsWrittenWhereItMoves) {
    TapeRecorder recorder(kHeader);
    std::vector<Actions> made(40);
    for (std::size_t step = 10; step < 30; ++step) made[step].pointer = {0.1F / 3.0F, -0.7F};
    made[20].pointer = {1.25F, 0.333F};
    made[20].pressed[index_of(Action::Shoot)] = 1;
    for (std::size_t step = 0; step < made.size(); ++step) recorder.add_step(step, made[step]);
    ASSERT_TRUE(recorder.save(tape_file(), made.size(), 1).ok());
    const Result<std::string> text = read_file(tape_file(), 10'000);
    ASSERT_TRUE(text.ok());
    EXPECT_EQ(std::ranges::count(*text, '\n'), 1 + 4 + 1) << *text;
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
    TapeRecorder recorder(kHeader, 20'000);
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

// Recordings of people who have the version before.
TEST(ActionTape, ReadsFormatOne) {
    std::ofstream(tape_file(), std::ios::binary | std::ios::trunc)
        << R"({"format":1,"precision":"float32","scene":"a.toml","scene_hash":"0011","seed":3,"step_s":0.016666666666666666})"
        << "\n"
        << R"({"amount":{"forward":1.0},"held":["forward"],"n":1,"pressed":{"forward":1}})"
        << "\n"
        << R"({"held":["jump"],"look":[0.5,-0.25],"n":2})"
        << "\n"
        << R"({"n":4,"reset":true})"
        << "\n"
        << R"({"hash":"00000000000000ff","n":60})"
        << "\n"
        << R"({"end":true,"hash":"00000000000000aa","n":61})"
        << "\n";
    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    EXPECT_TRUE(same(player->step(0).actions, {}));
    EXPECT_TRUE(player->step(1).actions.is_held(Action::Forward));
    const Actions third = player->step(2).actions;
    EXPECT_FALSE(third.is_held(Action::Forward)) << "lines of format 1 are whole";
    EXPECT_TRUE(third.is_held(Action::Jump));
    EXPECT_EQ(third.look_yaw_rad, 0.5F);
    EXPECT_TRUE(same(player->step(3).actions, {}));
    EXPECT_TRUE(player->step(4).reset);
    for (std::uint64_t step = 5; step < 60; ++step) player->step(step);
    EXPECT_EQ(player->state_after(60)->hash, 0xFFU);
    player->step(60);
    EXPECT_EQ(player->state_after(61)->hash, 0xAAU);
    EXPECT_TRUE(player->ended(61));
}

// EXPERIENCE E7
TEST(ActionTape, RefusesANewerFormatAndAnotherSceneByName) {
    const auto refusal = [](const std::string& header) {
        std::ofstream(tape_file(), std::ios::binary | std::ios::trunc) << header << "\n";
        const Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
        EXPECT_EQ(player.error().exit_code, ExitCode::Differs);
        return player.error().message;
    };
    EXPECT_NE(
        refusal(R"({"format":3})").find("a recording of format 3; this program reads up to 2"),
        std::string::npos);
    EXPECT_NE(refusal(R"({"format":2,"scene":"b.toml","scene_hash":"22"})")
                  .find("recorded in the scene b.toml, this one is a.toml"),
              std::string::npos);
}

// EXPERIENCE E6
TEST(ActionTape, AFlippedByteIsRefused) {
    RandomActions random_input(2);
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 30; ++step) recorder.add_step(step, random_input.next());
    ASSERT_TRUE(recorder.save(tape_file(), 30, 1).ok());
    const std::string whole = *read_file(tape_file(), 1 << 20);
    for (std::size_t at = 0; at < whole.size() - 1; at += 11) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 1);
        std::ofstream(tape_file(), std::ios::binary | std::ios::trunc) << flipped;
        const Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
        // The end's own state and step have no witness but the replay itself.
        const bool in_last_line = at > whole.rfind('\n', whole.size() - 2);
        EXPECT_TRUE(!player.ok() || in_last_line) << "flipped at " << at;
    }
}

TEST(ActionTape, HostileLinesAreRefused) {
    const std::string header =
        R"({"format":2,"precision":"float32","scene":"a.toml","scene_hash":"0011","seed":3,"step_s":0.016666666666666666})";
    for (const std::string& line :
         {std::string(100'000, '['),
          std::string(R"({"n":1,"amount":{"forward":1e67}})"),
          std::string(R"({"n":1,"amount":{"forward":null}})"),
          std::string(R"({"n":1,"pressed":{"forward":1e67}})"),
          std::string(R"({"n":1,"pressed":{"forward":256}})"),
          std::string(R"({"n":1,"pressed":{"forward":-1}})"),
          std::string(R"({"n":1,"look":[1e300,0]})"),
          std::string(R"({"n":1e67})"),
          std::string(R"({"n":-1})"),
          std::string(R"({"n":1,"hash":"-1"})"),
          std::string(R"({"n":1,"hash":"12","steps":"0000000g","count":0})"),
          std::string(R"({"n":1,"hash":"12","steps":"","count":1,"bodies":"7:0000"})"),
          std::string("[]"),
          std::string("7")}) {
        std::ofstream(tape_file(), std::ios::binary | std::ios::trunc)
            << header << "\n"
            << line << "\n"
            << R"({"end":true,"hash":"aa","n":61})"
            << "\n";
        const Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
        ASSERT_FALSE(player.ok()) << line.substr(0, 80);
        EXPECT_EQ(player.error().exit_code, ExitCode::Differs);
        EXPECT_NE(player.error().message.find("line 2 is not a line of a recording"),
                  std::string::npos)
            << player.error().message;
    }
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

TEST(ActionTape, EveryTruncationIsRefusedNotCrashedOn) {
    RandomActions random_input(2);
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 20; ++step) recorder.add_step(step, random_input.next());
    ASSERT_TRUE(recorder.save(tape_file(), 20, 1).ok());
    const std::string whole = *read_file(tape_file(), 1 << 20);
    for (std::size_t size = 0; size + 1 < whole.size(); size += 7) {
        std::ofstream(tape_file(), std::ios::binary | std::ios::trunc) << whole.substr(0, size);
        EXPECT_FALSE(TapePlayer::open(tape_file(), kHeader).ok()) << "cut at " << size;
    }
}

}  // namespace
}  // namespace plumbline::app
