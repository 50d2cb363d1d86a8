// What a mixer plays, by its samples.
#include "tests/engine/audio/offline_mixer.h"

#include <array>
#include <cstdlib>
#include <limits>

namespace plumbline::audio {
namespace {

/// Before OpenAL starts: no back end that could reach a sound card.
class NoSoundCard : public testing::Environment {
public:
    void SetUp() override { setenv("ALSOFT_DRIVERS", "none", 1); }
};
const testing::Environment* const kNoSoundCard = testing::AddGlobalTestEnvironment(new NoSoundCard);

class MixerTest : public OfflineMixer {};

TEST_F(MixerTest, WhatIsOnTheRightIsLouderOnTheRight) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    const Heard heard = frame({cue(sound, {3.0F, 0.0F, 0.0F})});
    EXPECT_GT(heard.right, 0.02);
    EXPECT_GT(heard.right, 3.0 * heard.left);
}

TEST_F(MixerTest, TurningRoundSwapsTheSides) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    listener_.orientation = Quatf{0.0F, 0.0F, 1.0F, 0.0F};  // half a turn about up
    const Heard heard = frame({cue(sound, {3.0F, 0.0F, 0.0F})});
    EXPECT_GT(heard.left, 3.0 * heard.right);
}

TEST_F(MixerTest, LoudnessFollowsTheDistance) {
    const auto sound = add("tone.wav", tone(441.0, 0.0, 2.0));
    const LoopCue near{
        .key = 1, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    LoopCue far = near;
    far.position_world = {0, 0, -10.0F};
    const double near_rms = frames(30, {near}).left;
    const double far_rms = frames(30, {far}).left;
    // 1/10 and the window's 0.75 against the window's 0.9975.
    EXPECT_NEAR(far_rms / near_rms, 0.1 * 0.75 / 0.9975, 2e-3);
}

TEST_F(MixerTest, BeyondItsRadiusASoundIsSilent) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    const Heard heard = frame({cue(sound, {0.0F, 0.0F, -25.1F})});
    EXPECT_EQ(heard.left, 0.0);
    EXPECT_EQ(mixer().voices_playing(), 0U);
    listener_.position_world = {0.0F, 0.0F, -20.0F};
    EXPECT_GT(frame({cue(sound, {0.0F, 0.0F, -25.1F})}).left, 0.0);
}

TEST_F(MixerTest, NumbersThatAreNoneNeverReachTheDevice) {  // B9
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    listener_.position_world.x = nan;
    frame({cue(sound, {nan, 0.0F, 0.0F})},
          {LoopCue{.key = 1, .sound = sound, .position_world = {nan, 0, 0}}});
    listener_ = {};
    listener_.velocity_mps = Vec3f{nan};
    listener_.orientation = Quatf{0.0F, 0.0F, 0.0F, 0.0F};
    const Heard heard = frame({cue(sound, {1.0F, 0.0F, 0.0F})});
    EXPECT_EQ(mixer().voices_playing(), 1U);
    EXPECT_TRUE(std::isfinite(heard.left) && std::isfinite(heard.right));
    EXPECT_GT(heard.right, 0.0);
}

TEST_F(MixerTest, OnANewDeviceLoopsGoOnWhereTheyWouldBe) {  // B3
    const auto sound = add("half.wav", tone(441.0, 1.0, 2.0));
    const LoopCue loop{
        .key = 5, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    frames(60, {loop});  // 1.2 s: in the middle of the tone
    const std::size_t bytes = mixer().bytes();
    mixer().reopen("");
    EXPECT_EQ(mixer().bytes(), 0U);
    EXPECT_GT(frames(2, {loop}).left, 0.05);
    EXPECT_EQ(mixer().bytes(), bytes);
    EXPECT_EQ(mixer().voices_playing(), 1U);
    frames(42, {loop});
    EXPECT_LT(frames(1, {loop}).left, 1e-4);
}

TEST_F(MixerTest, PauseHoldsEverything) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 0.1));
    frame({cue(sound, {1.0F, 0.0F, 0.0F})});
    mixer().set_paused(true);
    frames(2);
    EXPECT_EQ(frames(20).right, 0.0);
    EXPECT_EQ(mixer().voices_playing(), 1U);
    mixer().set_paused(false);
    EXPECT_GT(frames(2).right, 0.0);
}

TEST_F(MixerTest, ALowPassTakesTheHighTones) {
    const auto sound = add("high.wav", tone(9'000.0, 0.0, 1.0));
    SoundCue open = cue(sound, {0.0F, 0.0F, -1.0F});
    SoundCue dull = open;
    dull.low_pass = 0.1F;
    frame({open});
    const double open_rms = frame({}).left;
    frames(60);
    frame({dull});
    const double dull_rms = frame({}).left;
    EXPECT_GT(open_rms, 0.05);
    EXPECT_LT(dull_rms, 0.3 * open_rms);
}

TEST_F(MixerTest, TheMasterGainIsOverEverything) {
    const auto sound = add("tone.wav", tone(441.0, 0.0, 2.0));
    frame({cue(sound, {0.0F, 0.0F, -1.0F})});
    const double full = frames(5).left;
    mixer().set_master_gain(0.25F);
    frames(5);
    EXPECT_NEAR(frames(1).left / full, 0.25, 0.01);
}

TEST_F(MixerTest, WithoutADeviceThereIsSilenceAndOneLine) {  // B1
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    def_.offline = false;
    testing::internal::CaptureStderr();
    Mixer silent(def_, library_);
    const std::vector<SoundCue> cues{cue(sound, {1.0F, 0.0F, 0.0F})};
    const std::vector<LoopCue> loops{{.key = 1, .sound = sound}};
    for (int i = 0; i < 1'000; ++i) silent.play(cues, loops, listener_, i * kFrame_s);  // 20 s
    const std::string words = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(silent.silent());
    EXPECT_EQ(silent.voices_playing(), 0U);
    EXPECT_EQ(silent.bytes(), 0U);
    EXPECT_EQ(silent.device_name(), "");
    const auto first = words.find("no sound device");
    EXPECT_NE(first, std::string::npos) << words;
    EXPECT_EQ(words.find("no sound device", first + 1), std::string::npos) << words;
    EXPECT_EQ(words.find("ALSA lib"), std::string::npos) << words;
    EXPECT_EQ(words.find("AL lib"), std::string::npos) << words;
}

TEST_F(MixerTest, ANamedDeviceThatIsNotThereIsNamed) {  // B2
    def_.offline = false;
    def_.device = "Gramophone";
    testing::internal::CaptureStderr();
    const Mixer silent(def_, library_);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("no sound device named \"Gramophone\""),
              std::string::npos);
    EXPECT_TRUE(silent.silent());
}

}  // namespace
}  // namespace plumbline::audio
