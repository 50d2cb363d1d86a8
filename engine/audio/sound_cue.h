// A request to hear something. Plain data; the mixer decides what is really heard.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <string>

namespace plumbline::audio {

/// Of sound in air; what delays and shifts it.
inline constexpr float kSpeedOfSound_mps = 343.0F;

/// Whose bodies a sound comes from: they do not stand in its own way. Marks of entities; 0: none.
using SoundMakers = std::array<std::uint64_t, 2>;

/// One short sound at a place.
struct SoundCue {
    assets::SoundId sound{};
    Vec3f position_world{0.0F};
    float gain{1.0F};       ///< 0…1
    float pitch{1.0F};      ///< 0.5…2
    float radius_m{25.0F};  ///< silent beyond
    float low_pass{1.0F};   ///< 1 open … 0 dull
    std::uint64_t merge_key{
        0};  ///< cues with one key within 50 ms are merged into the loudest; 0: never
    Vec3f velocity_mps{0.0F};
    float delay_s{0.0F};     ///< until it is heard, 0…10
    float importance{1.0F};  ///< where voices are few it counts as so much louder
    bool in_head{
        false};  ///< the program's own: from no place, and heard while the world stands still
    SoundMakers made_by{};
    std::string caption{};  ///< what a person would call it: "wood hits stone"; empty: nothing
};

/// A sound that goes on while its owner names it every frame.
struct LoopCue {
    std::uint64_t key{0};  ///< names the loop from frame to frame; not 0
    assets::SoundId sound{};
    Vec3f position_world{0.0F};
    float gain{1.0F};
    float pitch{1.0F};  ///< 0.5…2
    float radius_m{12.0F};
    float low_pass{1.0F};  ///< 1 open … 0 dull
    Vec3f velocity_mps{0.0F};
    SoundMakers made_by{};
    std::string caption{};
};

/// What walls round the listener give back of every sound.
struct Room {
    float gain{0.0F};     ///< of the reverberation, steady, against a sound 1 m away; 0: open air
    float decay_s{0.5F};  ///< in which it falls by 60 dB, 0.1…20
    float size_m{3.0F};   ///< mean way from wall to wall
};

struct Listener {
    Vec3f position_world{0.0F};
    Quatf orientation{1.0F, 0.0F, 0.0F, 0.0F};  ///< world_from_listener; looks down -Z
    Vec3f velocity_mps{0.0F};
    Room room{};
};

}  // namespace plumbline::audio
