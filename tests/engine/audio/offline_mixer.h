// A mixer whose samples are rendered, not played: the tests need no sound device, and the ones about a
// missing device are given none.
#pragma once

#include "engine/audio/mixer.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace plumbline::audio {

inline constexpr int kRate_hz = Mixer::kOfflineRate_hz;
inline constexpr double kFrame_s = 0.02;
inline constexpr std::size_t kFrameSamples = 882;  // of each channel
inline constexpr double kTurn_rad = 6.283185307179586;

inline void put(std::string& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

/// A 16-bit WAV file.
inline std::string wav_of(const std::vector<std::int16_t>& samples, std::uint32_t channels) {
    const auto size = static_cast<std::uint32_t>(samples.size() * 2);
    std::string bytes = "RIFF";
    put(bytes, 36 + size, 4);
    bytes += "WAVEfmt ";
    put(bytes, 16, 4);
    put(bytes, 1, 2);
    put(bytes, channels, 2);
    put(bytes, kRate_hz, 4);
    put(bytes, kRate_hz * channels * 2, 4);
    put(bytes, channels * 2, 2);
    put(bytes, 16, 2);
    bytes += "data";
    put(bytes, size, 4);
    for (const std::int16_t sample : samples) put(bytes, static_cast<std::uint16_t>(sample), 2);
    return bytes;
}

/// `from_s` of silence, then a tone up to `to_s`.
inline std::vector<std::int16_t> tone(double frequency_hz, double from_s, double to_s) {
    std::vector<std::int16_t> samples(static_cast<std::size_t>(to_s * kRate_hz));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t_s = static_cast<double>(i) / kRate_hz;
        const double value = t_s < from_s ? 0.0 : std::sin(kTurn_rad * frequency_hz * t_s);
        samples[i] = static_cast<std::int16_t>(16'000.0 * value);
    }
    return samples;
}

struct Heard {
    double left{0.0};  ///< root mean square
    double right{0.0};
    double largest_step{0.0};  ///< between two samples: a click is a large one
};

class OfflineMixer : public testing::Test {
protected:
    assets::SoundId add(const char* name,
                        const std::vector<std::int16_t>& samples,
                        std::uint32_t channels = 1) {
        Result<assets::SoundId> id = library_.sound(folder_.write(name, wav_of(samples, channels)));
        EXPECT_TRUE(id.ok());
        return *id;
    }

    Mixer& mixer() {
        if (!mixer_) mixer_ = std::make_unique<Mixer>(def_, library_);
        return *mixer_;
    }

    /// One frame: cues in, 20 ms of samples out.
    Heard frame(std::vector<SoundCue> cues, std::vector<LoopCue> loops = {}) {
        mixer().play(cues, loops, listener_, now_s_);
        now_s_ += kFrame_s;
        std::vector<float> samples(kFrameSamples * 2);
        mixer().render(samples);
        Heard heard;
        left_.clear();
        right_.clear();
        for (std::size_t i = 0; i < kFrameSamples; ++i) {
            const double left = static_cast<double>(samples[2 * i]);
            const double right = static_cast<double>(samples[2 * i + 1]);
            left_.push_back(left);
            right_.push_back(right);
            heard.left += left * left;
            heard.right += right * right;
            heard.largest_step = std::max(heard.largest_step, std::abs(left - last_left_));
            last_left_ = left;
        }
        heard.left = std::sqrt(heard.left / kFrameSamples);
        heard.right = std::sqrt(heard.right / kFrameSamples);
        return heard;
    }

    Heard frames(int count, const std::vector<LoopCue>& loops = {}) {
        Heard heard;
        double largest_step = 0.0;
        for (int i = 0; i < count; ++i) {
            heard = frame({}, loops);
            largest_step = std::max(largest_step, heard.largest_step);
        }
        heard.largest_step = largest_step;
        return heard;
    }

    /// The left side of so many frames, the cues and loops of the first of them.
    std::vector<double> listen(int count,
                               const std::vector<SoundCue>& cues,
                               const std::vector<LoopCue>& loops = {}) {
        std::vector<double> heard;
        for (int i = 0; i < count; ++i) {
            frame(i == 0 ? cues : std::vector<SoundCue>{}, loops);
            heard.insert(heard.end(), left_.begin(), left_.end());
        }
        return heard;
    }

    static SoundCue cue(assets::SoundId sound, const Vec3f& position_world) {
        SoundCue cue;
        cue.sound = sound;
        cue.position_world = position_world;
        return cue;
    }

    test::TemporaryFolder folder_;
    assets::AssetLibrary library_;
    MixerDef def_{.offline = true};
    std::unique_ptr<Mixer> mixer_;
    Listener listener_;
    double now_s_{10.0};
    double last_left_{0.0};
    std::vector<double> left_;  ///< of the latest frame
    std::vector<double> right_;
};

}  // namespace plumbline::audio
