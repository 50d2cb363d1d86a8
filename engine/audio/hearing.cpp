#include "engine/audio/hearing.h"

#include <algorithm>
#include <cmath>

namespace plumbline::audio {
namespace {

constexpr float kReference_m = 1.0F;
constexpr float kLargestPosition_m = 1e6F;

bool is_near(const Vec3f& position_world) {
    return is_finite(position_world) && std::abs(position_world.x) < kLargestPosition_m &&
           std::abs(position_world.y) < kLargestPosition_m &&
           std::abs(position_world.z) < kLargestPosition_m;
}

/// Of either kind: finite everywhere, some gain, some radius, a sound.
template <class Cue>
bool is_sound(const Cue& cue) {
    return cue.sound.value != 0 && is_near(cue.position_world) && std::isfinite(cue.gain) &&
           cue.gain > 0.0F && std::isfinite(cue.pitch) && std::isfinite(cue.radius_m) &&
           cue.radius_m > 0.0F && std::isfinite(cue.low_pass);
}

SoundCue in_range(SoundCue cue) {
    cue.gain = std::min(cue.gain, 1.0F);
    cue.pitch = std::clamp(cue.pitch, 0.5F, 2.0F);
    cue.low_pass = std::clamp(cue.low_pass, 0.0F, 1.0F);
    cue.importance = std::isfinite(cue.importance) ? std::clamp(cue.importance, 0.0F, 1e3F) : 1.0F;
    return cue;
}

}  // namespace

Vec3f with_bounded_speed(const Vec3f& velocity_mps) {
    constexpr float kFastest_mps = 60.0F;
    if (!is_finite(velocity_mps)) return Vec3f{0.0F};
    const float speed_mps = glm::length(velocity_mps);
    return speed_mps > kFastest_mps ? velocity_mps * (kFastest_mps / speed_mps) : velocity_mps;
}

MonoPlace place_in_mono(const Vec3f& position_world,
                        const Vec3f& velocity_mps,
                        const Listener& listener) {
    const Vec3f ahead = listener.orientation * Vec3f{0.0F, 0.0F, -1.0F};
    const Vec3f away = position_world - listener.position_world;
    const float distance_m = glm::length(away);
    const Vec3f direction = distance_m > 1e-6F ? away / distance_m : ahead;
    const float going_mps = glm::dot(velocity_mps - listener.velocity_mps, direction);
    return {.position_world = listener.position_world + ahead * std::max(distance_m, 1e-3F),
            .velocity_mps = listener.velocity_mps + ahead * going_mps};
}

float attenuation(float distance_m, float radius_m) {
    if (!(radius_m > 0.0F) || !(distance_m < radius_m)) return 0.0F;
    const float reference_m = std::min(kReference_m, radius_m * 0.25F);
    const float inverse = reference_m / std::max(distance_m, reference_m);
    const float share = distance_m / radius_m;
    const float window = 1.0F - share * share;
    return inverse * window;
}

bool is_playable(const SoundCue& cue) {
    return is_sound(cue);
}

bool is_playable(const LoopCue& cue) {
    return cue.key != 0 && is_sound(cue);
}

std::vector<ChosenCue> CueChoice::choose(std::span<const SoundCue> cues,
                                         const Vec3f& listener_world,
                                         double now_s,
                                         std::size_t limit) {
    std::erase_if(recent_, [&](const auto& entry) {
        return !(std::abs(now_s - entry.second.time_s) < kMerge_s);
    });
    std::vector<ChosenCue> heard;
    for (const SoundCue& cue : cues) {
        if (!is_playable(cue)) continue;
        const SoundCue ranged = in_range(cue);
        const float distance_m = glm::length(ranged.position_world - listener_world);
        const float distant = ranged.in_head ? 1.0F : attenuation(distance_m, ranged.radius_m);
        const float loudness = ranged.gain * distant;
        if (loudness >= kInaudible) heard.push_back({ranged, loudness});
    }
    std::ranges::stable_sort(heard, std::ranges::greater{}, &ChosenCue::worth);

    std::vector<ChosenCue> chosen;
    for (const ChosenCue& candidate : heard) {
        if (chosen.size() >= limit) break;
        const std::uint64_t key = candidate.cue.merge_key;
        if (key != 0) {
            const auto found = recent_.find(key);
            if (found != recent_.end() && found->second.loudness >= candidate.loudness) continue;
            recent_[key] = {now_s, candidate.loudness};
        }
        chosen.push_back(candidate);
    }
    return chosen;
}

}  // namespace plumbline::audio
