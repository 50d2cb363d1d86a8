// The light of the scene on its way to the screen.
#pragma once

#include "engine/core/math.h"
#include "engine/render/gl/program.h"
#include "engine/render/gl/texture.h"
#include "engine/render/shaders/shader_features.h"

namespace plumbline::render {

/// What passes over the whole image know of the camera.
struct ScreenView {
    Vec2f tan_half{1.0F};          ///< of half the angles of view
    Vec2f depth_line{1.0F, 0.0F};  ///< 1 / metres along the line of sight = x + y * depth
    float pixels_at_1m{1.0F};      ///< of the scene's image, that 1 m takes
};

/// An image of light, and what the first pass that reads it has to add: shaders/include/scene_light.glsl.
struct SceneLight {
    const gl::Texture* image{nullptr};
    FeatureSet features{0};  ///< kOcclusion, kShafts
    const gl::Texture* depth{nullptr};
    const gl::Texture* occlusion{nullptr};
    const gl::Texture* shafts{nullptr};
    Vec2f depth_line{1.0F, 0.0F};
};

/// Binds the images that those features read, and sets their uniforms; `program` is in use.
void bind_scene_light(const SceneLight& light, const gl::Program& program);

}  // namespace plumbline::render
