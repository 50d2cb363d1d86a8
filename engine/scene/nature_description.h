// What a scene file says of water that moves, as plain data in SI units and radians.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"
#include "engine/scene/screen_effects_description.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::scene {

/// A disc of still water, level, that drops fall into.
struct PoolDescription {
    Vec3 center_m{0, 0, 0};
    Real radius_m{0.5_r};
};

/// Nozzles side by side on a circle: drops leave away from its middle, across the fountain's direction.
struct NozzleRing {
    Real radius_m{0.5_r};
    int streams{16};
};

/// `[[fountain]]`: water that leaves a nozzle, falls in drops and ends in a pool or on what it hits.
struct FountainDescription {
    Vec3 position_m{0, 0, 0};  ///< of the nozzle, or the middle of the ring
    Vec3 direction{0, 1, 0};   ///< unit; of the jet, or the ring's axis
    std::optional<NozzleRing> ring{};
    Real speed_mps{3};
    Real spread_rad{radians_from_degrees(2.0_r)};  ///< drops leave within this of their direction
    Real flow_lps{0.05_r};                         ///< of all nozzles, litres a second
    Real drop_mm{6};                               ///< diameter
    bool drag{true};                               ///< of the air
    std::vector<PoolDescription> pools;            ///< that any fountain's drops fall into
    SourceLocation location{};
};

/// `[wind]`: a mean, and gusts that it carries over the land.
struct WindDescription {
    Vec3 direction{1, 0, 0};  ///< level and unit; the way the air goes
    Real speed_mps{3};
    Real gusts{0.4_r};            ///< their speed as a share of the mean
    Real gust_size_m{9};          ///< from crest to crest
    bool shelter{false};          ///< large static things keep it off what stands in their lee
    std::filesystem::path sound;  ///< a loop, heard at the ear; empty: none
    float sound_gain{0.3F};       ///< in the mean wind
    SourceLocation location{};
};

/// `[grass]`: tufts near the eye.
struct GrassDescription {
    std::vector<std::string> on;          ///< entities on whose upper side it grows
    Vec3f color{0.083F, 0.118F, 0.025F};  ///< the lawn's, on average
    Real height_m{0.09_r};
    Real density_perm2{7};
    Real distance_m{11};  ///< none grows farther from the eye
    SourceLocation location{};
};

enum class FlockKind : std::uint8_t { Birds, Butterflies };

/// `[[flock]]`: decoration in the air.
struct FlockDescription {
    FlockKind kind{FlockKind::Birds};
    int count{5};
    Vec3 center_m{0, 10, 0};
    Real radius_m{15};  ///< they stay so near the middle, seen from above
    Real height_m{4};   ///< from the lowest to the highest
    SourceLocation location{};
};

}  // namespace plumbline::scene
