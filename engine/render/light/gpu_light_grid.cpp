#include "engine/render/light/gpu_light_grid.h"

#include "engine/core/hash.h"
#include "engine/render/shader_blocks.h"

#include <cmath>

namespace plumbline::render {
namespace {

/// Light that changed by less needs no new grid: of the sky, and the cosine of the sun's angle.
constexpr float kSameLight = 0.02F;
constexpr float kSameSun = 0.9997F;  // 1.4 degrees
constexpr float kRest_s = 1.0F;      // between two lights of a running scene

bool stands_in(const DrawItem& item, const Aabb& box, const assets::AssetLibrary& library) {
    if (!item.is_static || item.mesh.value == 0) return false;
    const Aabb bounds = transformed(library.mesh(item.mesh).bounds, item.world_from_body);
    return glm::all(glm::lessThan(bounds.min, box.max)) &&
           glm::all(glm::greaterThan(bounds.max, box.min));
}

std::uint64_t content_of(const RenderFrame& frame,
                         const Aabb& box,
                         const assets::AssetLibrary& library) {
    Hasher hash;
    const auto add = [&hash](const auto& value) { hash.add(&value, sizeof(value)); };
    add(*frame.indirect);
    for (const DrawItem& item : frame.items) {
        if (!stands_in(item, box, library)) continue;
        add(item.mesh.value);
        add(item.world_from_body);
    }
    return hash.digest();
}

bool is_nearly(const OutsideLight& a, const OutsideLight& b) {
    const float size = glm::length(a.sky[0]) + glm::length(a.sun_radiance);
    float change = glm::length(a.sun_radiance - b.sun_radiance);
    for (std::size_t i = 0; i < a.sky.size(); ++i) change += glm::length(a.sky[i] - b.sky[i]);
    return change <= kSameLight * size && glm::dot(a.to_sun_world, b.to_sun_world) > kSameSun;
}

}  // namespace

OutsideLight outside_light(const FrameBlock& block) {
    OutsideLight outside{.sun_radiance = Vec3f{block.sun_radiance},
                         .to_sun_world = Vec3f{block.to_sun_world}};
    for (std::size_t i = 0; i < outside.sky.size(); ++i) outside.sky[i] = Vec3f{block.sky_light[i]};
    return outside;
}

void GpuLightGrid::want(const RenderFrame& frame,
                        const OutsideLight& outside,
                        assets::AssetLibrary& library) {
    if (!frame.indirect || !frame.sky) {
        *this = {};
        return;
    }
    const Vec3f margin{frame.indirect->spacing_m};
    const Aabb box{frame.indirect->min_world - margin, frame.indirect->max_world + margin};
    const std::uint64_t content = content_of(frame, box, library);
    const bool is_new = grid_ == nullptr || content != content_;
    const bool is_lit =
        is_nearly(outside, outside_) || std::abs(frame.time_s - lit_at_s_) < kRest_s;
    if (!is_new && is_lit) return;
    // Built again each time that the light has changed: that takes less than it would take memory.
    const RayScene rays(
        frame, library, [&](const DrawItem& item) { return stands_in(item, box, library); });
    if (is_new) grid_ = std::make_unique<LightGrid>(*frame.indirect, rays);
    content_ = content;
    grid_->light(outside, rays);
    outside_ = outside;
    lit_at_s_ = frame.time_s;
    means_ = gl::Texture::volume(grid_->counts(), grid_->means());
    slopes_ = gl::Texture::volume(grid_->counts(), grid_->slopes());
}

void GpuLightGrid::bind() const {
    gl::bind_texture(kGridMeansUnit, means_);
    gl::bind_texture(kGridSlopesUnit, slopes_);
}

}  // namespace plumbline::render
