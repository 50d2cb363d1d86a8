// What a shader variant can do. Each bit becomes `#define PL_NAME 1`, and only then its code exists.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace plumbline::render {

using FeatureSet = std::uint64_t;

namespace feature {
// of the material
inline constexpr FeatureSet kBlinnPhong = 1ULL << 0U;
inline constexpr FeatureSet kUnlit = 1ULL << 1U;
inline constexpr FeatureSet kBaseMap = 1ULL << 2U;
inline constexpr FeatureSet kNormalMap = 1ULL << 3U;
inline constexpr FeatureSet kOrmMap = 1ULL << 4U;
inline constexpr FeatureSet kAlphaMask = 1ULL << 5U;
/// Of the mesh: few triangles, each of one normal and one colour.
inline constexpr FeatureSet kFaceted = 1ULL << 53U;
inline constexpr FeatureSet kBlend = 1ULL << 6U;
inline constexpr FeatureSet kTwoSided = 1ULL << 7U;
inline constexpr FeatureSet kLeaf = 1ULL << 8U;
inline constexpr FeatureSet kVertexColor = 1ULL << 9U;
inline constexpr FeatureSet kSkyReflection = 1ULL << 10U;
inline constexpr FeatureSet kEmissiveMap = 1ULL << 11U;
inline constexpr FeatureSet kMetal = 1ULL << 12U;  ///< in part at least
inline constexpr FeatureSet kEmissive = 1ULL << 13U;
inline constexpr FeatureSet kPhong = 1ULL << 14U;    ///< with kBlinnPhong: the textbook's highlight
inline constexpr FeatureSet kFlat = 1ULL << 15U;     ///< normals are not blended across triangles
inline constexpr FeatureSet kRipples = 1ULL << 32U;  ///< water: normals that run
inline constexpr FeatureSet kVariation = 1ULL << 33U;  ///< of the base colour over metres
inline constexpr FeatureSet kParallax = 1ULL << 48U;   ///< with kNormalMap: a height map
inline constexpr FeatureSet kGlass = 1ULL
                                     << 49U;  ///< with kBlend: mirrors, and shows what is behind
inline constexpr FeatureSet kRefraction = 1ULL
                                          << 50U;  ///< with kRipples: shows what is below, bent
// of the frame
inline constexpr FeatureSet kSun = 1ULL << 16U;
inline constexpr FeatureSet kSunShadow = 1ULL << 17U;
inline constexpr FeatureSet kFlashlight = 1ULL << 18U;
/// With kFlashlight: its shadows fall where the eye does not see them, so there are none.
inline constexpr FeatureSet kFlashlightAtEye = 1ULL << 56U;
inline constexpr FeatureSet kLocalLights = 1ULL << 19U;
inline constexpr FeatureSet kFog = 1ULL << 20U;
inline constexpr FeatureSet kSkyLight = 1ULL << 21U;
inline constexpr FeatureSet kSoftShadows = 1ULL << 22U;   ///< four taps: where lookups are cheap
inline constexpr FeatureSet kHardShadows = 1ULL << 23U;   ///< one tap
inline constexpr FeatureSet kCascades = 1ULL << 30U;      ///< more than one
inline constexpr FeatureSet kWind = 1ULL << 34U;          ///< and of the mesh: it sways
inline constexpr FeatureSet kAerial = 1ULL << 35U;        ///< far things go over into the sky
inline constexpr FeatureSet kClouds = 1ULL << 36U;        ///< before a computed sky
inline constexpr FeatureSet kLightShadows = 1ULL << 46U;  ///< with kLocalLights
inline constexpr FeatureSet kContactHardening = 1ULL << 47U;  ///< with kSunShadow
inline constexpr FeatureSet kCaustics = 1ULL << 51U;          ///< with kRefraction and kSun
inline constexpr FeatureSet kCodes = 1ULL << 57U;             ///< surfaces and sky write sRGB codes
// of the passes after the scene
inline constexpr FeatureSet kToneMap = 1ULL << 24U;  ///< exposure and tone curve
inline constexpr FeatureSet kBloom = 1ULL << 25U;
inline constexpr FeatureSet kKeepDepth = 1ULL << 26U;  ///< lines will be drawn over the image
inline constexpr FeatureSet kFxaa = 1ULL << 27U;
inline constexpr FeatureSet kSharpen = 1ULL << 28U;
inline constexpr FeatureSet kFourSamples = 1ULL << 31U;  ///< two by two make a pixel
inline constexpr FeatureSet kSkyCodes = 1ULL << 29U;     ///< the sky's faces hold sRGB codes
// light that is added after the scene
inline constexpr FeatureSet kOcclusion = 1ULL << 40U;  ///< less ambient light in corners
inline constexpr FeatureSet kCoverage = 1ULL << 42U;   ///< masks cover samples, not whole pixels
inline constexpr FeatureSet kMoved = 1ULL << 52U;      ///< things moved while the shutter was open
inline constexpr FeatureSet kShafts = 1ULL << 41U;     ///< light from air in the sun
}  // namespace feature

