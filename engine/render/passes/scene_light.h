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
inline constexpr Feature kOcclusion{0, "PL_OCCLUSION"};  ///< less ambient light in corners
inline constexpr Feature kShafts{1, "PL_SHAFTS"};        ///< light from air in the sun
inline constexpr Feature kMoved{2, "PL_MOVED"};  ///< things moved while the shutter was open
inline constexpr Feature kBloom{3, "PL_BLOOM"};
inline constexpr Feature kToneMap{4, "PL_TONE_MAP"};          ///< exposure and tone curve
inline constexpr Feature kFourSamples{5, "PL_FOUR_SAMPLES"};  ///< two by two make a pixel
inline constexpr Feature kFxaa{6, "PL_FXAA"};
inline constexpr Feature kSharpen{7, "PL_SHARPEN"};
inline constexpr Feature kKeepDepth{8, "PL_KEEP_DEPTH"};  ///< lines will be drawn over the image

inline constexpr std::array kAll{
    kOcclusion, kShafts, kMoved, kBloom, kToneMap, kFourSamples, kFxaa, kSharpen, kKeepDepth};
}  // namespace screen_feature

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
