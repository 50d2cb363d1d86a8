#include "engine/render/passes/mesh_pass.h"

#include "shaders/shared/limits.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

constexpr FeatureSet kLightFeatures =
    feature::kSun | feature::kSunShadow | feature::kFlashlight | feature::kLocalLights |
    feature::kSkyLight | feature::kSoftShadows | feature::kHardShadows | feature::kCascades |
    feature::kLightShadows | feature::kContactHardening;

/// For the frames until a program is compiled: nothing that would be see-through is solid, and nothing
/// is read that is not bound.
constexpr Substitutes kSubstitutes{
    .kept = feature::kUnlit | feature::kBlinnPhong | feature::kPhong | feature::kAlphaMask |
            feature::kBlend | feature::kBaseMap | feature::kVertexColor | feature::kSun |
            feature::kSkyLight,
    .harmless = feature::kSoftShadows | feature::kHardShadows | feature::kCascades | feature::kFog |
                feature::kAerial,
    .dear = feature::kSunShadow | feature::kWind | feature::kFog};

float distance_to(const Aabb& box, const Vec3f& point) {
    return glm::distance(point, glm::clamp(point, box.min, box.max));
}

float farthest_m(const Aabb& box, const Vec3f& point) {
    return glm::length(glm::max(glm::abs(box.min - point), glm::abs(box.max - point)));
}

bool is_reached(const Aabb& box, std::span<const LocalLight> lights) {
    return std::ranges::any_of(lights, [&](const LocalLight& light) {
        return distance_to(box, light.position_world) < light.radius_m;
    });
}

// The flashlight's code is dear. A large thing of few triangles, as the ground is, is drawn in two
// parts: first where its beam can reach, then all of it without.
constexpr std::uint64_t kFewTriangles = 1000;
constexpr float kMostLit = 0.7F;

std::uint64_t triangles(const DrawRun& run) {
    return std::uint64_t{run.index_count} / 3 * run.instance_count;
}

/// The far air's light hangs on vertices: a large thing of few, as the ground is, has none where it is
/// near, and goes without.
bool is_in_far_air(const DrawRun& run, const Vec3f& eye_world) {
    if (farthest_m(run.bounds_world, eye_world) < PL_AERIAL_FROM_M) return false;
    return triangles(run) > kFewTriangles ||
           distance_to(run.bounds_world, eye_world) > PL_AERIAL_FROM_M;
}

void scissor(const ClipRect& part, const PixelSize& size_px) {
    const Vec2f size{size_px.width, size_px.height};
    const Vec2f first = glm::floor((part.min * 0.5F + 0.5F) * size) - 1.0F;
    const Vec2f last = glm::ceil((part.max * 0.5F + 0.5F) * size) + 1.0F;
    const Vec2f extent = part.empty() ? Vec2f{0.0F} : last - first;
    glScissor(static_cast<GLint>(first.x),
              static_cast<GLint>(first.y),
              static_cast<GLsizei>(extent.x),
              static_cast<GLsizei>(extent.y));
    glEnable(GL_SCISSOR_TEST);
}

}  // namespace

FeatureSet variant_of(FeatureSet material_features, FeatureSet frame_features) {
    if ((material_features & feature::kUnlit) != 0) frame_features &= ~kLightFeatures;
    if ((frame_features & feature::kSkyLight) == 0) material_features &= ~feature::kSkyReflection;
    if ((material_features & feature::kAlphaMask) == 0) frame_features &= ~feature::kCoverage;
    return material_features | frame_features;
}

void MeshPass::render(const DrawList& draws,
                      DrawKind kind,
                      const MeshView& view,
                      SceneResources& resources,
                      FrameStats& stats) {
    if (draws.runs.empty()) return;
    instances_.upload(draws.instances);
    for (const DrawRun& run : draws.runs) {
        FeatureSet features = view.features;
        if (!is_reached(run.bounds_world, view.lights)) features &= ~feature::kLocalLights;
        if (!is_reached(run.bounds_world, view.lights.first(view.shadowed_lights)))
            features &= ~feature::kLightShadows;
        if (!is_in_far_air(run, view.eye_world)) features &= ~feature::kAerial;
        const FeatureSet without_beam = features & ~feature::kFlashlight;
        if (!run.in_beam) features = without_beam;
        if (run.in_beam && kind == DrawKind::Opaque && triangles(run) <= kFewTriangles) {
            const ClipRect lit = view.beam->lit_part(run.bounds_world, view.clip_from_world);
            if (lit.share() < kMostLit) {
                scissor(lit, view.size_px);
                draw(run, features, resources, stats);
                glDisable(GL_SCISSOR_TEST);
                // Where that drew, this is no nearer.
                features = without_beam;
            }
        }
        draw(run, features, resources, stats);
    }
}

void MeshPass::draw(const DrawRun& run,
                    FeatureSet features,
                    SceneResources& resources,
                    FrameStats& stats) const {
    const GpuMesh& mesh = resources.meshes.get(run.mesh);
    if (!mesh.sways) features &= ~feature::kWind;
    const FeatureSet variant = variant_of(resources.materials.features(run.material), features);
    const gl::Program* program =
        resources.shaders.find_or_similar(kMeshShader, variant, kSubstitutes);
    if (program == nullptr) return;
    program->use();
    resources.materials.bind(run.material);
    if (run.two_sided) {
        glDisable(GL_CULL_FACE);
    } else {
        glEnable(GL_CULL_FACE);
    }
    const bool covers_samples = (variant & feature::kCoverage) != 0;
    if (covers_samples) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    draw_instances(mesh, MeshDetail::Full, instances_, run);
    if (covers_samples) glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    count_draw(stats, run);
}

}  // namespace plumbline::render
