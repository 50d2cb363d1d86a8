// The features of the mesh shader. A variant has the features of one material, those of the frame and
// those that one draw asks for. A bit costs a program for each combination in which it comes up, so a
// feature is a bit only where a branch in the shader would cost more: software GL runs both sides of it.
#pragma once

#include "engine/render/shaders/feature_set.h"

#include <array>

namespace plumbline::render {

namespace mesh_feature {
// The material's.
inline constexpr Feature kBlinnPhong{0, "PL_BLINN_PHONG"};
inline constexpr Feature kPhong{1, "PL_PHONG"};  ///< with kBlinnPhong: the textbook's highlight
inline constexpr Feature kUnlit{2, "PL_UNLIT"};
inline constexpr Feature kBaseMap{3, "PL_BASE_MAP"};
inline constexpr Feature kNormalMap{4, "PL_NORMAL_MAP"};
inline constexpr Feature kOrmMap{5, "PL_ORM_MAP"};
inline constexpr Feature kEmissive{6, "PL_EMISSIVE"};
inline constexpr Feature kEmissiveMap{7, "PL_EMISSIVE_MAP"};
inline constexpr Feature kAlphaMask{8, "PL_ALPHA_MASK"};
inline constexpr Feature kBlend{9, "PL_BLEND"};
inline constexpr Feature kTwoSided{10, "PL_TWO_SIDED"};
inline constexpr Feature kLeaf{11, "PL_LEAF"};
inline constexpr Feature kVertexColor{12, "PL_VERTEX_COLOR"};
inline constexpr Feature kMetal{13, "PL_METAL"};  ///< the material is metallic in part at least
inline constexpr Feature kFlat{14, "PL_FLAT"};    ///< normals are not blended across triangles
inline constexpr Feature kSkyReflection{15, "PL_SKY_REFLECTION"};
inline constexpr Feature kVariation{16, "PL_VARIATION"};  ///< the base colour varies over metres
inline constexpr Feature kParallax{17, "PL_PARALLAX"};    ///< with kNormalMap: a height map
inline constexpr Feature kRipples{18, "PL_RIPPLES"};      ///< water with moving normals
/// With kBlend: glass that mirrors, and shows what is behind it.
inline constexpr Feature kGlass{19, "PL_GLASS"};
/// With kRipples: the light behind the water is shown refracted, with caustics.
inline constexpr Feature kRefraction{20, "PL_REFRACTION"};
// The mesh's.
/// Few triangles of one normal and one colour.
inline constexpr Feature kFaceted{21, "PL_FACETED"};
inline constexpr Feature kSways{22, "PL_SWAYS"};  ///< the wind bends it
// The frame's.
inline constexpr Feature kSun{23, "PL_SUN"};
inline constexpr Feature kSunShadow{24, "PL_SUN_SHADOW"};
inline constexpr Feature kCascades{25, "PL_CASCADES"};  ///< with kSunShadow: more than one
inline constexpr Feature kContactHardening{26, "PL_CONTACT_HARDENING"};  ///< with kSunShadow
/// Four taps: where lookups are cheap.
inline constexpr Feature kSoftShadows{27, "PL_SOFT_SHADOWS"};
inline constexpr Feature kHardShadows{28, "PL_HARD_SHADOWS"};  ///< one tap
inline constexpr Feature kFlashlight{29, "PL_FLASHLIGHT"};
/// With kFlashlight: its shadows fall where the eye does not see them, so there are none.
inline constexpr Feature kFlashlightAtEye{30, "PL_FLASHLIGHT_AT_EYE"};
inline constexpr Feature kLocalLights{31, "PL_LOCAL_LIGHTS"};
inline constexpr Feature kLightShadows{32, "PL_LIGHT_SHADOWS"};  ///< with kLocalLights
inline constexpr Feature kSkyLight{33, "PL_SKY_LIGHT"};
inline constexpr Feature kAerial{34, "PL_AERIAL"};  ///< air hides far things
/// Alpha says what ambient occlusion may take.
inline constexpr Feature kOcclusion{35, "PL_OCCLUSION"};
inline constexpr Feature kCoverage{36, "PL_COVERAGE"};  ///< masks cover samples, not whole pixels
inline constexpr Feature kCodes{37, "PL_CODES"};        ///< the target holds sRGB codes
inline constexpr Feature kIndirect{38, "PL_INDIRECT"};  ///< with kSkyLight: some of it is indoors

inline constexpr std::array kAll{kBlinnPhong,      kPhong,       kUnlit,
                                 kBaseMap,         kNormalMap,   kOrmMap,
                                 kEmissive,        kEmissiveMap, kAlphaMask,
                                 kBlend,           kTwoSided,    kLeaf,
                                 kVertexColor,     kMetal,       kFlat,
                                 kSkyReflection,   kVariation,   kParallax,
                                 kRipples,         kGlass,       kRefraction,
                                 kFaceted,         kSways,       kSun,
                                 kSunShadow,       kCascades,    kContactHardening,
                                 kSoftShadows,     kHardShadows, kFlashlight,
                                 kFlashlightAtEye, kLocalLights, kLightShadows,
                                 kSkyLight,        kAerial,      kOcclusion,
                                 kCoverage,        kCodes,       kIndirect};
}  // namespace mesh_feature

/// What a thing is drawn without where the flashlight cannot reach it.
inline constexpr FeatureSet kFlashlightFeatures =
    mesh_feature::kFlashlight | mesh_feature::kFlashlightAtEye;

}  // namespace plumbline::render
