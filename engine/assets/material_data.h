// How a surface looks, as authored.
#pragma once

#include "engine/core/math.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace plumbline::assets {

enum class Shading : std::uint8_t { Pbr, BlinnPhong, Unlit };
enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

/// Maps are files; an empty path means no map. All colours linear.
struct MaterialData {
    std::string name;
    Shading shading{Shading::Pbr};
    Vec3f base_color{1.0F};
    float alpha{1.0F};
    Vec3f emissive{0.0F};
    std::filesystem::path base_color_map;  ///< sRGB; alpha used by Mask and Blend
    std::filesystem::path normal_map;      ///< +Y up, as OpenGL
    std::filesystem::path orm_map;         ///< occlusion, roughness, metallic in r, g, b
    std::filesystem::path height_map;      ///< 8 bit, 1 is high
    float roughness{0.8F};                 ///< multiplies the map's
    float metallic{0.0F};                  ///< multiplies the map's when there is one
    AlphaMode alpha_mode{AlphaMode::Opaque};
    float alpha_cutoff{0.5F};  ///< Mask only
    bool two_sided{false};
    std::string surface;  ///< name in config/surfaces.toml; empty: default
};

}  // namespace plumbline::assets
