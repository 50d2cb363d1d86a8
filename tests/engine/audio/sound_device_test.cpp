// OpenAL with one function of it replaced: the program's own symbols come before the library's.
#include "engine/audio/sound_device_impl.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

namespace {

bool contexts_fail = false;
int devices_closed = 0;

template <class Function>
Function library_function(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" ALCcontext* alcCreateContext(ALCdevice* device, const ALCint* attributes) {
    if (contexts_fail) return nullptr;
    return library_function<LPALCCREATECONTEXT>("alcCreateContext")(device, attributes);
}

extern "C" ALCboolean alcCloseDevice(ALCdevice* device) {
    ++devices_closed;
    return library_function<LPALCCLOSEDEVICE>("alcCloseDevice")(device);
}

namespace plumbline::audio {
namespace {

constexpr int kOfflineRate_hz = 44'100;

// EXPERIENCE B4
TEST(SoundDevice, WithoutAContextTheDeviceIsClosedAgain) {
    SoundDevice sound;
    contexts_fail = true;
    devices_closed = 0;
    EXPECT_FALSE(sound.open_offline(kOfflineRate_hz));
    EXPECT_EQ(devices_closed, 1);
    EXPECT_FALSE(sound.is_open());
    EXPECT_EQ(sound.name(), "");

    contexts_fail = false;
    EXPECT_TRUE(sound.open_offline(kOfflineRate_hz)) << "a later try finds everything as it was";
    sound.close();
    EXPECT_EQ(devices_closed, 2);
}

}  // namespace
}  // namespace plumbline::audio
