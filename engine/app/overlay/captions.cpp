#include "engine/app/overlay/captions.h"

#include "engine/audio/hearing.h"

#include <algorithm>
#include <cmath>

namespace plumbline::app {

std::string caption_line(const std::string& words,
                         const Vec3f& position_world,
                         const audio::Listener& listener) {
    constexpr float kAtTheEar_m = 0.3F;
    constexpr float kAhead = 0.866F;  // cosine of 30 degrees
    const Vec3f away = position_world - listener.position_world;
    const Vec3f right = listener.orientation * Vec3f{1.0F, 0.0F, 0.0F};
    const Vec3f level_ahead = glm::cross(Vec3f{0.0F, 1.0F, 0.0F}, right);
    const float to_right = glm::dot(away, right);
    const float to_front = glm::dot(away, level_ahead);
    const float across = std::hypot(to_right, to_front);
    if (!(across > kAtTheEar_m)) return words;
    if (to_front > kAhead * across) return "^ " + words;
    if (to_front < -kAhead * across) return words + " v";
    return to_right > 0.0F ? words + " >" : "< " + words;
}

void Captions::hear(const std::string& words,
                    const Vec3f& position_world,
                    double from_s,
                    const audio::Listener& listener,
                    double now_s) {
    if (words.empty()) return;
    const std::string line = caption_line(words, position_world, listener);
    const auto known = std::ranges::find(heard_, words, &Heard::words);
    if (known != heard_.end()) {
        known->line = line;
        known->until_s = from_s + kShown_s;
        return;
    }
    if (heard_.size() >= kMostLines || now_s - latest_s_ < kLeastApart_s) return;
    latest_s_ = now_s;
    heard_.push_back({words, line, from_s, from_s + kShown_s});
}

void Captions::add(const effects::SoundFrame& sound,
                   const audio::Listener& listener,
                   double now_s) {
    std::erase_if(heard_, [&](const Heard& heard) { return heard.until_s < now_s; });
    const auto loudness_of = [&](const auto& cue) {
        const float distance_m = glm::distance(cue.position_world, listener.position_world);
        return cue.gain * audio::attenuation(distance_m, cue.radius_m);
    };
    std::vector<std::pair<float, const audio::SoundCue*>> cues;
    for (const audio::SoundCue& cue : sound.cues)
        if (audio::is_playable(cue)) cues.emplace_back(loudness_of(cue), &cue);
    // Few lines: the loudest get them.
    std::ranges::sort(cues, std::ranges::greater{}, [](const auto& each) { return each.first; });
    for (const auto& [loudness, cue] : cues) {
        if (!(loudness >= kLoud)) break;
        const double heard_s = now_s + static_cast<double>(cue->delay_s);
        hear(cue->caption, cue->position_world, heard_s, listener, now_s);
    }
    for (const audio::LoopCue& loop : sound.loops) {
        if (!audio::is_playable(loop) || !(loudness_of(loop) >= kLoudLoop)) continue;
        hear(loop.caption, loop.position_world, now_s, listener, now_s);
    }
}

std::vector<std::string> Captions::lines(double now_s) const {
    std::vector<std::string> lines;
    for (const Heard& heard : heard_)
        if (heard.from_s <= now_s && now_s <= heard.until_s) lines.push_back(heard.line);
    return lines;
}

}  // namespace plumbline::app
