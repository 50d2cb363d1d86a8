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

bool overlap(const Aabb& a, const Aabb& b) {
    return glm::all(glm::lessThan(a.min, b.max)) && glm::all(glm::greaterThan(a.max, b.min));
}

bool stands_in(const DrawItem& item, const Aabb& box, const assets::AssetLibrary& library) {
    if (!item.is_static || item.mesh.value == 0) return false;
    return overlap(transformed(library.mesh(item.mesh).bounds, item.world_from_body), box);
}

/// Whether one of its triangles comes near the box: the hills round a house do not.
bool has_triangle_in(const DrawItem& item, const Aabb& box, const assets::MeshData& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Aabb triangle;
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            const Vec3f& place = mesh.vertices[mesh.indices[corner]].position_body;
            triangle.include(Vec3f{item.world_from_body * Vec4f{place, 1.0F}});
        }
        if (overlap(triangle, box)) return true;
    }
    return false;
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

bool GpuLightGrid::may_light(assets::MeshId mesh, bool is_static, const Aabb& bounds_world) const {
    return ready() && (is_static ? inside_.contains(mesh.value) : overlap(bounds_world, rooms_));
}

void GpuLightGrid::find_inside(const RenderFrame& frame, const assets::AssetLibrary& library) {
    inside_.clear();
    for (const DrawItem& item : frame.items) {
        if (stands_in(item, rooms_, library) && !inside_.contains(item.mesh.value) &&
            has_triangle_in(item, rooms_, library.mesh(item.mesh)))
            inside_.insert(item.mesh.value);
    }
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
    if (is_new) {
        grid_ = std::make_unique<LightGrid>(*frame.indirect, rays);
        rooms_ = {frame.indirect->min_world, frame.indirect->max_world};
        find_inside(frame, library);
    }
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
