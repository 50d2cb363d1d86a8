#include "engine/app/action_tape.h"

#include "engine/core/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace plumbline::app {
namespace {

const TapeHeader kHeader{.scene = "a.toml",
                         .scene_hash = "0011",
                         .precision = "float32",
                         .step_s = 1.0 / 60.0,
                         .seed = 3};

std::filesystem::path tape_file() {
    return std::filesystem::path(testing::TempDir()) / "action_tape_test.tape";
}

bool same(const Actions& a, const Actions& b) {
    return a.held == b.held && a.pressed == b.pressed && a.amount == b.amount &&
           a.look_yaw_rad == b.look_yaw_rad && a.look_pitch_rad == b.look_pitch_rad;
}

TEST(ActionTape, GivesBackEveryBitOfARandomSitting) {
    RandomActions monkey(11);
    std::vector<Actions> made;
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 500; ++step) {
        made.push_back(monkey.next());
        recorder.add_step(step, made.back());
        if (step == 99) recorder.add_reset(100);
        if ((step + 1) % 60 == 0) recorder.add_hash(step + 1, step * 7919);
    }
    ASSERT_TRUE(recorder.save(tape_file(), 500, 42).ok());

    Result<TapePlayer> player = TapePlayer::open(tape_file(), kHeader);
    ASSERT_TRUE(player.ok()) << player.error().message;
    for (std::uint64_t step = 0; step < 500; ++step) {
        EXPECT_EQ(player->reset_before(step), step == 100);
        EXPECT_TRUE(same(player->actions_of(step), made[step])) << "step " << step;
        const std::optional<std::uint64_t> hash = player->hash_after(step + 1);
        if ((step + 1) % 60 == 0) {
            EXPECT_EQ(hash, step * 7919);
        }
    }
    EXPECT_TRUE(player->ended(500));
    EXPECT_FALSE(player->ended(499));
    EXPECT_EQ(player->hash_after(500), 42U);
    EXPECT_EQ(player->seed(), 3U);
}

TEST(ActionTape, TheSameSeedPlaysTheSameMonkey) {
    RandomActions a(5);
    RandomActions b(5);
    RandomActions other(6);
    bool all_same_as_other = true;
    for (int i = 0; i < 100; ++i) {
        const Actions now = a.next();
        EXPECT_TRUE(same(now, b.next()));
        all_same_as_other = all_same_as_other && same(now, other.next());
    }
    EXPECT_FALSE(all_same_as_other);
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
    RandomActions monkey(2);
    TapeRecorder recorder(kHeader);
    for (std::uint64_t step = 0; step < 20; ++step) recorder.add_step(step, monkey.next());
    ASSERT_TRUE(recorder.save(tape_file(), 20, 1).ok());
    const std::string whole = *read_file(tape_file(), 1 << 20);
    for (std::size_t size = 0; size + 1 < whole.size(); size += 7) {
        std::ofstream(tape_file(), std::ios::binary | std::ios::trunc) << whole.substr(0, size);
        EXPECT_FALSE(TapePlayer::open(tape_file(), kHeader).ok()) << "cut at " << size;
    }
}

}  // namespace
}  // namespace plumbline::app
