// What rooms, walls, distance and motion make of a sound, judged by spectrum, level and decay.
#include "tests/engine/audio/offline_mixer.h"
#include "tests/support/sound_measures.h"

#include <random>

namespace plumbline::audio {
namespace {

using test::decay_60dB_s;
using test::pitch_of_hz;
using test::rms_of;
using test::share_above;

std::vector<std::int16_t> white_noise(double length_s) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> even(-9'000.0, 9'000.0);
    std::vector<std::int16_t> samples(static_cast<std::size_t>(length_s * kRate_hz));
    for (std::int16_t& sample : samples) sample = static_cast<std::int16_t>(even(random));
    return samples;
}

/// 100 samples of noise, then nothing: a clap.
std::vector<std::int16_t> clap() {
    std::vector<std::int16_t> samples = white_noise(0.1);
    std::fill(samples.begin() + 100, samples.end(), std::int16_t{0});
    for (int i = 0; i < 100; ++i) samples[static_cast<std::size_t>(i)] *= 3;
    return samples;
}

class MixerSpace : public OfflineMixer {
protected:
    static LoopCue loop_of(assets::SoundId sound, const Vec3f& position_world) {
        return {.key = 9, .sound = sound, .position_world = position_world, .radius_m = 1'000.0F};
    }
};

TEST_F(MixerSpace, ADulledLoopLosesItsHighTones) {
    const auto sound = add("noise.wav", white_noise(1.0));
    LoopCue loop = loop_of(sound, {0, 0, -1.0F});
    frames(30, {loop});
    std::vector<double> open;
    for (int i = 0; i < 50; ++i) {
        frame({}, {loop});
        open.insert(open.end(), left_.begin(), left_.end());
    }
    loop.low_pass = 0.1F;
    frames(10, {loop});
    std::vector<double> dull;
    for (int i = 0; i < 50; ++i) {
        frame({}, {loop});
        dull.insert(dull.end(), left_.begin(), left_.end());
    }
    // White noise has nine tenths of its energy above 2 kHz.
    EXPECT_NEAR(share_above(open, kRate_hz, 2'000), 0.9, 0.02);
    EXPECT_LT(share_above(dull, kRate_hz, 2'000), 0.3 * share_above(open, kRate_hz, 2'000));
    EXPECT_LT(share_above(dull, kRate_hz, 8'000), 0.02);
}

TEST_F(MixerSpace, ADistantCueIsHeardLate) {
    const auto sound = add("clap.wav", clap());
    for (const float delay_s : {0.0F, 0.1F, 0.5F}) {
        SoundCue late = cue(sound, {0, 0, -1.0F});
        late.delay_s = delay_s;
        const std::vector<double> heard = listen(50, {late});
        const auto first = std::ranges::find_if(heard, [](double s) { return std::abs(s) > 0.01; });
        const double at_s = static_cast<double>(first - heard.begin()) / kRate_hz;
        EXPECT_NEAR(at_s, static_cast<double>(delay_s), 0.5 * kFrame_s + 0.002);
        frames(20);
    }
}

TEST_F(MixerSpace, ARoomsReverberationFallsInItsTime) {
    const auto sound = add("clap.wav", clap());
    for (const float decay_s : {0.4F, 0.8F, 1.6F, 3.0F}) {
        listener_.room = {.gain = 1.0F, .decay_s = decay_s, .size_m = 3.0F};
        frames(10);
        std::vector<double> heard =
            listen(static_cast<int>(decay_s * 75.0F), {cue(sound, {0, 0, -1.0F})});
        heard.erase(heard.begin(), heard.begin() + 600);  // what comes straight
        EXPECT_NEAR(decay_60dB_s(heard, kRate_hz) / static_cast<double>(decay_s), 1.0, 0.25)
            << decay_s;
        frames(static_cast<int>(decay_s * 100.0F));
    }
}

TEST_F(MixerSpace, ARoomIsAsLoudAsItSays) {
    const auto sound = add("noise.wav", white_noise(1.0));
    const LoopCue loop = loop_of(sound, {0, 0, -1.0F});
    frames(30, {loop});
    const auto level = [&] {
        std::vector<double> heard;
        for (int i = 0; i < 50; ++i) {
            frame({}, {loop});
            heard.insert(heard.end(), left_.begin(), left_.end());
        }
        return rms_of(heard);
    };
    const double open = level();
    for (const float decay_s : {0.5F, 1.0F, 2.0F}) {
        for (const float gain : {0.4F, 1.0F}) {
            listener_.room = {.gain = gain, .decay_s = decay_s, .size_m = 3.0F};
            frames(static_cast<int>(decay_s * 75.0F), {loop});
            const double all = level();
            const double room = std::sqrt(std::max(all * all - open * open, 0.0)) / open;
            EXPECT_GT(room, 0.6 * static_cast<double>(gain)) << decay_s;  // within 4 dB
            EXPECT_LT(room, 1.6 * static_cast<double>(gain)) << decay_s;
        }
    }
}

TEST_F(MixerSpace, InTheOpenThereIsNoReverberation) {
    const auto sound = add("clap.wav", clap());
    listener_.room = {.gain = 0.8F, .decay_s = 1.0F, .size_m = 3.0F};
    frames(10);
    listener_.room = {};
    frames(100);
    const std::vector<double> heard = listen(50, {cue(sound, {0, 0, -1.0F})});
    EXPECT_LT(rms_of({heard.begin() + 2'000, heard.end()}),
              1e-4 * rms_of({heard.begin(), heard.begin() + 400}));
}

TEST_F(MixerSpace, DopplerShiftsByTheSpeedTowardsTheEar) {
    def_.doppler = true;
    const auto sound = add("tone.wav", tone(1'000.0, 0.0, 1.0));
    for (const float speed_mps : {-40.0F, -10.0F, 0.0F, 10.0F, 40.0F}) {
        LoopCue loop = loop_of(sound, {0, 0, -20.0F});
        loop.velocity_mps = {0, 0, speed_mps};
        frames(40, {loop});
        std::vector<double> heard;
        for (int i = 0; i < 40; ++i) {
            frame({}, {loop});
            heard.insert(heard.end(), left_.begin(), left_.end());
        }
        const double c = static_cast<double>(kSpeedOfSound_mps);
        const double expected_hz = 1'000.0 * c / (c - static_cast<double>(speed_mps));
        EXPECT_NEAR(pitch_of_hz(heard, kRate_hz), expected_hz, 0.02 * expected_hz) << speed_mps;
        frames(40);
    }
    mixer().set_doppler(false);
    LoopCue loop = loop_of(sound, {0, 0, -20.0F});
    loop.velocity_mps = {0, 0, 40.0F};
    listener_.velocity_mps = {0, 0, -20.0F};
    frames(40, {loop});
    std::vector<double> heard;
    for (int i = 0; i < 40; ++i) {
        frame({}, {loop});
        heard.insert(heard.end(), left_.begin(), left_.end());
    }
    EXPECT_NEAR(pitch_of_hz(heard, kRate_hz), 1'000.0, 2.0);
}

TEST_F(MixerSpace, InMonoBothSidesHearTheSame) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    const LoopCue loop = loop_of(sound, {3.0F, 0, 0});
    const Heard stereo = frames(40, {loop});
    EXPECT_GT(stereo.right, 3.0 * stereo.left);
    mixer().set_mono(true);
    const Heard mono = frames(10, {loop});
    EXPECT_GT(mono.left, 0.02);
    EXPECT_NEAR(mono.left / mono.right, 1.0, 1e-3);
    mixer().set_mono(false);
    const Heard again = frames(10, {loop});
    EXPECT_GT(again.right, 3.0 * again.left);
}

TEST_F(MixerSpace, WhatMattersMoreKeepsItsVoice) {
    def_.voices = 1;
    const auto high = add("high.wav", tone(2'000.0, 0.0, 1.0));
    const auto low = add("low.wav", tone(200.0, 0.0, 1.0));
    SoundCue bell = cue(high, {0, 0, -4.0F});
    bell.importance = 10.0F;
    frame({bell});
    const std::vector<double> heard = listen(30, {cue(low, {0, 0, -1.0F})});
    EXPECT_NEAR(pitch_of_hz(heard, kRate_hz), 2'000.0, 5.0);
    frames(40);
    SoundCue usual = bell;
    usual.importance = 1.0F;
    frame({usual});
    EXPECT_NEAR(pitch_of_hz(listen(30, {cue(low, {0, 0, -1.0F})}), kRate_hz), 200.0, 5.0);
}

TEST_F(MixerSpace, WhatIsInTheHeadIsHeardWhileTheWorldStandsStill) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 0.3));
    const LoopCue loop = loop_of(sound, {0, 0, -1.0F});
    frames(30, {loop});
    mixer().set_paused(true);
    frames(3, {loop});
    EXPECT_EQ(frames(1, {loop}).left, 0.0);
    SoundCue tick = cue(sound, {0, 0, 0});
    tick.gain = 0.5F;
    tick.in_head = true;
    SoundCue world = cue(sound, {0, 0, -1.0F});
    listener_.position_world = {500.0F, 0, 0};
    frame({tick, world}, {loop});
    EXPECT_EQ(mixer().voices_playing(), 2U) << "the loop that waits, and the tick";
    const Heard heard = frames(5, {loop});
    EXPECT_GT(heard.left, 0.05);
    EXPECT_NEAR(heard.left / heard.right, 1.0, 1e-3);
    frames(15, {loop});
    EXPECT_EQ(frames(1, {loop}).left, 0.0);
}

TEST_F(MixerSpace, FiveHundredSourcesKeepToTheVoicesThereAre) {
    const auto sound = add("tone.wav", tone(440.0, 0.0, 1.0));
    std::vector<LoopCue> loops;
    std::vector<SoundCue> cues;
    for (int i = 0; i < 500; ++i) {
        const Vec3f at{
            static_cast<float>(i % 25) - 12.0F, 1.0F, static_cast<float>(i / 25) - 10.0F};
        loops.push_back({.key = static_cast<std::uint64_t>(i) + 1,
                         .sound = sound,
                         .position_world = at,
                         .gain = 0.1F,
                         .low_pass = 0.5F});
        SoundCue late = cue(sound, at);
        late.delay_s = static_cast<float>(i) * 0.01F;
        cues.push_back(late);
    }
    listener_.room = {.gain = 0.5F, .decay_s = 1.0F, .size_m = 5.0F};
    for (int i = 0; i < 50; ++i) {
        const Heard heard = frame(cues, loops);
        EXPECT_LE(mixer().voices_playing(), 32U);
        EXPECT_TRUE(std::isfinite(heard.left) && std::isfinite(heard.right));
    }
    EXPECT_EQ(mixer().voices_playing(), 32U);
}

}  // namespace
}  // namespace plumbline::audio
