#include "engine/render/passes/refraction_pass.h"

#include "engine/render/shader_blocks.h"

#include <algorithm>

namespace plumbline::render {
namespace {

/// Where the picture shows the box: all of it when the box reaches behind the eye.
PixelPart part_showing(const Aabb& box, const Mat4f& clip_from_world, const Vec2f& size_px) {
    Vec2f low{1.0F};
    Vec2f high{-1.0F};
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3f at{(corner & 1) != 0 ? box.max.x : box.min.x,
                       (corner & 2) != 0 ? box.max.y : box.min.y,
                       (corner & 4) != 0 ? box.max.z : box.min.z};
        const Vec4f clip = clip_from_world * Vec4f{at, 1.0F};
        if (clip.w <= 1e-3F) return {.first = Vec2f{0.0F}, .last = size_px - 1.0F};
        low = glm::min(low, Vec2f{clip} / clip.w);
        high = glm::max(high, Vec2f{clip} / clip.w);
    }
    const auto pixel_of = [&](const Vec2f& clip) {
        return glm::clamp(glm::floor((clip * 0.5F + 0.5F) * size_px), Vec2f{0.0F}, size_px - 1.0F);
    };
    return {.first = pixel_of(low), .last = pixel_of(high)};
}

}  // namespace

bool RefractionPass::copy(const SceneTarget& scene,
                          const Aabb& box_world,
                          const Mat4f& clip_from_world) {
    const PixelSize size_px{scene.color().width(), scene.color().height()};
    if (!behind_.resize(size_px, gl::TargetFormat::HdrColor, 1)) return false;
    part_ = part_showing(box_world, clip_from_world, {size_px.width, size_px.height});
    behind_.copy(scene, part_.first, part_.last);
    return true;
}

void RefractionPass::bind() const {
    gl::bind_texture(kSourceUnit, gl::TextureKind::Flat, behind_.color());
    gl::bind_texture(kDepthUnit, gl::TextureKind::Flat, behind_.depth());
}

}  // namespace plumbline::render
