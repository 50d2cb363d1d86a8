// Which sounds get a voice, how long they keep it, and how it ends.
#include "tests/engine/audio/offline_mixer.h"

#include <cmath>

namespace plumbline::audio {
namespace {

class MixerVoices : public OfflineMixer {};

TEST_F(MixerVoices, AStormStartsAtMostEightVoicesAFrame) {  // B8
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    const std::vector<SoundCue> storm(1'000, cue(sound, {1.0F, 0.0F, 0.0F}));
    frame(storm);
    EXPECT_EQ(mixer().voices_playing(), 8U);
    for (int i = 0; i < 10; ++i) frame(storm);
    EXPECT_EQ(mixer().voices_playing(), 32U);
}

TEST_F(MixerVoices, WithTooFewVoicesTheLoudestWin) {  // B5
    def_.voices = 4;
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    frame(std::vector<SoundCue>(8, cue(sound, {0.0F, 0.0F, -20.0F})));
    EXPECT_EQ(mixer().voices_playing(), 4U);
    const double quiet = frame({}).left;
    frame({cue(sound, {0.0F, 0.0F, -1.0F})});
    EXPECT_EQ(mixer().voices_playing(), 4U);
    const double with_near_one = frame({}).left;
    EXPECT_GT(with_near_one, 3.0 * quiet);
    frame(std::vector<SoundCue>(8, cue(sound, {0.0F, 0.0F, -24.0F})));  // too quiet to displace any
    EXPECT_GT(frame({}).left, 3.0 * quiet);
}

TEST_F(MixerVoices, VoicesAreFreedWhenTheirSoundEnds) {
    const auto sound = add("short.wav", tone(440.0, 0.0, 0.05));
    frame({cue(sound, {1.0F, 0.0F, 0.0F})});
    EXPECT_EQ(mixer().voices_playing(), 1U);
    frames(5);
    EXPECT_EQ(mixer().voices_playing(), 0U);
}

TEST_F(MixerVoices, ALoopGoesOnWithoutAClickWhileItIsNamed) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 0.1));  // whole periods: seamless
    const LoopCue loop{
        .key = 5, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    frames(20, {loop});  // faded in
    const Heard steady = frames(50, {loop});
    // A sine's steepest step: amplitude * 2 pi f / rate; the amplitude is rms * sqrt 2.
    const double steepest = steady.left * std::sqrt(2.0) * 6.2831853 * 440.0 / kRate_hz;
    EXPECT_GT(steady.left, 0.05);
    EXPECT_LT(steady.largest_step, steepest * 1.02);
    EXPECT_EQ(mixer().voices_playing(), 1U);
}

// A sine's steepest step is amplitude * 2 pi f / rate.
TEST_F(MixerVoices, ALoopIsHeardAtItsPitchAsItChanges) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 0.1));
    LoopCue loop{.key = 5, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    for (const float pitch : {1.0F, 1.5F, 0.75F}) {
        loop.pitch = pitch;
        frames(20, {loop});
        const Heard heard = frames(50, {loop});
        const double frequency_hz =
            heard.largest_step * kRate_hz / (heard.left * std::sqrt(2.0) * 6.2831853);
        EXPECT_NEAR(frequency_hz, 440.0 * static_cast<double>(pitch), 0.03 * 440.0) << pitch;
    }
    EXPECT_EQ(mixer().voices_playing(), 1U);
}

TEST_F(MixerVoices, ALoopThatIsNoLongerNamedFadesOutWithoutAClick) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 0.1));
    const LoopCue loop{
        .key = 5, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    const double loud = frames(30, {loop}).left;
    const double steepest = loud * std::sqrt(2.0) * 6.2831853 * 440.0 / kRate_hz;
    const Heard fading = frames(7);
    EXPECT_LT(fading.left, loud);
    EXPECT_GT(fading.left, 0.0);
    EXPECT_LT(fading.largest_step, steepest * 1.1);
    const Heard again = frames(20, {loop});  // named again: the same voice, up again
    EXPECT_NEAR(again.left, loud, loud * 0.02);
    EXPECT_LT(again.largest_step, steepest * 1.1);
    frames(25);
    EXPECT_EQ(frames(1).left, 0.0);
    EXPECT_EQ(mixer().voices_playing(), 0U);
}

