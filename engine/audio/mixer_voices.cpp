#include "engine/audio/mixer_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <cmath>

namespace plumbline::audio {
namespace {

constexpr float kLoopFade_s = 0.3F;

/// Only mono sounds have a place: channels are averaged.
std::vector<std::int16_t> mono_of(const assets::SoundData& sound) {
    const auto channels = static_cast<std::size_t>(sound.channels);
    if (channels == 1) return sound.samples;
    std::vector<std::int16_t> mono(sound.samples.size() / channels);
    for (std::size_t i = 0; i < mono.size(); ++i) {
        int sum = 0;
        for (std::size_t c = 0; c < channels; ++c) sum += sound.samples[i * channels + c];
        mono[i] = static_cast<std::int16_t>(sum / sound.channels);
    }
    return mono;
}

bool is_sound(const assets::SoundData& sound) {
    constexpr int kMaxChannels = 8;
    constexpr int kMaxRate_hz = 384'000;
    return sound.sample_rate_hz > 0 && sound.sample_rate_hz <= kMaxRate_hz && sound.channels > 0 &&
           sound.channels <= kMaxChannels &&
           sound.samples.size() >= static_cast<std::size_t>(sound.channels);
}

}  // namespace

const SampleBuffer& Mixer::Impl::buffer_of(assets::SoundId sound) {
    const auto [entry, is_new] = buffers.try_emplace(sound);
    SampleBuffer& buffer = entry->second;
    if (!is_new) return buffer;
    const assets::SoundData& data = library.sound(sound);
    if (!is_sound(data)) {
        log_warning("a sound of {} Hz, {} channels and {} samples is left out",
                    data.sample_rate_hz,
                    data.channels,
                    data.samples.size());
        return buffer;
    }
    const std::vector<std::int16_t> mono = mono_of(data);
    buffer.bytes = mono.size() * sizeof(std::int16_t);
    alGetError();
    alGenBuffers(1, &buffer.name);
    alBufferData(buffer.name,
                 AL_FORMAT_MONO16,
                 mono.data(),
                 static_cast<ALsizei>(buffer.bytes),
                 data.sample_rate_hz);
    if (alGetError() != AL_NO_ERROR) {
        log_warning("a sound of {} bytes does not fit the sound device and is left out",
                    buffer.bytes);
        alDeleteBuffers(1, &buffer.name);
        buffer = {};
        return buffer;
    }
    buffer.length_s = static_cast<double>(mono.size()) / static_cast<double>(data.sample_rate_hz);
    return buffer;
}

float Mixer::Impl::loudness_of(const Vec3f& position_world, float gain, float radius_m) const {
    return gain * attenuation(glm::length(position_world - listener.position_world), radius_m);
}

void Mixer::Impl::stop(Voice& voice) {
    alSourceStop(voice.source);
    alSourcei(voice.source, AL_BUFFER, 0);
    const ALuint source = voice.source;
    voice = {};
    voice.source = source;
}

/// A free voice, else the quietest one if it is quieter than what wants to be heard, else null.
Voice* Mixer::Impl::voice_for(float loudness) {
    if (voices.empty()) return nullptr;
    const auto free = std::ranges::find(voices, false, &Voice::busy);
    if (free != voices.end()) return &*free;
    const auto quietest = std::ranges::min_element(voices, {}, &Voice::loudness);
    if (quietest->loudness >= loudness) return nullptr;
    stop(*quietest);
    return &*quietest;
}

Voice* Mixer::Impl::voice_of_loop(std::uint64_t key) {
    const auto found = std::ranges::find(voices, key, &Voice::loop_key);
    return found == voices.end() ? nullptr : &*found;
}

void Mixer::Impl::free_finished_voices() {
    for (Voice& voice : voices) {
        if (!voice.busy || voice.loop_key != 0) continue;
        ALint state = AL_STOPPED;
        alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
        if (state == AL_STOPPED || state == AL_INITIAL) stop(voice);
    }
}

void Mixer::Impl::start_cues(std::span<const SoundCue> cues, double now_s) {
    const auto limit = static_cast<std::size_t>(std::max(def.new_voices_per_frame, 0));
    for (const ChosenCue& chosen : choice.choose(cues, listener.position_world, now_s, limit)) {
        const SoundCue& cue = chosen.cue;
        const SampleBuffer& buffer = buffer_of(cue.sound);
        if (buffer.name == 0) continue;
        // A louder cue with the key of a sound that has just begun takes that sound's voice.
        Voice* voice = nullptr;
        if (cue.merge_key != 0) {
            const auto same = std::ranges::find(voices, cue.merge_key, &Voice::merge_key);
            ALfloat played_s = 0.0F;
            if (same != voices.end()) alGetSourcef(same->source, AL_SEC_OFFSET, &played_s);
            if (same != voices.end() && static_cast<double>(played_s) < CueChoice::kMerge_s) {
                stop(*same);
                voice = &*same;
            }
        }
        if (voice == nullptr) voice = voice_for(chosen.loudness);
        if (voice == nullptr) continue;
        voice->busy = true;
        voice->merge_key = cue.merge_key;
        voice->position_world = cue.position_world;
        voice->gain = cue.gain;
        voice->radius_m = cue.radius_m;
        voice->loudness = chosen.loudness;
        alSourcei(voice->source, AL_BUFFER, static_cast<ALint>(buffer.name));
        alSourcei(voice->source, AL_LOOPING, AL_FALSE);
        alSourcef(voice->source, AL_PITCH, cue.pitch);
        alSourcef(voice->source, AL_GAIN, chosen.loudness);
        alSource3f(voice->source,
                   AL_POSITION,
                   cue.position_world.x,
                   cue.position_world.y,
                   cue.position_world.z);
        alSourcei(voice->source,
                  AL_DIRECT_FILTER,
                  static_cast<ALint>(device.low_pass_filter(cue.low_pass)));
        alSourcePlay(voice->source);
    }
}

void Mixer::Impl::follow_loops(std::span<const LoopCue> cues, float elapsed_s) {
    for (auto& [key, loop] : loops) loop.named = false;
    for (const LoopCue& cue : cues) {
        if (!is_playable(cue)) continue;
        const auto [entry, is_new] = loops.try_emplace(cue.key);
        LoopState& loop = entry->second;
        if (is_new || loop.cue.sound != cue.sound) {
            if (Voice* voice = voice_of_loop(cue.key)) stop(*voice);
            loop.started_s = clock_s;
            loop.fade = 0.0F;
        }
        loop.cue = cue;
        loop.cue.gain = std::min(cue.gain, 1.0F);
        loop.cue.pitch = std::clamp(cue.pitch, 0.5F, 2.0F);
        loop.named = true;
    }
    const float step = elapsed_s / kLoopFade_s;
    for (auto it = loops.begin(); it != loops.end();) {
        LoopState& loop = it->second;
        loop.fade = std::clamp(loop.fade + (loop.named ? step : -step), 0.0F, 1.0F);
        if (!loop.named && loop.fade <= 0.0F) {
            if (Voice* voice = voice_of_loop(it->first)) stop(*voice);
            it = loops.erase(it);
            continue;
        }
        update_loop(it->first, loop);
        ++it;
    }
}

void Mixer::Impl::update_loop(std::uint64_t key, const LoopState& loop) {
    const LoopCue& cue = loop.cue;
    const float gain = cue.gain * loop.fade;
    const float loudness = loudness_of(cue.position_world, gain, cue.radius_m);
    Voice* voice = voice_of_loop(key);
    if (voice != nullptr && loudness <= 0.0F) {
        stop(*voice);
        return;
    }
    if (voice == nullptr) {
        if (loudness < CueChoice::kInaudible) return;
        const SampleBuffer& buffer = buffer_of(cue.sound);
        voice = buffer.name == 0 ? nullptr : voice_for(loudness);
        if (voice == nullptr) return;
        voice->busy = true;
        voice->loop_key = key;
        // Where it would be had it been heard all along.
        const double offset_s = std::fmod(clock_s - loop.started_s, buffer.length_s);
        alSourcei(voice->source, AL_BUFFER, static_cast<ALint>(buffer.name));
        alSourcei(voice->source, AL_LOOPING, AL_TRUE);
        alSourcei(voice->source, AL_DIRECT_FILTER, AL_FILTER_NULL);
        alSourcef(voice->source, AL_SEC_OFFSET, static_cast<float>(std::max(offset_s, 0.0)));
        alSourcef(voice->source, AL_GAIN, 0.0F);
        alSourcePlay(voice->source);
    }
    voice->position_world = cue.position_world;
    voice->gain = gain;
    voice->radius_m = cue.radius_m;
    voice->loudness = loudness;
    alSourcef(voice->source, AL_PITCH, cue.pitch);
    alSource3f(voice->source,
               AL_POSITION,
               cue.position_world.x,
               cue.position_world.y,
               cue.position_world.z);
}

void Mixer::Impl::update_loudness() {
    for (Voice& voice : voices) {
        if (!voice.busy) continue;
        voice.loudness = loudness_of(voice.position_world, voice.gain, voice.radius_m);
        alSourcef(voice.source, AL_GAIN, voice.loudness);
    }
}

}  // namespace plumbline::audio
