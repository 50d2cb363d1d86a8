// The features of the mesh shader. A variant has the features of one material, those of the frame and
// those that one draw asks for. A bit costs a program for each combination in which it comes up, so a
// feature is a bit only where a branch in the shader would cost more: software GL runs both sides of it.
#pragma once

#include "engine/render/shaders/feature_set.h"

#include <array>

namespace plumbline::render {

namespace mesh_feature {
// The material's.
inline constexpr FeatureSet kBlinnPhong = 1ULL << 0U;
inline constexpr FeatureSet kPhong = 1ULL << 1U;  ///< with kBlinnPhong: the textbook's highlight
inline constexpr FeatureSet kUnlit = 1ULL << 2U;
inline constexpr FeatureSet kBaseMap = 1ULL << 3U;
inline constexpr FeatureSet kNormalMap = 1ULL << 4U;
inline constexpr FeatureSet kOrmMap = 1ULL << 5U;
inline constexpr FeatureSet kEmissive = 1ULL << 6U;
inline constexpr FeatureSet kEmissiveMap = 1ULL << 7U;
inline constexpr FeatureSet kAlphaMask = 1ULL << 8U;
inline constexpr FeatureSet kBlend = 1ULL << 9U;
inline constexpr FeatureSet kTwoSided = 1ULL << 10U;
inline constexpr FeatureSet kLeaf = 1ULL << 11U;
inline constexpr FeatureSet kVertexColor = 1ULL << 12U;
inline constexpr FeatureSet kMetal = 1ULL << 13U;  ///< the material is metallic in part at least
inline constexpr FeatureSet kFlat = 1ULL << 14U;   ///< normals are not blended across triangles
inline constexpr FeatureSet kSkyReflection = 1ULL << 15U;
inline constexpr FeatureSet kVariation = 1ULL << 16U;  ///< the base colour varies over metres
inline constexpr FeatureSet kParallax = 1ULL << 17U;   ///< with kNormalMap: a height map
inline constexpr FeatureSet kRipples = 1ULL << 18U;    ///< water with moving normals
/// With kBlend: glass that mirrors, and shows what is behind it.
inline constexpr FeatureSet kGlass = 1ULL << 19U;
/// With kRipples: the light behind the water is shown refracted, with caustics.
inline constexpr FeatureSet kRefraction = 1ULL << 20U;
// The mesh's.
inline constexpr FeatureSet kFaceted = 1ULL << 21U;  ///< few triangles of one normal and one colour
inline constexpr FeatureSet kSways = 1ULL << 22U;    ///< the wind bends it
// The frame's.
inline constexpr FeatureSet kSun = 1ULL << 23U;
inline constexpr FeatureSet kSunShadow = 1ULL << 24U;
inline constexpr FeatureSet kCascades = 1ULL << 25U;          ///< with kSunShadow: more than one
inline constexpr FeatureSet kContactHardening = 1ULL << 26U;  ///< with kSunShadow
inline constexpr FeatureSet kSoftShadows = 1ULL << 27U;  ///< four taps: where lookups are cheap
inline constexpr FeatureSet kHardShadows = 1ULL << 28U;  ///< one tap
inline constexpr FeatureSet kFlashlight = 1ULL << 29U;
/// With kFlashlight: its shadows fall where the eye does not see them, so there are none.
inline constexpr FeatureSet kFlashlightAtEye = 1ULL << 30U;
inline constexpr FeatureSet kLocalLights = 1ULL << 31U;
inline constexpr FeatureSet kLightShadows = 1ULL << 32U;  ///< with kLocalLights
inline constexpr FeatureSet kSkyLight = 1ULL << 33U;
inline constexpr FeatureSet kAerial = 1ULL << 34U;  ///< air hides far things
inline constexpr FeatureSet kOcclusion = 1ULL
                                         << 35U;  ///< alpha says what ambient occlusion may take
inline constexpr FeatureSet kCoverage = 1ULL << 36U;  ///< masks cover samples, not whole pixels
inline constexpr FeatureSet kCodes = 1ULL << 37U;     ///< the target holds sRGB codes
inline constexpr FeatureSet kIndirect = 1ULL << 38U;  ///< with kSkyLight: some of it is indoors
}  // namespace mesh_feature

/// What a thing is drawn without where the flashlight cannot reach it.
inline constexpr FeatureSet kFlashlightFeatures =
    mesh_feature::kFlashlight | mesh_feature::kFlashlightAtEye;

inline constexpr std::array kMeshFeatures{
    Feature{mesh_feature::kBlinnPhong, "PL_BLINN_PHONG"},
    Feature{mesh_feature::kPhong, "PL_PHONG"},
    Feature{mesh_feature::kUnlit, "PL_UNLIT"},
    Feature{mesh_feature::kBaseMap, "PL_BASE_MAP"},
    Feature{mesh_feature::kNormalMap, "PL_NORMAL_MAP"},
    Feature{mesh_feature::kOrmMap, "PL_ORM_MAP"},
    Feature{mesh_feature::kEmissive, "PL_EMISSIVE"},
    Feature{mesh_feature::kEmissiveMap, "PL_EMISSIVE_MAP"},
    Feature{mesh_feature::kAlphaMask, "PL_ALPHA_MASK"},
    Feature{mesh_feature::kBlend, "PL_BLEND"},
    Feature{mesh_feature::kTwoSided, "PL_TWO_SIDED"},
    Feature{mesh_feature::kLeaf, "PL_LEAF"},
    Feature{mesh_feature::kVertexColor, "PL_VERTEX_COLOR"},
    Feature{mesh_feature::kMetal, "PL_METAL"},
    Feature{mesh_feature::kFlat, "PL_FLAT"},
    Feature{mesh_feature::kSkyReflection, "PL_SKY_REFLECTION"},
    Feature{mesh_feature::kVariation, "PL_VARIATION"},
    Feature{mesh_feature::kParallax, "PL_PARALLAX"},
    Feature{mesh_feature::kRipples, "PL_RIPPLES"},
    Feature{mesh_feature::kGlass, "PL_GLASS"},
    Feature{mesh_feature::kRefraction, "PL_REFRACTION"},
    Feature{mesh_feature::kFaceted, "PL_FACETED"},
    Feature{mesh_feature::kSways, "PL_SWAYS"},
    Feature{mesh_feature::kSun, "PL_SUN"},
    Feature{mesh_feature::kSunShadow, "PL_SUN_SHADOW"},
    Feature{mesh_feature::kCascades, "PL_CASCADES"},
    Feature{mesh_feature::kContactHardening, "PL_CONTACT_HARDENING"},
    Feature{mesh_feature::kSoftShadows, "PL_SOFT_SHADOWS"},
    Feature{mesh_feature::kHardShadows, "PL_HARD_SHADOWS"},
    Feature{mesh_feature::kFlashlight, "PL_FLASHLIGHT"},
    Feature{mesh_feature::kFlashlightAtEye, "PL_FLASHLIGHT_AT_EYE"},
    Feature{mesh_feature::kLocalLights, "PL_LOCAL_LIGHTS"},
    Feature{mesh_feature::kLightShadows, "PL_LIGHT_SHADOWS"},
    Feature{mesh_feature::kSkyLight, "PL_SKY_LIGHT"},
    Feature{mesh_feature::kAerial, "PL_AERIAL"},
    Feature{mesh_feature::kOcclusion, "PL_OCCLUSION"},
    Feature{mesh_feature::kCoverage, "PL_COVERAGE"},
    Feature{mesh_feature::kCodes, "PL_CODES"},
    Feature{mesh_feature::kIndirect, "PL_INDIRECT"},
};

}  // namespace plumbline::render
