#include "engine/audio/sound_device_impl.h"
#include "engine/core/log.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

namespace plumbline::audio {
namespace {

using AlsaErrorHandler = void (*)(const char*, int, const char*, int, const char*, ...);

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

// Without a sound card ALSA prints eight lines and OpenAL one more, at every try. What matters is
// in our own log: "no sound device".
void silence_libraries() {
    static std::once_flag once;
    std::call_once(once, [] {
        setenv("ALSOFT_LOGLEVEL", "0", 0);  // not over what the person set
        void* alsa = dlopen("libasound.so.2", RTLD_NOW | RTLD_GLOBAL);
        if (alsa == nullptr) return;
        using SetHandler = int (*)(AlsaErrorHandler);
        const auto set_handler =
            reinterpret_cast<SetHandler>(dlsym(alsa, "snd_lib_error_set_handler"));
        if (set_handler != nullptr) set_handler(say_nothing);
    });
}

ALCdevice* open_by_name(const std::string& name) {
    silence_libraries();
    return alcOpenDevice(name.empty() ? nullptr : name.c_str());
}

ALCdevice* open_or_default(const std::string& name) {
    ALCdevice* device = open_by_name(name);
    return device == nullptr && !name.empty() ? open_by_name({}) : device;
}

template <class Function>
void load(Function& function, void* address) {
    function = reinterpret_cast<Function>(address);
}

}  // namespace

std::string list_devices() {
    const bool can_list_all = alcIsExtensionPresent(nullptr, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
    const char* names =
        alcGetString(nullptr, can_list_all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
    std::string list;
    // One name after another, each ended by a zero byte, the last by two.
    for (; names != nullptr && *names != '\0'; names += std::strlen(names) + 1) {
        if (!list.empty()) list += ", ";
        list += fmt::format("\"{}\"", names);
    }
    return list.empty() ? "none" : list;
}

SoundDevice::~SoundDevice() {
    close();
    if (opening_.valid()) {
        if (ALCdevice* late = opening_.get(); late != nullptr) alcCloseDevice(late);
    }
}

bool SoundDevice::open(const std::string& name) {
    ALCdevice* device = open_by_name(name);
    if (device == nullptr && !name.empty()) {
        log_warning("no sound device named \"{}\": using the default device. Available devices: {}",
                    name,
                    list_devices());
        device = open_by_name({});
    }
    return adopt(device, nullptr);
}

bool SoundDevice::open_offline(int rate_hz) {
    silence_libraries();
    LPALCLOOPBACKOPENDEVICESOFT open_loopback = nullptr;
    load(open_loopback, alcGetProcAddress(nullptr, "alcLoopbackOpenDeviceSOFT"));
    load(render_samples_, alcGetProcAddress(nullptr, "alcRenderSamplesSOFT"));
    if (open_loopback == nullptr || render_samples_ == nullptr) return false;
    // HRTF off: plain left and right, the same on every machine.
    const std::array<ALCint, 9> attributes{ALC_FORMAT_CHANNELS_SOFT,
                                           ALC_STEREO_SOFT,
                                           ALC_FORMAT_TYPE_SOFT,
                                           ALC_FLOAT_SOFT,
                                           ALC_FREQUENCY,
                                           rate_hz,
                                           ALC_HRTF_SOFT,
                                           ALC_FALSE,
                                           0};
    return adopt(open_loopback(nullptr), attributes.data());
}

bool SoundDevice::adopt(ALCdevice* device, const ALCint* attributes) {
    if (device == nullptr) return false;
    ALCcontext* context = alcCreateContext(device, attributes);
    if (context == nullptr || alcMakeContextCurrent(context) != ALC_TRUE) {
        if (context != nullptr) alcDestroyContext(context);
        alcCloseDevice(device);
        return false;
    }
    device_ = device;
    context_ = context;
    find_filters();
    return true;
}

void SoundDevice::find_filters() {
    filter_ = 0;
    if (alcIsExtensionPresent(device_, "ALC_EXT_EFX") != ALC_TRUE) return;
    load(gen_filters_, alGetProcAddress("alGenFilters"));
    load(filter_i_, alGetProcAddress("alFilteri"));
    load(filter_f_, alGetProcAddress("alFilterf"));
    load(gen_effects_, alGetProcAddress("alGenEffects"));
    load(effect_i_, alGetProcAddress("alEffecti"));
    load(effect_f_, alGetProcAddress("alEffectf"));
    load(gen_slots_, alGetProcAddress("alGenAuxiliaryEffectSlots"));
    load(slot_i_, alGetProcAddress("alAuxiliaryEffectSloti"));
    if (gen_filters_ == nullptr || filter_i_ == nullptr || filter_f_ == nullptr) return;
    alGetError();
    gen_filters_(1, &filter_);
    if (alGetError() != AL_NO_ERROR) filter_ = 0;
    if (filter_ != 0) filter_i_(filter_, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
}

void SoundDevice::say_no_filters() {
    if (device_ == nullptr || std::exchange(said_no_filters_, true)) return;
    log_note("sound: EFX is not available: walls only reduce volume, and rooms have no reverb");
}

void SoundDevice::set_low_pass(ALuint source, float openness) {
    if (filter_ == 0) {
        if (openness < 1.0F) say_no_filters();
        return;
    }
    constexpr float kDullest = 0.01F;  // of the high frequencies' gain
    ALint filter = AL_FILTER_NULL;
    if (openness < 1.0F) {
        filter_f_(filter_, AL_LOWPASS_GAIN, 1.0F);
        filter_f_(filter_, AL_LOWPASS_GAINHF, std::max(openness * openness, kDullest));
        filter = static_cast<ALint>(filter_);
    }
    alSourcei(source, AL_DIRECT_FILTER, filter);
    if (room_slot_ == 0) return;
    // What a room does by distance is in the gain already.
    alSourcei(source, AL_AUXILIARY_SEND_FILTER_GAIN_AUTO, AL_FALSE);
    alSourcei(source, AL_AUXILIARY_SEND_FILTER_GAINHF_AUTO, AL_FALSE);
    alSource3i(source, AL_AUXILIARY_SEND_FILTER, static_cast<ALint>(room_slot_), 0, filter);
}

void SoundDevice::keep_out_of_room(ALuint source) {
    if (room_slot_ != 0)
        alSource3i(source, AL_AUXILIARY_SEND_FILTER, AL_EFFECTSLOT_NULL, 0, AL_FILTER_NULL);
}

bool SoundDevice::make_room() {
    const bool can = filter_ != 0 && gen_effects_ != nullptr && effect_i_ != nullptr &&
                     effect_f_ != nullptr && gen_slots_ != nullptr && slot_i_ != nullptr;
    if (!can) {
        say_no_filters();
        return false;
    }
    alGetError();
    gen_effects_(1, &reverb_);
    effect_i_(reverb_, AL_EFFECT_TYPE, AL_EFFECT_REVERB);
    gen_slots_(1, &room_slot_);
    if (alGetError() == AL_NO_ERROR) return true;
    room_slot_ = 0;
    say_no_filters();
    return false;
}

bool SoundDevice::set_room(const Room& room) {
    const auto differ = [](float a, float b) {
        return std::abs(a - b) > 0.02F * std::max(std::abs(a), std::abs(b));
    };
    const bool changed = differ(room.gain, room_.gain) ||
                         (room.gain > 0.0F && (differ(room.decay_s, room_.decay_s) ||
                                               differ(room.size_m, room_.size_m)));
    const bool is_number = std::isfinite(room.gain + room.decay_s + room.size_m);
    if (context_ == nullptr || !changed || !is_number) return false;
    const bool is_first = room_slot_ == 0;
    if (is_first && !make_room()) {
        room_ = room;  // not tried again until it changes
        return false;
    }
    room_ = room;
    const float decay_s = std::clamp(room.decay_s, AL_REVERB_MIN_DECAY_TIME, 20.0F);
    // Steady noise through the device's reverberation at a late gain of 1, against the same noise
    // unchanged, as measured.
    const float level = 0.55F * std::sqrt(decay_s) * std::exp(-0.6F / decay_s);
    const float gain = std::clamp(room.gain, 0.0F, 1.0F);
    const float across_s = std::clamp(room.size_m, 0.5F, 30.0F) / kSpeedOfSound_mps;
    effect_f_(reverb_, AL_REVERB_GAIN, 1.0F);
    effect_f_(reverb_, AL_REVERB_GAINHF, 0.9F);
    effect_f_(reverb_, AL_REVERB_DECAY_TIME, decay_s);
    effect_f_(reverb_, AL_REVERB_DECAY_HFRATIO, 0.9F);
    effect_f_(reverb_, AL_REVERB_REFLECTIONS_GAIN, 0.25F * gain);
    effect_f_(reverb_, AL_REVERB_REFLECTIONS_DELAY, across_s);
    effect_f_(reverb_, AL_REVERB_LATE_REVERB_GAIN, std::clamp(gain / level, 0.0F, 10.0F));
    effect_f_(reverb_, AL_REVERB_LATE_REVERB_DELAY, across_s);
    slot_i_(room_slot_, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(reverb_));
    return is_first;
}

void SoundDevice::close() {
    if (context_ == nullptr) return;
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context_);  // takes filter and room along
    alcCloseDevice(device_);
    context_ = nullptr;
    device_ = nullptr;
    filter_ = 0;
    reverb_ = 0;
    room_slot_ = 0;
    room_ = {};
}

bool SoundDevice::retry_in_background(const std::string& name) {
    if (!opening_.valid()) {
        // Where no thread can be made it is opened by whoever asks next.
        opening_ = std::async(std::launch::async | std::launch::deferred, open_or_default, name);
        return false;
    }
    if (opening_.wait_for(std::chrono::seconds{0}) == std::future_status::timeout) return false;
    return adopt(opening_.get(), nullptr);
}

bool SoundDevice::is_connected() const {
    if (device_ == nullptr) return false;
    if (alcIsExtensionPresent(device_, "ALC_EXT_disconnect") != ALC_TRUE) return true;
    ALCint connected = ALC_TRUE;
    alcGetIntegerv(device_, ALC_CONNECTED, 1, &connected);
    return connected != ALC_FALSE;
}

std::string SoundDevice::name() const {
    if (device_ == nullptr) return {};
    const char* name = alcGetString(device_, ALC_ALL_DEVICES_SPECIFIER);
    return name == nullptr ? std::string{} : std::string{name};
}

void SoundDevice::render(std::span<float> stereo_samples) {
    if (render_samples_ == nullptr || device_ == nullptr) {
        std::ranges::fill(stereo_samples, 0.0F);
        return;
    }
    render_samples_(
        device_, stereo_samples.data(), static_cast<ALCsizei>(stereo_samples.size() / 2));
}

}  // namespace plumbline::audio
