#include "engine/audio/mixer.h"

#include "engine/audio/mixer_impl.h"
#include "engine/core/log.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::audio {
namespace {

constexpr double kRetry_s = 5.0;
constexpr double kConnectionCheck_s = 1.0;
constexpr double kMaxFrame_s = 0.25;
constexpr int kMaxVoices = 256;
constexpr int kFadingVoices = 8;

float finite_gain(float gain) {
    return std::isfinite(gain) ? std::clamp(gain, 0.0F, 1.0F) : 1.0F;
}

}  // namespace

void Mixer::Impl::open_device() {
    const bool is_open =
        def.offline ? device.open_offline(kOfflineRate_hz) : device.open(def.device);
    if (is_open) prepare_device();
}

void Mixer::Impl::prepare_device() {
    said_silent = false;
    log_note("sound: {}", device.name());
    alDistanceModel(AL_NONE);  // hearing.cpp decides what distance does
    alSpeedOfSound(kSpeedOfSound_mps);
    alDopplerFactor(def.doppler ? 1.0F : 0.0F);
    alListenerf(AL_GAIN, def.master_gain);
    voices.clear();
    const int wanted = std::clamp(def.voices, 1, kMaxVoices);
    alGetError();
    for (int i = 0; i < wanted + kFadingVoices; ++i) {
        Voice voice;
        alGenSources(1, &voice.source);
        if (alGetError() != AL_NO_ERROR) break;  // as many as the device has
        voices.push_back(voice);
    }
    most_playing = std::min(voices.size(), static_cast<std::size_t>(wanted));
}

void Mixer::Impl::forget_device() {
    for (const Voice& voice : voices) alDeleteSources(1, &voice.source);
    for (const auto& [sound, buffer] : buffers)
        if (buffer.name != 0) alDeleteBuffers(1, &buffer.name);
    voices.clear();
    buffers.clear();
    underway.clear();
    device.close();
}

void Mixer::Impl::watch_device(double now_s) {
    if (device.is_open()) {
        if (now_s < next_check_s) return;
        next_check_s = now_s + kConnectionCheck_s;
        if (device.is_connected()) return;
        log_note("sound device lost");
        forget_device();
        next_check_s = now_s;
    }
    if (!said_silent) {
        log_note("no sound device: sound is off; retrying every {} s", kRetry_s);
        said_silent = true;
        if (next_check_s <= 0.0) next_check_s = now_s + kRetry_s;
    }
    if (def.offline || now_s < next_check_s) return;
    if (device.retry_in_background(def.device)) {
        prepare_device();
        next_check_s = now_s + kConnectionCheck_s;
    } else if (!device.is_opening()) {
        next_check_s = now_s + kRetry_s;
    }
}

void Mixer::Impl::set_listener(const Listener& wanted) {
    if (!is_finite(wanted.position_world) || !is_finite(wanted.orientation)) return;
    listener = wanted;
    if (!is_finite(listener.velocity_mps)) listener.velocity_mps = Vec3f{0.0F};
    listener.velocity_mps = with_bounded_speed(listener.velocity_mps);
    const float length = glm::length(listener.orientation);
    listener.orientation =
        length > 1e-6F ? listener.orientation / length : Quatf{1.0F, 0.0F, 0.0F, 0.0F};
    const Vec3f ahead = listener.orientation * Vec3f{0.0F, 0.0F, -1.0F};
    const Vec3f up = listener.orientation * Vec3f{0.0F, 1.0F, 0.0F};
    const std::array<float, 6> axes{ahead.x, ahead.y, ahead.z, up.x, up.y, up.z};
    const Vec3f& position = listener.position_world;
    const Vec3f& velocity = listener.velocity_mps;
    alListener3f(AL_POSITION, position.x, position.y, position.z);
    alListener3f(AL_VELOCITY, velocity.x, velocity.y, velocity.z);
    alListenerfv(AL_ORIENTATION, axes.data());
}

Mixer::Mixer(const MixerDef& def, const assets::AssetLibrary& library)
    : impl_(std::make_unique<Impl>(def, library)) {
    impl_->def.master_gain = finite_gain(def.master_gain);
    impl_->open_device();
}

Mixer::~Mixer() {
    if (impl_->device.is_open()) impl_->forget_device();
}

void Mixer::play(std::span<const SoundCue> cues,
                 std::span<const LoopCue> loops,
                 const Listener& listener,
                 double now_s) {
    if (!std::isfinite(now_s)) return;
    const double elapsed_s =
        impl_->started ? std::clamp(now_s - impl_->last_now_s, 0.0, kMaxFrame_s) : 0.0;
    impl_->started = true;
    impl_->last_now_s = now_s;
    impl_->watch_device(now_s);
    if (impl_->paused) {
        impl_->start_cues_in_head(cues, now_s);
        return;
    }
    impl_->clock_s += elapsed_s;
    if (!impl_->device.is_open()) return;
    impl_->set_listener(listener);
    impl_->free_finished_voices();
    impl_->follow_room(listener.room);
    impl_->start_cues(cues, now_s, elapsed_s);
    impl_->follow_loops(loops, static_cast<float>(elapsed_s));
    impl_->update_loudness();
}

bool Mixer::silent() const {
    return !impl_->device.is_open();
}

std::string Mixer::device_name() const {
    return impl_->device.name();
}

std::size_t Mixer::voices_playing() const {
    return impl_->playing();
}

std::size_t Mixer::bytes() const {
    std::size_t bytes = 0;
    for (const auto& [sound, buffer] : impl_->buffers) bytes += buffer.bytes;
    return bytes;
}

void Mixer::set_paused(bool paused) {
    if (impl_->paused == paused) return;
    impl_->paused = paused;
    for (const Voice& voice : impl_->voices) {
        if (voice.cue.in_head) continue;
        ALint state = AL_STOPPED;
        alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
        if (paused && state == AL_PLAYING) alSourcePause(voice.source);
        if (!paused && state == AL_PAUSED) alSourcePlay(voice.source);
    }
}

void Mixer::set_master_gain(float gain) {
    impl_->def.master_gain = finite_gain(gain);
    if (impl_->device.is_open()) alListenerf(AL_GAIN, impl_->def.master_gain);
}

void Mixer::set_mono(bool mono) {
    impl_->def.mono = mono;
    if (!impl_->device.is_open()) return;
    for (const Voice& voice : impl_->voices)
        if (voice.state == VoiceState::Playing) impl_->place(voice);
}

void Mixer::set_doppler(bool doppler) {
    impl_->def.doppler = doppler;
    if (impl_->device.is_open()) alDopplerFactor(doppler ? 1.0F : 0.0F);
}

bool Mixer::has_filters() const {
    return impl_->device.has_filters();
}

void Mixer::reopen(const std::string& device) {
    if (impl_->device.is_open()) impl_->forget_device();
    impl_->def.device = device;
    impl_->open_device();
}

void Mixer::render(std::span<float> samples) {
    impl_->device.render(samples);
}

}  // namespace plumbline::audio
