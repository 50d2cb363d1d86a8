// What an image may cost, as plain data: part of every RenderFrame.
#pragma once

#include "shaders/shared/limits.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::render {

enum class QualityLevel : std::uint8_t { Low, Medium, High };

inline constexpr std::array<std::string_view, 3> kImageLevelNames{"low", "medium", "high"};

/// How the edges of things are smoothed. Fxaa: in the finished image. Msaa: the scene's image keeps
/// so many samples of each pixel that an edge crosses: little on a GPU, much on a CPU. Ssaa4: the scene
/// is drawn twice as wide and high.
enum class AntiAliasing : std::uint8_t { Off, Fxaa, Msaa2, Msaa4, Msaa8, Ssaa4 };
inline constexpr std::array<std::string_view, 6> kAntiAliasingNames{
    "off", "fxaa", "msaa2", "msaa4", "msaa8", "ssaa4"};
/// Samples that the scene's image has a pixel; 1 without Msaa.
std::uint32_t samples_of(AntiAliasing way);

inline constexpr float kSmallestRenderScale = 0.4F;

/// When what the scene asks for is drawn. OnGpu is for what a CPU would take half of the frame for.
enum class Drawn : std::uint8_t { Never, OnGpu, Always };

/// The defaults leave nothing out and smooth nothing.
struct Quality {
    /// Of width and height, kSmallestRenderScale…1: the scene is drawn so large and scaled up.
    /// Lines and UI keep the full size.
    float render_scale{1.0F};
    AntiAliasing anti_aliasing{AntiAliasing::Off};
    bool surface_maps{true};    ///< normal maps, and roughness maps of what is no metal
    bool shadow_filter{true};   ///< several lookups in a shadow map instead of one
    float shadow_detail{1.0F};  ///< of the shadow map's side: 0.25…1
    /// The sun's shadows go on beyond the scene's distance to the camera's far plane, in one more
    /// cascade where there are fewer than four.
    bool far_shadows{false};
    /// So many local lights cast shadows at most, 0…PL_MAX_SHADOWED_LIGHTS: those that light most.
    std::uint32_t shadowed_lights{PL_MAX_SHADOWED_LIGHTS};
    /// Edges of the sun's shadows as wide as its disc makes them, where the scene asks.
    Drawn contact_hardening{Drawn::Always};
    Drawn parallax{Drawn::Always};  ///< height maps near the eye
    Drawn ambient_occlusion{Drawn::Always};
    Drawn sun_shafts{Drawn::Always};
    Drawn refraction{Drawn::Always};
    float lod_error_px{0.0F};  ///< a mesh may be coarser by so much; 0: always the full mesh
    float ground_cover{1.0F};  ///< of the grass, and of how far it goes; 0: none
    float smallest_px{0.0F};   ///< things that look smaller than this are left out; 0: nothing is
};

/// Low is for drawing on the CPU; High leaves out nothing that can be seen at 1280x720. A window that
/// a CPU draws takes High at 90 % of each side (app/settings/quality_control.cpp).
Quality quality_of(QualityLevel level);

/// Where a CPU draws: OnGpu is Never.
Quality without_gpu(Quality quality);

/// "low", "medium", "high"; nothing for other words.
std::optional<QualityLevel> quality_level_named(std::string_view name);
inline std::string_view name_of(QualityLevel level) {
    return kImageLevelNames[static_cast<std::size_t>(level)];
}

/// What such an image lacks, for the statistics: "render scale 60 %, surface maps"; empty: nothing.
std::string what_gave_way(const Quality& quality);

}  // namespace plumbline::render
