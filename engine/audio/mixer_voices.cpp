#include "engine/assets/sound_import.h"
#include "engine/audio/mixer_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <cmath>

namespace plumbline::audio {
namespace {

constexpr float kLoopFade_s = 0.3F;
constexpr double kStealFade_s = 0.06;  // three blocks of a usual device
constexpr std::size_t kUnderway = 512;

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

}  // namespace

const SampleBuffer& Mixer::Impl::buffer_of(assets::SoundId sound) {
    const auto [entry, is_new] = buffers.try_emplace(sound);
    SampleBuffer& buffer = entry->second;
    if (!is_new) return buffer;
    const assets::SoundData& data = library.sound(sound);
    const bool is_empty = data.samples.size() < static_cast<std::size_t>(data.channels);
    if (!assets::is_playable(data) || is_empty) {
        log_warning("skipped a sound with {} Hz, {} channels and {} samples",
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
        log_warning("skipped a sound of {} bytes: it does not fit the sound device", buffer.bytes);
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

/// The device takes a gain to its new value over its next block of samples: no click.
void Mixer::Impl::fade(Voice& voice) {
    alSourcef(voice.source, AL_GAIN, 0.0F);
    voice.state = VoiceState::Fading;
    voice.silent_s = clock_s + kStealFade_s;
    voice.loop_key = 0;
    voice.cue.merge_key = 0;
    voice.loudness = 0.0F;
}

std::size_t Mixer::Impl::playing() const {
    return static_cast<std::size_t>(std::ranges::count(voices, VoiceState::Playing, &Voice::state));
}

/// One that plays nothing, else the one that has been fading longest; null: all play.
Voice* Mixer::Impl::free_voice() {
    const auto free = std::ranges::find(voices, VoiceState::Free, &Voice::state);
    if (free != voices.end()) return &*free;
    Voice* oldest = nullptr;
    for (Voice& voice : voices) {
        if (voice.state != VoiceState::Fading) continue;
        if (oldest == nullptr || voice.silent_s < oldest->silent_s) oldest = &voice;
    }
    if (oldest != nullptr) stop(*oldest);
    return oldest;
}

/// A free voice, else that of what is worth least if that is less than what wants to be heard, else
/// null.
Voice* Mixer::Impl::voice_for(float worth) {
    if (playing() < most_playing) return free_voice();
    Voice* least = nullptr;
    const auto worth_of = [](const Voice& voice) { return voice.loudness * voice.cue.importance; };
    for (Voice& voice : voices) {
        if (voice.state != VoiceState::Playing) continue;
        if (least == nullptr || worth_of(voice) < worth_of(*least)) least = &voice;
    }
    if (least == nullptr || worth_of(*least) >= worth) return nullptr;
    fade(*least);
    return free_voice();
}

Voice* Mixer::Impl::voice_of_loop(std::uint64_t key) {
    const auto found = std::ranges::find(voices, key, &Voice::loop_key);
    return found == voices.end() ? nullptr : &*found;
}

void Mixer::Impl::free_finished_voices() {
    for (Voice& voice : voices) {
        if (voice.state == VoiceState::Fading && clock_s >= voice.silent_s) stop(voice);
        if (voice.state != VoiceState::Playing || voice.loop_key != 0) continue;
        ALint state = AL_STOPPED;
        alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
        if (state == AL_STOPPED || state == AL_INITIAL) stop(voice);
    }
}

void Mixer::Impl::place(const Voice& voice) const {
    const SoundCue& cue = voice.cue;
    alSourcei(voice.source, AL_SOURCE_RELATIVE, cue.in_head ? AL_TRUE : AL_FALSE);
    if (cue.in_head) {
        alSource3f(voice.source, AL_POSITION, 0.0F, 0.0F, -1.0F);
        alSource3f(voice.source, AL_VELOCITY, 0.0F, 0.0F, 0.0F);
        return;
    }
    MonoPlace at{cue.position_world, cue.velocity_mps};
    if (def.mono) at = place_in_mono(cue.position_world, cue.velocity_mps, listener);
    const Vec3f& position = at.position_world;
    alSource3f(voice.source, AL_POSITION, position.x, position.y, position.z);
    const Vec3f velocity = with_bounded_speed(at.velocity_mps);
    alSource3f(voice.source, AL_VELOCITY, velocity.x, velocity.y, velocity.z);
}

/// Filters are set where they change to be heard.
void Mixer::Impl::dull(Voice& voice, float low_pass) {
    if (std::abs(voice.cue.low_pass - low_pass) < 0.005F) return;
    voice.cue.low_pass = low_pass;
    device.set_low_pass(voice.source, low_pass);
}

void Mixer::Impl::follow_room(const Room& room) {
    if (!device.set_room(room)) return;
    // The first room: voices did not lead into it so far.
    for (const Voice& voice : voices) device.set_low_pass(voice.source, voice.cue.low_pass);
}

/// Those that have come through the air by now; the others are kept until they do.
std::vector<SoundCue> Mixer::Impl::arrived(std::span<const SoundCue> cues, double elapsed_s) {
    constexpr float kLongest_s = 10.0F;
    const double until_s = clock_s + elapsed_s / 2;  // the nearest frame
    std::vector<SoundCue> now;
    std::erase_if(underway, [&](CueUnderway& on_its_way) {
        if (on_its_way.heard_s > until_s) return false;
        now.push_back(std::move(on_its_way.cue));
        return true;
    });
    for (const SoundCue& cue : cues) {
        const double delay_s = static_cast<double>(std::min(cue.delay_s, kLongest_s));
        if (!(delay_s > until_s - clock_s)) {
            now.push_back(cue);
        } else if (underway.size() < kUnderway && is_playable(cue)) {
            underway.push_back({cue, clock_s + delay_s});
        }
    }
    return now;
}

void Mixer::Impl::start(Voice& voice, const ChosenCue& chosen, ALuint buffer) {
    const SoundCue& cue = chosen.cue;
    voice.state = VoiceState::Playing;
    voice.cue = cue;
    voice.loudness = chosen.loudness;
    alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(buffer));
    alSourcei(voice.source, AL_LOOPING, AL_FALSE);
    alSourcef(voice.source, AL_PITCH, cue.pitch);
    alSourcef(voice.source, AL_GAIN, chosen.loudness);
    place(voice);
    device.set_low_pass(voice.source, cue.low_pass);
    if (cue.in_head) device.keep_out_of_room(voice.source);
    alSourcePlay(voice.source);
}

void Mixer::Impl::start_cues_in_head(std::span<const SoundCue> cues, double now_s) {
    if (!device.is_open()) return;
    std::vector<SoundCue> own;
    for (const SoundCue& cue : cues)
        if (cue.in_head) own.push_back(cue);
    if (own.empty()) return;
    free_finished_voices();
    start_cues(own, now_s, 0.0);
}

void Mixer::Impl::start_cues(std::span<const SoundCue> cues, double now_s, double elapsed_s) {
    const auto limit = static_cast<std::size_t>(std::max(def.new_voices_per_frame, 0));
    const std::vector<SoundCue> heard = arrived(cues, elapsed_s);
    for (const ChosenCue& chosen : choice.choose(heard, listener.position_world, now_s, limit)) {
        const SoundCue& cue = chosen.cue;
        const SampleBuffer& buffer = buffer_of(cue.sound);
        if (buffer.name == 0) continue;
        // A louder cue with the key of a sound that has just begun takes that sound's voice.
        if (cue.merge_key != 0) {
            const auto same = std::ranges::find(
                voices, cue.merge_key, [](const Voice& voice) { return voice.cue.merge_key; });
            ALfloat played_s = 0.0F;
            if (same != voices.end()) alGetSourcef(same->source, AL_SEC_OFFSET, &played_s);
            if (same != voices.end() && static_cast<double>(played_s) < CueChoice::kMerge_s)
                fade(*same);
        }
        if (Voice* voice = voice_for(chosen.worth())) start(*voice, chosen, buffer.name);
    }
}

void Mixer::Impl::follow_loops(std::span<const LoopCue> cues, float elapsed_s) {
    for (auto& [key, loop] : loops) loop.named = false;
    for (const LoopCue& cue : cues) {
        if (!is_playable(cue)) continue;
        const auto [entry, is_new] = loops.try_emplace(cue.key);
        LoopState& loop = entry->second;
        if (is_new || loop.cue.sound != cue.sound) {
            if (Voice* voice = voice_of_loop(cue.key)) fade(*voice);
            loop.started_s = clock_s;
            loop.fade = 0.0F;
        }
        loop.cue = cue;
        loop.cue.gain = std::min(cue.gain, 1.0F);
        loop.cue.pitch = std::clamp(cue.pitch, 0.5F, 2.0F);
        loop.cue.low_pass = std::clamp(cue.low_pass, 0.0F, 1.0F);
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
        voice->state = VoiceState::Playing;
        voice->loop_key = key;
        voice->cue.low_pass = cue.low_pass;
        // Where it would be had it been heard all along.
        const double offset_s = std::fmod(clock_s - loop.started_s, buffer.length_s);
        alSourcei(voice->source, AL_BUFFER, static_cast<ALint>(buffer.name));
        alSourcei(voice->source, AL_LOOPING, AL_TRUE);
        device.set_low_pass(voice->source, cue.low_pass);
        alSourcef(voice->source, AL_SEC_OFFSET, static_cast<float>(std::max(offset_s, 0.0)));
        alSourcef(voice->source, AL_GAIN, 0.0F);
        alSourcePlay(voice->source);
    }
    voice->cue.position_world = cue.position_world;
    voice->cue.velocity_mps = cue.velocity_mps;
    voice->cue.gain = gain;
    voice->cue.radius_m = cue.radius_m;
    voice->loudness = loudness;
    alSourcef(voice->source, AL_PITCH, cue.pitch);
    dull(*voice, cue.low_pass);
}

void Mixer::Impl::update_loudness() {
    for (Voice& voice : voices) {
        const SoundCue& cue = voice.cue;
        if (voice.state != VoiceState::Playing || cue.in_head) continue;
        voice.loudness = loudness_of(cue.position_world, cue.gain, cue.radius_m);
        alSourcef(voice.source, AL_GAIN, voice.loudness);
        if (voice.loop_key != 0 || def.mono) place(voice);
    }
}

}  // namespace plumbline::audio
