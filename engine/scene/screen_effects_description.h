// What a scene file asks of its image beyond things and lights, as plain data.
#pragma once

#include "engine/core/math.h"
#include "engine/core/text/source_location.h"

#include <cstdint>
#include <optional>

namespace plumbline::scene {

/// How much an effect spends on being right.
enum class Fidelity : std::uint8_t { Draft, Balanced, Precise };

/// `[ambient] occlusion`: less of the ambient light reaches corners and narrow places.
struct OcclusionDescription {
    float radius_m{0.8F};  ///< what is farther than this takes no light away
    float strength{1.0F};  ///< 0: nothing is taken away; 1: all that is hidden
    SourceLocation location{};
};

/// `[ambient] indirect`: a box, such as a house, whose light comes in by windows.
struct IndirectLightDescription {
    Vec3 min_m{0, 0, 0};  ///< the box of its rooms, up to the inner faces of its outer walls
    Vec3 max_m{1, 1, 1};
    float spacing_m{0.5F};  ///< of the points at which light is computed
    float gain{1.0F};       ///< times that much: eyes adapt to a room
    SourceLocation location{};
};

/// `[ambient]`: light from everywhere.
struct AmbientDescription {
    Vec3f color{0.1F, 0.1F, 0.12F};
    std::optional<OcclusionDescription> occlusion{};
    std::optional<IndirectLightDescription> indirect{};
};

/// `[sun] shafts`: air that the sun lights up where it is not in shadow.
struct ShaftsDescription {
    float density_per_m{0.003F};  ///< exp(-density * distance) of the light gets through
    float distance_m{60.0F};      ///< from the eye; beyond it nothing is added
    SourceLocation location{};
};

/// `[camera] focus`: a lens. What is not at its distance is blurred.
struct FocusDescription {
    float distance_m{4.0F};   ///< along the line of sight
    float aperture_m{0.02F};  ///< diameter of the lens' opening
    SourceLocation location{};
};

/// `[post] shutter_s`: what moves across the image while it is taken is blurred.
struct ShutterDescription {
    float open_s{1.0F / 60.0F};
    SourceLocation location{};
};

/// `[effects.NAME] fidelity` of the effects above.
struct ScreenFidelity {
    Fidelity occlusion{Fidelity::Balanced};
    Fidelity shafts{Fidelity::Balanced};
    Fidelity focus{Fidelity::Balanced};
    Fidelity shutter{Fidelity::Balanced};
};

}  // namespace plumbline::scene
