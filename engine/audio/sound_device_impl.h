// The OpenAL device and its context: opened, lost, opened again.
#pragma once

#include "engine/audio/sound_cue.h"
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

    /// Whether the device has filters and rooms (EFX).
    bool has_filters() const { return filter_ != 0; }
    /// Dulls a source, also where it leads into the room: 1 open … 0 dull. Without filters nothing
    /// happens, which is said once.
    void set_low_pass(ALuint source, float openness);
    void keep_out_of_room(ALuint source);
    /// The room that sources lead into; it is made with the first that has a gain. True then: the
    /// low pass of every source is to be set, which leads it there.
    bool set_room(const Room& room);

private:
    bool adopt(ALCdevice* device, const ALCint* attributes);
    void find_filters();
    bool make_room();
    void say_no_filters();

    ALCdevice* device_{nullptr};
    ALCcontext* context_{nullptr};
    std::future<ALCdevice*> opening_;
    LPALCRENDERSAMPLESSOFT render_samples_{nullptr};
    LPALGENFILTERS gen_filters_{nullptr};
    LPALFILTERI filter_i_{nullptr};
    LPALFILTERF filter_f_{nullptr};
    LPALGENEFFECTS gen_effects_{nullptr};
    LPALEFFECTI effect_i_{nullptr};
    LPALEFFECTF effect_f_{nullptr};
    LPALGENAUXILIARYEFFECTSLOTS gen_slots_{nullptr};
    LPALAUXILIARYEFFECTSLOTI slot_i_{nullptr};
    ALuint filter_{0};
    ALuint reverb_{0};
    ALuint room_slot_{0};  ///< 0: no room so far
    Room room_{};          ///< as the device has it
    bool said_no_filters_{false};
};

/// All names that can be opened, for the message about one that cannot.
std::string list_devices();

}  // namespace plumbline::audio