/// What a thing is drawn without where the flashlight cannot reach it.
inline constexpr FeatureSet kFlashlightFeatures = feature::kFlashlight | feature::kFlashlightAtEye;

inline constexpr std::array<std::pair<FeatureSet, std::string_view>, 50> kFeatureNames{{
    {feature::kBlinnPhong, "PL_BLINN_PHONG"},
    {feature::kUnlit, "PL_UNLIT"},
    {feature::kBaseMap, "PL_BASE_MAP"},
    {feature::kNormalMap, "PL_NORMAL_MAP"},
    {feature::kOrmMap, "PL_ORM_MAP"},
    {feature::kAlphaMask, "PL_ALPHA_MASK"},
    {feature::kBlend, "PL_BLEND"},
    {feature::kTwoSided, "PL_TWO_SIDED"},
    {feature::kLeaf, "PL_LEAF"},
    {feature::kVertexColor, "PL_VERTEX_COLOR"},
    {feature::kSkyReflection, "PL_SKY_REFLECTION"},
    {feature::kEmissiveMap, "PL_EMISSIVE_MAP"},
    {feature::kMetal, "PL_METAL"},
    {feature::kEmissive, "PL_EMISSIVE"},
    {feature::kPhong, "PL_PHONG"},
    {feature::kFlat, "PL_FLAT"},
    {feature::kFaceted, "PL_FACETED"},
    {feature::kSun, "PL_SUN"},
    {feature::kSunShadow, "PL_SUN_SHADOW"},
    {feature::kFlashlight, "PL_FLASHLIGHT"},
    {feature::kFlashlightAtEye, "PL_FLASHLIGHT_AT_EYE"},
    {feature::kLocalLights, "PL_LOCAL_LIGHTS"},
    {feature::kFog, "PL_FOG"},
    {feature::kSkyLight, "PL_SKY_LIGHT"},
    {feature::kSoftShadows, "PL_SOFT_SHADOWS"},
    {feature::kHardShadows, "PL_HARD_SHADOWS"},
    {feature::kCascades, "PL_CASCADES"},
    {feature::kToneMap, "PL_TONE_MAP"},
    {feature::kBloom, "PL_BLOOM"},
    {feature::kKeepDepth, "PL_KEEP_DEPTH"},
    {feature::kFxaa, "PL_FXAA"},
    {feature::kSharpen, "PL_SHARPEN"},
    {feature::kSkyCodes, "PL_SKY_CODES"},
    {feature::kFourSamples, "PL_FOUR_SAMPLES"},
    {feature::kRipples, "PL_RIPPLES"},
    {feature::kVariation, "PL_VARIATION"},
    {feature::kWind, "PL_WIND"},
    {feature::kClouds, "PL_CLOUDS"},
    {feature::kAerial, "PL_AERIAL"},
    {feature::kLightShadows, "PL_LIGHT_SHADOWS"},
    {feature::kContactHardening, "PL_CONTACT_HARDENING"},
    {feature::kParallax, "PL_PARALLAX"},
    {feature::kGlass, "PL_GLASS"},
    {feature::kRefraction, "PL_REFRACTION"},
    {feature::kCaustics, "PL_CAUSTICS"},
    {feature::kCodes, "PL_CODES"},
    {feature::kOcclusion, "PL_OCCLUSION"},
    {feature::kShafts, "PL_SHAFTS"},
    {feature::kMoved, "PL_MOVED"},
    {feature::kCoverage, "PL_COVERAGE"},
}};

}  // namespace plumbline::render
