// Cues to loudspeakers through OpenAL. A missing device means silence and one line in the log; a
// lost one is reopened. Never a reason to stop.
#pragma once

#include "engine/audio/sound_cue.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace plumbline::audio {

struct MixerDef {
    std::string device;  ///< empty: the default one
    float master_gain{1.0F};
    int voices{32};
    int new_voices_per_frame{8};  ///< the loudest win
    bool offline{false};          ///< no device: render() gives the samples (films, tests)
    bool mono{false};             ///< every sound as loud on both sides
    bool doppler{false};          ///< what comes is heard higher, what goes lower
};

class Mixer {
public:
    /// Never fails: without a device it stays silent and retries every 5 s.
    Mixer(const MixerDef& def, const assets::AssetLibrary& library);
    ~Mixer();
    Mixer(const Mixer&) = delete;
    Mixer& operator=(const Mixer&) = delete;

    /// Once a frame: starts the cues, keeps the named loops (starting and fading out others). Where
    /// voices are few those that matter least at the listener fade and make room. While paused only
    /// cues that are in_head start.
    /// Non-finite positions and gains are dropped.
    void play(std::span<const SoundCue> cues,
              std::span<const LoopCue> loops,
              const Listener& listener,
              double now_s);

    bool silent() const;  ///< no device at the moment
    std::string device_name() const;
    std::size_t voices_playing() const;
    std::size_t bytes() const;  ///< sample memory uploaded
    void set_paused(bool paused);
    void set_master_gain(float gain);
    void set_mono(bool mono);
    void set_doppler(bool doppler);
    /// Whether walls can dull and rooms reverberate here (EFX); gain and delay are always there.
    bool has_filters() const;
    /// Builds everything on another device (empty: the default one), as after a loss: loops go on
    /// where they would be by now, one-shots end.
    void reopen(const std::string& device);

    /// The next samples of an offline mixer: 44.1 kHz, stereo, interleaved, any even count.
    void render(std::span<float> samples);
    static constexpr int kOfflineRate_hz = 44'100;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace plumbline::audio
