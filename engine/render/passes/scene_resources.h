// What the passes of a scene draw with. Owned by the renderer.
#pragma once

#include "engine/render/frame_stats.h"
#include "engine/render/light/gpu_light_grid.h"
#include "engine/render/passes/scene_light.h"
#include "engine/render/resources/gpu_materials.h"
#include "engine/render/resources/gpu_meshes.h"
#include "engine/render/resources/gpu_textures.h"
#include "engine/render/shaders/mesh_features.h"
#include "engine/render/shaders/shader_library.h"
#include "engine/render/sky/gpu_sky.h"

#include <array>
#include <set>

namespace plumbline::render {

struct SceneResources {
    SceneResources(const std::filesystem::path& shader_folder,
                   assets::AssetLibrary& asset_library,
                   std::uint32_t largest_texture_px)
        : library(asset_library),
          shaders(shader_folder),
          meshes(asset_library),
          textures(asset_library, largest_texture_px),
          materials(asset_library, textures),
          sky(asset_library, largest_texture_px) {}

    assets::AssetLibrary& library;
    ShaderLibrary shaders;
    GpuMeshes meshes;
    GpuTextures textures;
    GpuMaterials materials;
    GpuSky sky;
    GpuLightGrid light_grid{};
    /// Looks (material features) that some mesh has which is not faceted: faceted ones share its shader.
    std::set<FeatureSet> smooth_looks;
};

/// Of the shader of shadow maps.
namespace depth_feature {
inline constexpr Feature kAlphaMask{0, "PL_ALPHA_MASK"};

inline constexpr std::array kAll{kAlphaMask};
}  // namespace depth_feature
/// Of the sky's shaders.
namespace sky_feature {
inline constexpr Feature kClouds{0, "PL_CLOUDS"};       ///< before a computed sky
inline constexpr Feature kSkyCodes{1, "PL_SKY_CODES"};  ///< the sky's faces hold sRGB codes
inline constexpr Feature kCodes{2, "PL_CODES"};         ///< the target holds sRGB codes

inline constexpr std::array kAll{kClouds, kSkyCodes, kCodes};
}  // namespace sky_feature
/// Of the shader of sun shafts.
namespace shaft_feature {
inline constexpr Feature kSunShadow{0, "PL_SUN_SHADOW"};
inline constexpr Feature kCascades{1, "PL_CASCADES"};

inline constexpr std::array kAll{kSunShadow, kCascades};
}  // namespace shaft_feature
inline constexpr ShaderPair kMeshShader{"mesh.vert", "mesh.frag", mesh_feature::kAll};
inline constexpr ShaderPair kDepthShader{"depth.vert", "depth.frag", depth_feature::kAll};
inline constexpr ShaderPair kSkyShader{"fullscreen.vert", "sky.frag", sky_feature::kAll};
inline constexpr ShaderPair kSkyDomeShader{"sky_dome.vert", "sky_dome.frag", sky_feature::kAll};
inline constexpr ShaderPair kSkyPointShader{"sky_point.vert", "sky_point.frag", sky_feature::kAll};
inline constexpr ShaderPair kFogShader{"fullscreen.vert", "fog.frag"};
inline constexpr ShaderPair kExposureShader{"fullscreen.vert", "exposure.frag"};
inline constexpr ShaderPair kOcclusionShader{"fullscreen.vert", "occlusion.frag"};
inline constexpr ShaderPair kPairBlurShader{"fullscreen.vert", "pair_blur.frag"};
inline constexpr ShaderPair kShaftsShader{"fullscreen.vert", "shafts.frag", shaft_feature::kAll};
inline constexpr ShaderPair kFocusDownShader{
    "fullscreen.vert", "focus_down.frag", screen_feature::kAll};
inline constexpr ShaderPair kFocusGatherShader{"fullscreen.vert", "focus_gather.frag"};
inline constexpr ShaderPair kFocusJoinShader{
    "fullscreen.vert", "focus_join.frag", screen_feature::kAll};
inline constexpr ShaderPair kMotionBlurShader{
    "fullscreen.vert", "motion_blur.frag", screen_feature::kAll};
inline constexpr ShaderPair kVelocityShader{"velocity.vert", "velocity.frag"};
inline constexpr ShaderPair kToneMapShader{
    "fullscreen.vert", "tone_map.frag", screen_feature::kAll};
inline constexpr ShaderPair kBloomDownShader{"fullscreen.vert", "bloom_down.frag"};
inline constexpr ShaderPair kBloomUpShader{"fullscreen.vert", "bloom_up.frag"};
inline constexpr ShaderPair kSmoothEdgesShader{
    "fullscreen.vert", "smooth_edges.frag", screen_feature::kAll};
inline constexpr ShaderPair kScaleUpShader{
    "fullscreen.vert", "scale_up.frag", screen_feature::kAll};
inline constexpr ShaderPair kLineShader{"line.vert", "line.frag"};
inline constexpr ShaderPair kDropShader{"drop.vert", "drop.frag"};
/// All there are: a missing file is found at the start, not when its effect first runs.
inline constexpr std::array kShaderPairs{
    kMeshShader,        kDepthShader,     kSkyShader,         kSkyDomeShader,  kSkyPointShader,
    kExposureShader,    kOcclusionShader, kPairBlurShader,    kShaftsShader,   kFocusDownShader,
    kFocusGatherShader, kFocusJoinShader, kMotionBlurShader,  kVelocityShader, kToneMapShader,
    kBloomDownShader,   kBloomUpShader,   kSmoothEdgesShader, kScaleUpShader,  kLineShader,
    kDropShader,        kFogShader};

/// Adds a draw to the statistics.
inline void count_draw(FrameStats& stats, const DrawRun& run) {
    ++stats.draw_calls;
    stats.instances += run.instance_count;
    stats.triangles += std::uint64_t{run.index_count} / 3 * run.instance_count;
}

}  // namespace plumbline::render
