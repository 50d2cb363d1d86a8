// How a surface looks, as authored.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace plumbline::assets {

enum class Shading : std::uint8_t { Pbr, BlinnPhong, Unlit };
enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

/// Maps are files, or the names of images that a model file holds; an empty path means no map. All
/// colours linear. So many fields because each property that a material may have is one.
struct MaterialData {
    std::string name;
    Shading shading{Shading::Pbr};
    Vec3f base_color{1.0F};
    float alpha{1.0F};
    Vec3f emissive{0.0F};
    std::filesystem::path base_color_map;  ///< sRGB; alpha used by Mask and Blend
    std::filesystem::path normal_map;      ///< +Y up, as OpenGL
    std::filesystem::path orm_map;         ///< occlusion, roughness, metallic in r, g, b
    std::filesystem::path emissive_map;    ///< sRGB; multiplies `emissive`
    std::filesystem::path height_map;      ///< 8 bit, 1 is high
    float height_depth{0.0F};              ///< from high to low, of the map's width
    float roughness{0.8F};                 ///< multiplies the map's
    float metallic{0.0F};                  ///< multiplies the map's when there is one
    float occlusion{1.0F};                 ///< how much of orm_map's red counts
    /// BlinnPhong: above 0 the textbook's highlight, `specular` times the cosine between mirrored
    /// light and eye to this power, in the surface's colour; normals are taken as they are.
    float shininess{0.0F};
    float specular{0.5F};
    float diffuse{1.0F};  ///< share of the matt light, where the highlight is the textbook's
    bool white_highlight{false};  ///< ... and that highlight in the light's colour
    bool flat{false};             ///< each triangle has its first vertex's normal all over
    bool vertex_colors{false};    ///< shown even under a base colour map
    AlphaMode alpha_mode{AlphaMode::Opaque};
    float alpha_cutoff{0.5F};  ///< Mask only
    /// Above 0, with Blend: clear glass of this index of refraction; what it mirrors is not blended away.
    float ior{0.0F};
    bool two_sided{false};
    bool thin{
        true};  ///< two_sided, not metal and not blended: light comes through, as through a leaf
    /// Above 0: water, whose ripples run with this mean slope; it mirrors more the flatter it is seen.
    float ripple_slope{0.0F};
    /// Of water, above 0: what lies below is bent, and light that went so far through it has taken the
    /// base colour. 0: the surface hides its alpha.
    float attenuation_m{0.0F};
    /// Of water with attenuation_m: the sun's light below gathers as ripples this many times as steep
    /// would gather it; 0: it is even.
    float caustics{0.0F};
    /// How much the base colour map varies over metres, so that its tile is not seen: 0…1.
    float variation{0.0F};
    std::string surface;  ///< name in config/surfaces.toml; empty: default

    friend bool operator==(const MaterialData&, const MaterialData&) = default;
};

}  // namespace plumbline::assets
