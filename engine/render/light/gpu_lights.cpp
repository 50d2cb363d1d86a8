#include "engine/render/light/gpu_lights.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {

void GpuLights::upload(std::span<const LocalLight> lights,
                       std::span<const Vec4f> shadows,
                       const ClusterView& view) {
    if (!masks_texture_) {
        lights_ = gl::Buffer{gl::BufferUse::Uniforms, gl::BufferLife::PerFrame};
        masks_ = gl::Buffer{gl::BufferUse::Vertices, gl::BufferLife::PerFrame};
        masks_texture_ = gl::new_texture();
    }
    LocalLightsBlock block;
    for (std::size_t i = 0; i < std::min(lights.size(), kMaxLights); ++i) {
        const LocalLight& light = lights[i];
        const float width = std::max(light.inner_cos - light.outer_cos, 1e-3F);
        block.lights[i] = {
            .position_world = Vec4f{light.position_world, 1.0F / std::max(light.radius_m, 1e-3F)},
            .intensity = Vec4f{light.intensity * glm::one_over_pi<float>(),
                               light.is_spot ? light.outer_cos : -2.0F},
            .direction_world = Vec4f{light.direction_world, 1.0F / width},
            .shadow = i < shadows.size() ? shadows[i] : Vec4f{0.0F}};
    }
    lights_.upload(&block, sizeof(block));
    gl::bind_uniforms(kLocalLightsBinding, lights_, 0, sizeof(block));
    const std::vector<std::uint32_t> masks = light_clusters(view, lights);
    masks_.upload(masks.data(), masks.size() * sizeof(std::uint32_t));
    glActiveTexture(GL_TEXTURE0 + kLightMasksUnit);
    glBindTexture(GL_TEXTURE_BUFFER, masks_texture_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, masks_.name());
}

void GpuLights::free() {
    *this = {};
}

}  // namespace plumbline::render
