// C++ mirrors of the uniform blocks in shaders/include/blocks.glsl (std140), and the binding points
// of blocks and samplers. Sizes and offsets are asserted here and compared with what drivers
// reflect in shader_blocks_gl_test.cpp.
#pragma once

#include "engine/core/math.h"
#include "shaders/shared/limits.h"

#include <array>
#include <cstddef>
#include <utility>

namespace plumbline::render {

inline constexpr std::size_t kMaxLights = PL_MAX_LIGHTS;
inline constexpr std::size_t kMaxCascades = PL_MAX_CASCADES;
inline constexpr std::size_t kGustWaves = PL_GUST_WAVES;
inline constexpr std::size_t kSkyCoefficients = PL_SKY_COEFFICIENTS;

/// Same for all draws of a frame.
struct FrameBlock {
    Mat4f clip_from_world{1.0F};
    Mat4f world_from_ray{1.0F};  ///< (clip x, clip y, 1, 0) to the direction seen there
    Mat4f sun_shadow_from_world{1.0F};
    Mat4f flashlight_shadow_from_world{1.0F};
    Vec4f camera_world{0.0F};          ///< w: sun shadow's normal offset, m
    Vec4f to_sun_world{0.0F};          ///< w: 1 / sun shadow distance, 1/m
    Vec4f sun_radiance{0.0F};          ///< w: one texel of the sun shadow, in uv
    Vec4f ambient{0.0F};               ///< w: one texel of the flashlight's shadow, in uv
    Vec4f fog{0.0F};                   ///< rgb: colour; w: density, 1/m
    Vec4f flashlight_position{0.0F};   ///< w: 1 / radius, 1/m
    Vec4f flashlight_direction{0.0F};  ///< w: cosine of the outer angle
    Vec4f flashlight_intensity{0.0F};  ///< w: 1 / (inner cosine - outer cosine)
    /// x: exposure; y: bloom's share; z: the sky's smallest mip level; w: the sky's own exposure
    Vec4f tone{1.0F, 0.0F, 0.0F, 1.0F};
    Vec4f clusters{0.0F};  ///< xy: tiles a pixel; z: 1 / cascades; w: bias of the far ones' depth
    /// xy: its mean along x and z, m/s; z: time, s; w: so many lights cast shadows, those of the lowest
    /// numbers
    Vec4f wind{0.0F};
    /// Of each wave of gusts: xy: its number along x and z, rad/m; z: phase now, rad; w: its speed over
    /// the length of its number.
    std::array<Vec4f, kGustWaves> gusts{};
    /// Eye distance at which each but the last ends, m; w: tangent of half the sun's angular size, times
    /// how much deeper than wide its map is.
    Vec4f cascade_ends{0.0F};
    /// From the first cascade's texture coordinates to each one's: xyz: offset; w: scale.
    std::array<Vec4f, kMaxCascades> cascades{};
    std::array<Vec4f, kSkyCoefficients> sky_light{};  ///< radiance of the sky, order-2 harmonics
    /// Horizon's radiance: of itself, and by the cosine of the angle from the light's compass
    /// direction and its square. w: loss, 1/m; that direction's x and z.
    std::array<Vec4f, 3> aerial{};
    /// Texture coordinates of the light grid: place * grid[0] + grid[1]; w: how far off a surface, m;
    /// the gain.
    std::array<Vec4f, 2> grid{};
};
static_assert(sizeof(FrameBlock) ==
              4 * 64 + 12 * 16 + (kGustWaves + kMaxCascades + kSkyCoefficients + 5) * 16);
static_assert(offsetof(FrameBlock, camera_world) == 256);
static_assert(offsetof(FrameBlock, sky_light) == 544);

/// Same for all instances of a draw.
struct MaterialBlock {
    Vec4f base_color{1.0F};  ///< a: alpha
    Vec4f emissive{0.0F};    ///< w: alpha cutoff
    Vec4f surface{0.8F,
                  0.0F,
                  0.0F,
                  0.0F};  ///< x: roughness; y: metallic; z: light through a leaf; w: occlusion;
                          ///< of kPhong: exponent, highlight, how white that is, matt light
    /// x: depth of the height map, in uv; y: what glass mirrors head on; z: water's light is lost over,
    /// 1/m; w: its caustics
    Vec4f relief{0.0F};
};
static_assert(sizeof(MaterialBlock) == 64);

struct LocalLightEntry {
    Vec4f position_world{0.0F};   ///< w: 1 / radius, 1/m
    Vec4f intensity{0.0F};        ///< w: cosine of the outer angle; -2: a point light
    Vec4f direction_world{0.0F};  ///< w: 1 / (inner cosine - outer cosine)
    /// x: row in the atlas of shadow maps; yz: depth there is y - z / distance along the map's axis;
    /// w: a texel's width at 1 m
    Vec4f shadow{0.0F};
};

/// All local lights of the frame; the bits of the clusters name those that reach a surface.
struct LocalLightsBlock {
    std::array<LocalLightEntry, kMaxLights> lights{};
};
static_assert(sizeof(LocalLightsBlock) == kMaxLights * 64);
// The smallest uniform block that OpenGL 3.3 guarantees.
static_assert(sizeof(LocalLightsBlock) <= 16384);

inline constexpr unsigned int kFrameBinding = 0;
inline constexpr unsigned int kMaterialBinding = 1;
inline constexpr unsigned int kLocalLightsBinding = 2;

inline constexpr std::array<std::pair<const char*, unsigned int>, 3> kBlockBindings{{
    {"Frame", kFrameBinding},
    {"Material", kMaterialBinding},
    {"LocalLights", kLocalLightsBinding},
}};

enum TextureUnit : unsigned int {
    kBaseColorUnit = 0,
    kNormalUnit,
    kOrmUnit,
    kSunShadowUnit,
    kFlashlightShadowUnit,
    kSkyUnit,
    kSourceUnit,
    kBloomUnit,
    kDepthUnit,
    kEmissiveUnit,
    kLightMasksUnit,
    kLightShadowUnit,
    kSunDepthUnit,
    kHeightUnit,
    kOcclusionUnit,
    kShaftsUnit,
    kBlurredUnit,
    kGridMeansUnit,
    kGridSlopesUnit
};

inline constexpr std::array<std::pair<const char*, unsigned int>, 19> kSamplerUnits{{
    {"base_color_map", kBaseColorUnit},
    {"normal_map", kNormalUnit},
    {"orm_map", kOrmUnit},
    {"sun_shadow_map", kSunShadowUnit},
    {"flashlight_shadow_map", kFlashlightShadowUnit},
    {"sky_map", kSkyUnit},
    {"source_image", kSourceUnit},
    {"bloom_image", kBloomUnit},
    {"depth_image", kDepthUnit},
    {"emissive_map", kEmissiveUnit},
    {"light_masks", kLightMasksUnit},
    {"light_shadow_map", kLightShadowUnit},
    {"sun_depth_map", kSunDepthUnit},
    {"height_map", kHeightUnit},
    {"occlusion_image", kOcclusionUnit},
    {"shafts_image", kShaftsUnit},
    {"blurred_image", kBlurredUnit},
    {"grid_means", kGridMeansUnit},
    {"grid_slopes", kGridSlopesUnit},
}};

}  // namespace plumbline::render
