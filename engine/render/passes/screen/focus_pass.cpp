#include "engine/render/passes/screen/focus_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

// Of the image's height: more samples than there are would be seen one by one.
constexpr float kLargestRadius = 1.0F / 36.0F;

}  // namespace

const gl::Texture* FocusPass::render(const FrameSetup& setup,
                                     const SceneLight& light,
                                     const FullscreenTriangle& triangle,
                                     SceneResources& resources,
                                     FrameStats& stats) {
    const DepthOfField& lens = *setup.frame->depth_of_field;
    const ScreenView& view = setup.screen;
    const gl::Program* down = resources.shaders.find(kFocusDownShader, light.features);
    const gl::Program* gather = resources.shaders.find(kFocusGatherShader, 0);
    const gl::Program* join = resources.shaders.find(kFocusJoinShader, light.features);
    if (down == nullptr || gather == nullptr || join == nullptr) return nullptr;
    const PixelSize full_px{light.image->width(), light.image->height()};
    const PixelSize half_px{(full_px.width + 1) / 2, (full_px.height + 1) / 2};
    if (!half_.resize(gl::TargetFormat::HdrColor, half_px) ||
        !blurred_.resize(gl::TargetFormat::HdrColor, half_px) ||
        !joined_.resize(gl::TargetFormat::HdrColor, full_px)) {
        free();
        return nullptr;
    }
    // The disc of a point at distance z has the radius aperture / 2 * pixels_at_1m * |1/focus - 1/z|.
    const float by_distance = 0.5F * lens.aperture_m * view.pixels_at_1m;
    const float far_px = by_distance / lens.focus_m;
    const float largest_px = kLargestRadius * static_cast<float>(full_px.height);
    const auto set_lens = [&](const gl::Program& program) {
        glUniform2f(program.location("depth_line"), view.depth_line.x, view.depth_line.y);
        glUniform4f(program.location("lens"), far_px, by_distance, largest_px, 0.0F);
        bind_scene_light(light, program);
        gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, *light.image);
        gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, *light.depth);
    };
    half_.bind();
    down->use();
    set_lens(*down);
    triangle.draw();
    blurred_.bind();
    gather->use();
    gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, half_.image);
    glUniform2f(gather->location("disc"), 0.5F * largest_px, static_cast<float>(lens.samples));
    triangle.draw();
    joined_.bind();
    join->use();
    set_lens(*join);
    gl::bind_texture(kBlurredUnit, gl::TextureKind::Flat, blurred_.image);
    triangle.draw();
    stats.draw_calls += 3;
    return &joined_.image;
}

}  // namespace plumbline::render