TEST_F(MixerVoices, ALoopOutOfHearingGoesOnByTheClock) {
    const auto sound = add("half.wav", tone(441.0, 1.0, 2.0));  // one second silent, one not
    const LoopCue loop{
        .key = 5, .sound = sound, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    frames(20, {loop});  // 0.4 s
    listener_.position_world.x = 100.0F;
    frames(40, {loop});  // to 1.2 s, without a voice
    EXPECT_EQ(mixer().voices_playing(), 0U);
    listener_.position_world.x = 0.0F;
    EXPECT_GT(frames(3, {loop}).left, 0.05);  // in the middle of the tone
    frames(42, {loop});
    EXPECT_LT(frames(1, {loop}).left, 1e-4);  // past 2 s: from the start again
}

TEST_F(MixerVoices, StereoIsMixedDownToHaveAPlace) {
    std::vector<std::int16_t> stereo;
    for (const std::int16_t sample : tone(440.0, 0.0, 0.5)) {
        stereo.push_back(0);
        stereo.push_back(sample);  // all on the right of the file
    }
    const auto sound = add("stereo.wav", stereo, 2);
    const Heard heard = frame({cue(sound, {-3.0F, 0.0F, 0.0F})});
    EXPECT_GT(heard.left, 3.0 * heard.right);
    EXPECT_EQ(mixer().bytes(), stereo.size());  // half the samples, two bytes each
}

// A sine's steepest step is amplitude * 2 pi f / rate; cut off at its crest it steps by its amplitude.
TEST_F(MixerVoices, AVoiceThatIsTakenAwayDoesNotClick) {
    def_.voices = 1;
    const auto low = add("low.wav", tone(110.0, 0.0, 2.0));
    const auto silent = add("silent.wav", std::vector<std::int16_t>(20'000, 0));
    frame({cue(low, {0, 0, -2.0F})});
    const Heard before = frames(3);
    const double amplitude = before.left * std::sqrt(2.0);
    const double steepest = amplitude * kTurn_rad * 110.0 / kRate_hz;
    const Heard taken = frame({cue(silent, {0, 0, -1.0F})});
    EXPECT_EQ(mixer().voices_playing(), 1U);
    const Heard after = frames(4);
    EXPECT_LT(std::max(taken.largest_step, after.largest_step), 3.0 * steepest);
    EXPECT_LT(steepest, amplitude / 50.0);
    EXPECT_EQ(frames(1).left, 0.0);
}

TEST_F(MixerVoices, ALouderCueWithTheKeyOfOneThatJustBeganTakesItsPlace) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    SoundCue tap = cue(sound, {0.0F, 0.0F, -4.0F});
    tap.merge_key = 3;
    frame({tap});
    EXPECT_EQ(mixer().voices_playing(), 1U);
    const double quiet = frame({}).left;
    SoundCue knock = tap;
    knock.position_world.z = -1.0F;
    frame({knock});  // 40 ms after it
    EXPECT_EQ(mixer().voices_playing(), 1U);
    frames(5);
    EXPECT_GT(frame({}).left, 2.0 * quiet);
    frame({tap});  // later than 50 ms: a sound of its own
    EXPECT_EQ(mixer().voices_playing(), 2U);
}

TEST_F(MixerVoices, ALoopThatChangesItsSoundBeginsIt) {
    const auto silent = add("silent.wav", std::vector<std::int16_t>(kRate_hz, 0));
    const auto sound = add("half.wav", tone(441.0, 1.0, 2.0));  // one second silent, one not
    LoopCue loop{.key = 5, .sound = silent, .position_world = {0, 0, -1.0F}, .radius_m = 20.0F};
    frames(75, {loop});  // 1.5 s
    loop.sound = sound;
    EXPECT_EQ(frames(40, {loop}).left, 0.0) << "not where it would be had it always played";
    EXPECT_EQ(mixer().voices_playing(), 1U);
    EXPECT_GT(frames(20, {loop}).left, 0.05) << "1.2 s after its beginning";
}

}  // namespace
}  // namespace plumbline::audio
