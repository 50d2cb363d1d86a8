// The light of the scene on its way to the screen.
#pragma once

#include "engine/core/math.h"
#include "engine/render/gl/program.h"
#include "engine/render/gl/texture.h"
#include "engine/render/shaders/feature_set.h"

#include <array>

namespace plumbline::render {

/// Of the shaders that read the scene's light or encode it.
namespace screen_feature {
inline constexpr FeatureSet kOcclusion = 1ULL << 0U;  ///< less ambient light in corners
inline constexpr FeatureSet kShafts = 1ULL << 1U;     ///< light from air in the sun
inline constexpr FeatureSet kMoved = 1ULL << 2U;      ///< things moved while the shutter was open
inline constexpr FeatureSet kBloom = 1ULL << 3U;
inline constexpr FeatureSet kToneMap = 1ULL << 4U;      ///< exposure and tone curve
inline constexpr FeatureSet kFourSamples = 1ULL << 5U;  ///< two by two make a pixel
inline constexpr FeatureSet kFxaa = 1ULL << 6U;
inline constexpr FeatureSet kSharpen = 1ULL << 7U;
inline constexpr FeatureSet kKeepDepth = 1ULL << 8U;  ///< lines will be drawn over the image
}  // namespace screen_feature

inline constexpr std::array kScreenFeatures{
    Feature{screen_feature::kOcclusion, "PL_OCCLUSION"},
    Feature{screen_feature::kShafts, "PL_SHAFTS"},
    Feature{screen_feature::kMoved, "PL_MOVED"},
    Feature{screen_feature::kBloom, "PL_BLOOM"},
    Feature{screen_feature::kToneMap, "PL_TONE_MAP"},
    Feature{screen_feature::kFourSamples, "PL_FOUR_SAMPLES"},
    Feature{screen_feature::kFxaa, "PL_FXAA"},
    Feature{screen_feature::kSharpen, "PL_SHARPEN"},
    Feature{screen_feature::kKeepDepth, "PL_KEEP_DEPTH"},
};

/// An image of light, and what the first pass that reads it has to add: shaders/include/scene_light.glsl.
struct SceneLight {
    const gl::Texture* image{nullptr};
    FeatureSet features{0};  ///< screen_feature::kOcclusion, kShafts
    const gl::Texture* depth{nullptr};
    const gl::Texture* occlusion{nullptr};
    const gl::Texture* shafts{nullptr};
    Vec2f depth_line{1.0F, 0.0F};
};

/// Binds the images that those features read, and sets their uniforms; `program` is in use.
void bind_scene_light(const SceneLight& light, const gl::Program& program);

}  // namespace plumbline::render
