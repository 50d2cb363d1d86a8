#include "engine/render/passes/mesh_pass.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

constexpr FeatureSet kLightFeatures =
    feature::kSun | feature::kSunShadow | feature::kFlashlight | feature::kLocalLights |
    feature::kSkyLight | feature::kSoftShadows | feature::kHardShadows | feature::kCascades;

float distance_to(const Aabb& box, const Vec3f& point) {
    return glm::distance(point, glm::clamp(point, box.min, box.max));
}

bool is_reached(const Aabb& box, const std::vector<LocalLight>& lights) {
    return std::ranges::any_of(lights, [&](const LocalLight& light) {
        return distance_to(box, light.position_world) < light.radius_m;
    });
}

}  // namespace

FeatureSet variant_of(FeatureSet material_features, FeatureSet frame_features) {
    if ((material_features & feature::kUnlit) != 0) frame_features &= ~kLightFeatures;
    if ((frame_features & feature::kSkyLight) == 0) material_features &= ~feature::kSkyReflection;
    return material_features | frame_features;
}

void MeshPass::render(const DrawList& draws,
                      FeatureSet frame_features,
                      const std::vector<LocalLight>& lights,
                      SceneResources& resources,
                      FrameStats& stats) {
    if (draws.runs.empty()) return;
    instances_.upload(draws.instances);
    for (const DrawRun& run : draws.runs) {
        FeatureSet features = frame_features;
        if (!is_reached(run.bounds_world, lights)) features &= ~feature::kLocalLights;
        const FeatureSet variant = variant_of(resources.materials.features(run.material), features);
        const gl::Program* program = resources.shaders.find(kMeshShader, variant);
        if (program == nullptr) continue;
        program->use();
        resources.materials.bind(run.material);
        if (run.two_sided) {
            glDisable(GL_CULL_FACE);
        } else {
            glEnable(GL_CULL_FACE);
        }
        draw_instances(resources.meshes.get(run.mesh), MeshDetail::Full, instances_, run);
        count_draw(stats, run);
    }
}

}  // namespace plumbline::render
