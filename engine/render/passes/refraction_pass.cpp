#include "engine/render/passes/refraction_pass.h"

#include "engine/render/culling/convex_volume.h"
#include "engine/render/shader_blocks.h"

namespace plumbline::render {
namespace {

PixelPart pixels_of(const ClipRect& part, const Vec2f& size_px) {
    if (part.empty()) return {};
    const auto pixel_of = [&](const Vec2f& clip) {
        return glm::clamp(glm::floor((clip * 0.5F + 0.5F) * size_px), Vec2f{0.0F}, size_px - 1.0F);
    };
    return {.first = pixel_of(part.min), .last = pixel_of(part.max)};
}

}  // namespace

bool RefractionPass::copy(const SceneTarget& scene,
                          const Aabb& box_world,
                          const Mat4f& clip_from_world) {
    const PixelSize size_px{scene.color().width(), scene.color().height()};
    if (!behind_.resize(size_px, gl::TargetFormat::HdrColor, 1)) return false;
    part_ = pixels_of(part_seen(box_world, clip_from_world), {size_px.width, size_px.height});
    behind_.copy(scene, part_.first, part_.last);
    return true;
}

void RefractionPass::bind() const {
    gl::bind_texture(kSourceUnit, behind_.color());
    gl::bind_texture(kDepthUnit, behind_.depth());
}

}  // namespace plumbline::render
