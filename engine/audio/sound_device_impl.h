// The OpenAL device and its context: opened, lost, opened again.
#pragma once

#include "engine/core/result.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>

#include <future>
#include <span>
#include <string>

namespace plumbline::audio {

/// Owns device and context; the context is current while it is open.
class SoundDevice {
public:
    SoundDevice() = default;
    ~SoundDevice();
    SoundDevice(const SoundDevice&) = delete;
    SoundDevice& operator=(const SoundDevice&) = delete;

    /// Opens the named device, else the default one (and says so). False: silence.
    bool open(const std::string& name);
    /// A device that plays nowhere and hands its samples to render().
    bool open_offline(int rate_hz);
    void close();

    /// Opening can take long where a sound server is asked: this does it on another thread. True
    /// once when the device is there.
    bool retry_in_background(const std::string& name);

    bool is_opening() const { return opening_.valid(); }

    bool is_open() const { return context_ != nullptr; }
    /// Asks the device whether it is still plugged in.
    bool is_connected() const;
    std::string name() const;
    void render(std::span<float> stereo_samples);

    /// A low-pass filter for the given openness (1: none); 0 where the device has no filters.
    ALuint low_pass_filter(float openness);

private:
    bool adopt(ALCdevice* device, const ALCint* attributes);
    void find_filters();

    ALCdevice* device_{nullptr};
    ALCcontext* context_{nullptr};
    std::future<ALCdevice*> opening_;
    LPALCRENDERSAMPLESSOFT render_samples_{nullptr};
    LPALGENFILTERS gen_filters_{nullptr};
    LPALFILTERI filter_i_{nullptr};
    LPALFILTERF filter_f_{nullptr};
    ALuint filter_{0};
};

/// All names that can be opened, for the message about one that cannot.
std::string list_devices();

}  // namespace plumbline::audio
