// Voices of the mixer: OpenAL sources and what plays on them.
#pragma once

#include "engine/audio/hearing.h"
#include "engine/audio/mixer.h"
#include "engine/audio/sound_device_impl.h"

#include <map>
#include <vector>

namespace plumbline::audio {

/// A sound's samples on the device, mono.
struct SampleBuffer {
    ALuint name{0};  ///< 0: the sound cannot be played
    std::size_t bytes{0};
    double length_s{0.0};
};

enum class VoiceState : std::uint8_t { Free, Playing, Fading };

/// One OpenAL source and the one-shot or loop on it.
struct Voice {
    ALuint source{0};
    VoiceState state{VoiceState::Free};
    double silent_s{0.0};       ///< Fading: from then on nothing is left of it
    std::uint64_t loop_key{0};  ///< 0: a one-shot
    SoundCue cue{};             ///< of a loop its place, gain, radius and low pass
    float loudness{0.0F};       ///< gain at the listener, as of the last frame
};

/// A cue on its way through the air.
struct CueUnderway {
    SoundCue cue;
    double heard_s{0.0};  ///< by the mixer's clock
};

/// A loop goes on by the clock even while it is too far away to need a voice.
struct LoopState {
    LoopCue cue;
    double started_s{0.0};
    float fade{0.0F};  ///< 0…1
    bool named{true};  ///< by its owner, in this frame
};

struct Mixer::Impl {
    Impl(const MixerDef& mixer_def, const assets::AssetLibrary& asset_library)
        : def(mixer_def), library(asset_library) {}

    MixerDef def;
    const assets::AssetLibrary& library;
    SoundDevice device;
    CueChoice choice;
    std::vector<Voice> voices;
    std::size_t most_playing{0};  ///< of them: the others are for those that fade
    std::vector<CueUnderway> underway;
    std::map<assets::SoundId, SampleBuffer> buffers;
    std::map<std::uint64_t, LoopState> loops;
    Listener listener;
    double clock_s{0.0};  ///< runs while not paused
    double last_now_s{0.0};
    double next_check_s{0.0};
    bool started{false};
    bool paused{false};
    bool said_silent{false};

    void open_device();
    void prepare_device();
    void forget_device();
    void watch_device(double now_s);
    void free_finished_voices();
    void set_listener(const Listener& wanted);
    void start_cues(std::span<const SoundCue> cues, double now_s, double elapsed_s);
    void start_cues_in_head(std::span<const SoundCue> cues, double now_s);
    std::vector<SoundCue> arrived(std::span<const SoundCue> cues, double elapsed_s);
    void start(Voice& voice, const ChosenCue& chosen, ALuint buffer);
    void follow_room(const Room& room);
    void follow_loops(std::span<const LoopCue> cues, float elapsed_s);
    void update_loop(std::uint64_t key, const LoopState& loop);
    void update_loudness();

    const SampleBuffer& buffer_of(assets::SoundId sound);
    Voice* voice_for(float worth);
    Voice* free_voice();
    std::size_t playing() const;
    void fade(Voice& voice);
    void place(const Voice& voice) const;
    void dull(Voice& voice, float low_pass);
    Voice* voice_of_loop(std::uint64_t key);
    void stop(Voice& voice);
    float loudness_of(const Vec3f& position_world, float gain, float radius_m) const;
};

}  // namespace plumbline::audio
