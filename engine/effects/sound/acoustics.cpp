#include "engine/effects/sound/acoustics.h"

#include "engine/audio/sound_cue.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::effects {

namespace {

constexpr float kPi_f = 3.14159265F;
constexpr float kAirImpedance = 413.0F;  // Pa s/m: density times speed of sound

}  // namespace

float share_through_wall(float mass_kgpm2, float frequency_hz) {
    const float inert = kPi_f * frequency_hz * std::max(mass_kgpm2, 0.0F) / kAirImpedance;
    return 1.0F / std::sqrt(1.0F + inert * inert);
}

float share_round_edge(float detour_m, float frequency_hz) {
    const float fresnel = 2.0F * std::max(detour_m, 0.0F) * frequency_hz / audio::kSpeedOfSound_mps;
    const float x = std::sqrt(2.0F * kPi_f * fresnel);
    const float bent = x < 1e-3F ? 1.0F : x / std::tanh(x);
    constexpr float kAtTheEdge = 0.5623F;  // -5 dB
    return kAtTheEdge / bent;
}

float reverberation_s(float volume_m3, float absorption_m2) {
    if (!(absorption_m2 > 0.0F)) return std::numeric_limits<float>::infinity();
    return 0.161F * volume_m3 / absorption_m2;
}

float reverberant_share(float absorption_m2) {
    if (!(absorption_m2 > 0.0F)) return std::numeric_limits<float>::infinity();
    return std::sqrt(16.0F * kPi_f / absorption_m2);
}

float water_power_W(float flow_lps, float speed_mps, float fall_m, float gravity_mps2) {
    return flow_lps * std::max(speed_mps * speed_mps / 2.0F + gravity_mps2 * fall_m, 0.0F);
}

}  // namespace plumbline::effects
