#include "engine/audio/sound_device_impl.h"
#include "engine/core/log.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <mutex>

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
        log_warning(
            "no sound device \"{}\": the default one is used. There are: {}", name, list_devices());
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
    if (gen_filters_ == nullptr || filter_i_ == nullptr || filter_f_ == nullptr) return;
    alGetError();
    gen_filters_(1, &filter_);
    if (alGetError() != AL_NO_ERROR) filter_ = 0;
    if (filter_ != 0) filter_i_(filter_, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
}

ALuint SoundDevice::low_pass_filter(float openness) {
    if (filter_ == 0 || openness >= 1.0F) return AL_FILTER_NULL;
    constexpr float kDullest = 0.01F;  // of the high frequencies' gain
    filter_f_(filter_, AL_LOWPASS_GAIN, 1.0F);
    filter_f_(filter_, AL_LOWPASS_GAINHF, std::max(openness * openness, kDullest));
    return filter_;
}

void SoundDevice::close() {
    if (context_ == nullptr) return;
    alcMakeContextCurrent(nullptr);
    alcDestroyContext(context_);  // takes the filter along
    alcCloseDevice(device_);
    context_ = nullptr;
    device_ = nullptr;
    filter_ = 0;
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
