#include "engine/render/passes/mesh_pass.h"

#include "engine/render/shader_blocks.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <utility>

namespace plumbline::render {
namespace {

constexpr FeatureSet kLightFeatures = feature::kSun | feature::kSunShadow | feature::kFlashlight |
                                      feature::kLocalLights | feature::kSkyLight |
                                      feature::kSoftShadows | feature::kHardShadows;

float distance_to(const Aabb& box, const Vec3f& point) {
    return glm::distance(point, glm::clamp(point, box.min, box.max));
}

/// The lights that reach the box, strongest first, at most kMaxLightsPerDraw.
std::vector<int> lights_reaching(const Aabb& box, const std::vector<LocalLight>& lights) {
    std::vector<std::pair<float, int>> reaching;
    const std::size_t count = std::min(lights.size(), kMaxLights);
    for (std::size_t i = 0; i < count; ++i) {
        const float share = distance_to(box, lights[i].position_world) / lights[i].radius_m;
        if (share < 1.0F) reaching.emplace_back(share, static_cast<int>(i));
    }
    std::ranges::sort(reaching);
    if (reaching.size() > kMaxLightsPerDraw) reaching.resize(kMaxLightsPerDraw);
    std::vector<int> indices;
    for (const auto& [share, index] : reaching) indices.push_back(index);
    return indices;
}

void set_lights(const gl::Program& program, const std::vector<int>& indices) {
    glUniform1i(program.location("light_count"), static_cast<GLint>(indices.size()));
    if (indices.empty()) return;
    glUniform1iv(
        program.location("light_index"), static_cast<GLsizei>(indices.size()), indices.data());
}

}  // namespace

FeatureSet variant_of(FeatureSet material_features, FeatureSet frame_features) {
    if ((material_features & feature::kUnlit) != 0) frame_features &= ~kLightFeatures;
    if ((frame_features & feature::kSkyLight) == 0) material_features &= ~feature::kSkyReflection;
    return material_features | frame_features;
}

void upload_local_lights(gl::Buffer& buffer, const std::vector<LocalLight>& lights) {
    LocalLightsBlock block;
    for (std::size_t i = 0; i < std::min(lights.size(), kMaxLights); ++i) {
        const LocalLight& light = lights[i];
        const float width = std::max(light.inner_cos - light.outer_cos, 1e-3F);
        block.lights[i] = {
            .position_world = Vec4f{light.position_world, 1.0F / std::max(light.radius_m, 1e-3F)},
            .intensity = Vec4f{light.intensity * glm::one_over_pi<float>(),
                               light.is_spot ? light.outer_cos : -2.0F},
            .direction_world = Vec4f{light.direction_world, 1.0F / width}};
    }
    buffer.upload(&block, sizeof(block));
    gl::bind_uniforms(kLocalLightsBinding, buffer, 0, sizeof(block));
}

void MeshPass::render(const DrawList& draws,
                      FeatureSet frame_features,
                      const std::vector<LocalLight>& lights,
                      SceneResources& resources,
                      FrameStats& stats) {
    if (draws.runs.empty()) return;
    instances_.upload(draws.instances);
    for (const DrawRun& run : draws.runs) {
        const std::vector<int> reaching = lights_reaching(run.bounds_world, lights);
        FeatureSet features = frame_features;
        if (reaching.empty()) features &= ~feature::kLocalLights;
        const FeatureSet variant = variant_of(resources.materials.features(run.material), features);
        const gl::Program* program = resources.shaders.find(kMeshShader, variant);
        if (program == nullptr) continue;
        program->use();
        resources.materials.bind(run.material);
        if ((variant & feature::kLocalLights) != 0) set_lights(*program, reaching);
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
