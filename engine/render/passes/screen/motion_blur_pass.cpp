#include "engine/render/passes/screen/motion_blur_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

namespace plumbline::render {
namespace {

// Of the image's width: a streak's samples must stay close.
constexpr float kLongestStreak = 1.0F / 12.0F;

/// Where the camera was as the shutter opened.
Mat4f clip_before_from_world(const FrameSetup& setup) {
    const Camera& camera = setup.frame->camera;
    const MotionBlur& blur = *setup.frame->motion_blur;
    const float aspect = setup.screen.tan_half.x / setup.screen.tan_half.y;
    return glm::perspective(camera.fov_y_rad, aspect, camera.near_m, camera.far_m) *
           glm::translate(glm::mat4_cast(glm::conjugate(blur.orientation_before)),
                          -blur.position_before_world);
}

}  // namespace

const gl::Texture* MotionBlurPass::render(const FrameSetup& setup,
                                          const SceneLight& light,
                                          const FullscreenTriangle& triangle,
                                          SceneResources& resources,
                                          FrameStats& stats) {
    const MotionBlur& blur = *setup.frame->motion_blur;
    const ShutterView view{.clip_from_world = setup.block.clip_from_world,
                           .clip_before_from_world = clip_before_from_world(setup)};
    const gl::Texture* ways = motion_vectors_.render(blur, view, *light.depth, resources, stats);
    const FeatureSet features = light.features | (ways != nullptr ? screen_feature::kMoved : 0);
    const gl::Program* program = resources.shaders.find(kMotionBlurShader, features);
    if (program == nullptr) return nullptr;
    const PixelSize size_px{light.image->width(), light.image->height()};
    if (!blurred_.resize(gl::TargetFormat::HdrColor, size_px)) {
        free();
        return nullptr;
    }
    blurred_.bind();
    program->use();
    bind_scene_light(light, *program);
    gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, *light.image);
    gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, *light.depth);
    if (ways != nullptr) gl::bind_texture(kBlurredUnit, gl::TextureKind::Flat, *ways);
    glUniform2f(program->location("depth_line"), light.depth_line.x, light.depth_line.y);
    glUniformMatrix4fv(program->location("clip_before_from_world"),
                       1,
                       GL_FALSE,
                       glm::value_ptr(view.clip_before_from_world));
    glUniform2f(program->location("streak"),
                kLongestStreak * static_cast<float>(size_px.width),
                static_cast<float>(blur.samples));
    triangle.draw();
    ++stats.draw_calls;
    return &blurred_.image;
}

}  // namespace plumbline::render
