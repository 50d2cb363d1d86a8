// A request to hear something. Plain data; the mixer decides what is really heard.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/core/math.h"

#include <cstdint>

namespace plumbline::audio {

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
};

/// A sound that goes on while its owner names it every frame.
struct LoopCue {
    std::uint64_t key{0};  ///< names the loop from frame to frame; not 0
    assets::SoundId sound{};
    Vec3f position_world{0.0F};
    float gain{1.0F};
    float pitch{1.0F};  ///< 0.5…2
    float radius_m{12.0F};
};

struct Listener {
    Vec3f position_world{0.0F};
    Quatf orientation{1.0F, 0.0F, 0.0F, 0.0F};  ///< world_from_listener; looks down -Z
    Vec3f velocity_mps{0.0F};
};

}  // namespace plumbline::audio
