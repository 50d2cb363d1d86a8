#include "engine/render/passes/screen/occlusion_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {
namespace {

// Of the image's height: near things would look up half of it.
constexpr float kMostReach = 0.12F;

}  // namespace

const gl::Texture* OcclusionPass::render(const FrameSetup& setup,
                                         const gl::Texture& depth,
                                         const FullscreenTriangle& triangle,
                                         SceneResources& resources,
                                         FrameStats& stats) {
    const AmbientOcclusion& occlusion = *setup.frame->occlusion;
    const ScreenView& view = setup.screen;
    const gl::Program* find = resources.shaders.find(kOcclusionShader, 0);
    if (find == nullptr) return nullptr;
    const PixelSize half_px{(depth.width() + 1) / 2, (depth.height() + 1) / 2};
    if (!images_.resize(half_px)) return nullptr;
    images_.found.bind();
    find->use();
    gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, depth);
    glUniform2f(find->location("depth_line"), view.depth_line.x, view.depth_line.y);
    glUniform2f(find->location("tan_half"), view.tan_half.x, view.tan_half.y);
    glUniform4f(find->location("reach"),
                occlusion.radius_m,
                occlusion.radius_m * view.pixels_at_1m,
                kMostReach * static_cast<float>(depth.height()),
                occlusion.strength);
    glUniform2i(find->location("counts"),
                static_cast<GLint>(occlusion.slices),
                static_cast<GLint>(occlusion.steps));
    triangle.draw();
    ++stats.draw_calls;
    blur_pairs(images_, triangle, resources, stats);
    return &images_.found.image;
}

}  // namespace plumbline::render
