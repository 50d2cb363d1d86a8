#include "engine/render/passes/screen/shaft_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

namespace plumbline::render {
const gl::Texture* ShaftPass::render(const FrameSetup& setup,
                                     const gl::Texture& depth,
                                     const gl::Texture* sun_shadow_map,
                                     const FullscreenTriangle& triangle,
                                     SceneResources& resources,
                                     FrameStats& stats) {
    const SunShafts& shafts = *setup.frame->shafts;
    const ScreenView& view = setup.screen;
    FeatureSet features = 0;
    if (sun_shadow_map != nullptr) features |= shaft_feature::kSunShadow;
    if (sun_shadow_map != nullptr && setup.sun.shadow_views.size() > 1)
        features |= shaft_feature::kCascades;
    const gl::Program* find = resources.shaders.find(kShaftsShader, features);
    if (find == nullptr) return nullptr;
    const PixelSize quarter_px{(depth.width() + 3) / 4, (depth.height() + 3) / 4};
    if (!images_.resize(quarter_px)) return nullptr;
    find->use();
    images_.found.bind();
    gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, depth);
    if (sun_shadow_map != nullptr)
        gl::bind_texture(kSunShadowUnit, gl::TextureKind::Flat, *sun_shadow_map);
    glUniform2f(find->location("depth_line"), view.depth_line.x, view.depth_line.y);
    glUniform3f(find->location("air"),
                shafts.density_per_m,
                shafts.distance_m,
                static_cast<float>(shafts.steps));
    triangle.draw();
    ++stats.draw_calls;
    blur_pairs(images_, triangle, resources, stats);
    return &images_.found.image;
}

}  // namespace plumbline::render
