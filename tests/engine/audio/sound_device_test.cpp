// OpenAL with one function of it replaced: the program's own symbols come before the library's.
#include "engine/audio/sound_device_impl.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <limits>
#include <string_view>

namespace {

bool contexts_fail = false;
bool filters_are_missing = false;
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

extern "C" ALCboolean alcIsExtensionPresent(ALCdevice* device, const ALCchar* name) {
    if (filters_are_missing && std::string_view(name) == "ALC_EXT_EFX") return ALC_FALSE;
    return library_function<LPALCISEXTENSIONPRESENT>("alcIsExtensionPresent")(device, name);
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

TEST(SoundDevice, WithoutFiltersItPlaysOnAndSaysSoOnce) {
    filters_are_missing = true;
    SoundDevice sound;
    EXPECT_TRUE(sound.open_offline(kOfflineRate_hz));
    EXPECT_FALSE(sound.has_filters());
    ALuint source = 0;
    alGenSources(1, &source);
    testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) {
        sound.set_low_pass(source, 0.3F);
        EXPECT_FALSE(sound.set_room({.gain = 0.5F, .decay_s = 1.0F + static_cast<float>(i)}));
    }
    const std::string words = testing::internal::GetCapturedStderr();
    const auto first = words.find("EFX is not available");
    EXPECT_NE(first, std::string::npos) << words;
    EXPECT_EQ(words.find("EFX is not available", first + 1), std::string::npos) << words;
    EXPECT_EQ(alGetError(), AL_NO_ERROR);
    alDeleteSources(1, &source);
    sound.close();
    filters_are_missing = false;
}

TEST(SoundDevice, ARoomIsMadeWithTheFirstThatIsHeard) {
    SoundDevice sound;
    ASSERT_TRUE(sound.open_offline(kOfflineRate_hz));
    ASSERT_TRUE(sound.has_filters());
    EXPECT_FALSE(sound.set_room({}));
    EXPECT_TRUE(sound.set_room({.gain = 0.5F}));
    EXPECT_FALSE(sound.set_room({.gain = 0.7F})) << "it is there already";
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(sound.set_room({.gain = nan, .decay_s = nan}));
    EXPECT_FALSE(sound.set_room({.gain = 9.0F, .decay_s = 1e9F, .size_m = 1e9F}));
    EXPECT_EQ(alGetError(), AL_NO_ERROR);
}

}  // namespace
}  // namespace plumbline::audio
