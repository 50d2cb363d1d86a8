#include "engine/render/passes/light_shadow_pass.h"

#include <algorithm>

namespace plumbline::render {
namespace {

// Casters of a lamp's shadow may be coarser by so much: a texel's width at two metres.
constexpr float kCasterError_m = 0.008F;

/// Things that cast shadows and lie near any of the lights.
std::vector<VisibleItem> casters_near(std::span<const ShadowedLight> chosen,
                                      float error_m,
                                      const RenderFrame& frame,
                                      const SceneResources& resources) {
    Aabb reach;
    for (const ShadowedLight& one : chosen) {
        const LocalLight& light = frame.lights[one.light];
        reach.include(
            Aabb{light.position_world - light.radius_m, light.position_world + light.radius_m});
    }
    const Vec3f half = reach.size() * 0.5F;
    const Mat4f clip_from_world =
        glm::translate(glm::scale(Mat4f{1.0F}, 1.0F / half), -reach.center());
    return casters_in(
        Frustum{clip_from_world}, frame.camera.position_world, error_m, frame, resources);
}

bool reaches(const LocalLight& light, const Aabb& box_world) {
    const Vec3f nearest = glm::clamp(light.position_world, box_world.min, box_world.max);
    return glm::distance(nearest, light.position_world) < light.radius_m;
}

}  // namespace

void LightShadowPass::render(const FrameSetup& setup, PassContext context) {
    const RenderFrame& frame = *setup.frame;
    const std::vector<ShadowedLight>& chosen = setup.lamps.choice.chosen();
    const std::uint32_t size_px = setup.lamps.shadow_px;
    const float error_m = setup.image.quality.lod_error_px > 0.0F ? kCasterError_m : 0.0F;
    for (const ShadowedLight& one : chosen) rows_ = std::max(rows_, one.row + 1);
    maps_.resize(size_px, kLightFaces, rows_);
    const std::vector<VisibleItem> near = casters_near(chosen, error_m, frame, context.resources);
    for (const ShadowedLight& one : chosen) {
        const LocalLight& light = frame.lights[one.light];
        std::vector<VisibleItem> lit;
        std::ranges::copy_if(near, std::back_inserter(lit), [&](const VisibleItem& caster) {
            return reaches(light, caster.bounds_world);
        });
        for (std::uint32_t face = 0; face < kLightFaces; ++face) {
            if (!shines_into(light, face)) continue;
            const ShadowView view{.clip_from_world = clip_from_world(light, face, size_px),
                                  .eye_world = light.position_world,
                                  .size_px = size_px,
                                  .from_lamp = true,
                                  .moves = one.moved};
            const Frustum sight{view.clip_from_world};
            std::vector<VisibleItem> casters;
            std::ranges::copy_if(lit, std::back_inserter(casters), [&](const VisibleItem& caster) {
                return sight.may_touch(caster.bounds_world);
            });
            maps_.show(one.row * kLightFaces + face, view, nullptr, std::move(casters), context);
        }
    }
}

void LightShadowPass::free() {
    maps_.free();
    rows_ = 0;
}

}  // namespace plumbline::render
