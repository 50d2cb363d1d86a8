// How far light and fog may be changed while a scene runs, the colours that fog may be given, and
// when lamps shine.
#pragma once

#include "engine/core/math.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace plumbline::scene {

// Bounds of LiveSwitches, and how much one press or step changes.
inline constexpr float kLiveNotch = 1.25F;
inline constexpr float kThinnestFog = 0.05F;
inline constexpr float kDensestFog = 50.0F;
inline constexpr float kDimmestLight = 0.02F;
inline constexpr float kBrightestLight = 20.0F;

/// When a light shines; the switch "lamps" goes over those that wait for the dark, and the use key makes it
/// Always or Never.
enum class LampOn : std::uint8_t { Always, Dark, Never };

struct FogColor {
    std::string_view name;
    Vec3f color;  ///< linear; of the first: the scene says
};

inline constexpr std::array<FogColor, 6> kFogColors{{{"scene colour", {}},
                                                     {"white", {0.85F, 0.88F, 0.9F}},
                                                     {"grey", {0.35F, 0.37F, 0.4F}},
                                                     {"blue", {0.22F, 0.33F, 0.5F}},
                                                     {"evening", {0.8F, 0.45F, 0.25F}},
                                                     {"green", {0.3F, 0.42F, 0.26F}}}};

}  // namespace plumbline::scene
