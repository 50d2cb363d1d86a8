#include "engine/render/passes/mesh_pass.h"

#include "engine/render/light/shadow_reach.h"
#include "shaders/shared/limits.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {
namespace {

constexpr FeatureSet kLightFeatures =
    feature::kSun | feature::kSunShadow | kFlashlightFeatures | feature::kLocalLights |
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

// Lights and shadows are dear. A large thing of few triangles, as the ground is, is drawn in parts:
// first where the flashlight's beam and the sun's shadows can reach, then the rest without.
constexpr std::uint64_t kFewTriangles = 1000;
constexpr float kMostLit = 0.7F;     // of the image: more is not worth two draws
constexpr float kLeastSplit = 0.1F;  // of the image: less is not worth a look at all that casts
constexpr FeatureSet kSunShadowFeatures = feature::kSunShadow | feature::kCascades;

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

void bind_behind(const MeshView& view, const gl::Program& program) {
    const auto& [first, last] = view.behind;
    glUniform2f(program.location("depth_line"), view.depth_line.x, view.depth_line.y);
    glUniform4f(program.location("behind_px"),
                first.x + 0.5F,
                first.y + 0.5F,
                last.x + 0.5F,
                last.y + 0.5F);
}

}  // namespace

FeatureSet features_with(FeatureSet frame_features, const GpuMesh& mesh) {
    if (!mesh.sways) frame_features &= ~feature::kWind;
    return mesh.faceted ? frame_features | feature::kFaceted : frame_features;
}

FeatureSet variant_of(FeatureSet material_features,
                      FeatureSet frame_features,
                      const std::set<FeatureSet>& smooth_looks) {
    // With maps there is too little to gain for shaders of their own.
    constexpr FeatureSet kMaps = feature::kBaseMap | feature::kNormalMap | feature::kOrmMap |
                                 feature::kEmissiveMap | feature::kUnlit;
    if ((material_features & kMaps) != 0 || smooth_looks.contains(material_features))
        frame_features &= ~feature::kFaceted;
    if ((material_features & feature::kUnlit) != 0) frame_features &= ~kLightFeatures;
    if ((frame_features & feature::kSkyLight) == 0) material_features &= ~feature::kSkyReflection;
    if ((material_features & feature::kAlphaMask) == 0) frame_features &= ~feature::kCoverage;
    // What both must ask for.
    constexpr FeatureSet kOfBoth = feature::kRefraction | feature::kCaustics;
    const FeatureSet shared = material_features & frame_features & kOfBoth;
    material_features = (material_features & ~kOfBoth) | shared;
    frame_features &= ~kOfBoth;
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
        if (!run.in_beam) features &= ~kFlashlightFeatures;
        std::vector<Local> locals;
        if (kind == DrawKind::Opaque && triangles(run) <= kFewTriangles)
            locals = locals_of(run, features, view, resources);
        if (locals.empty()) {
            draw(run, features, view, resources, stats);
            continue;
        }
        constexpr ClipRect kAll{.min = Vec2f{-1.0F}, .max = Vec2f{1.0F}};
        draw_in_parts(run, features, locals, kAll, view, resources, stats);
        glDisable(GL_SCISSOR_TEST);
    }
}

std::vector<MeshPass::Local> MeshPass::locals_of(const DrawRun& run,
                                                 FeatureSet features,
                                                 const MeshView& view,
                                                 const SceneResources& resources) {
    std::vector<Local> locals;
    const auto add = [&](const ClipRect& part, FeatureSet needed) {
        if (part.share() < kMostLit) locals.push_back({part, needed});
    };
    if ((features & kFlashlightFeatures) != 0)
        add(view.beam->part_seen(run.bounds_world, view.clip_from_world), kFlashlightFeatures);
    const bool may_be_shadowed = (features & kSunShadowFeatures) != 0 && run.only_item != nullptr &&
                                 view.shadow_margin_m > 0.0F;
    if (may_be_shadowed &&
        part_seen(run.bounds_world, view.clip_from_world).share() > kLeastSplit &&
        is_convex(resources.library.mesh(run.mesh))) {
        const std::optional<ConvexVolume> dark = shadows_of_others(*view.frame,
                                                                   resources.library,
                                                                   *run.only_item,
                                                                   view.light_direction_world,
                                                                   view.shadow_margin_m);
        add(dark ? dark->part_seen(run.bounds_world, view.clip_from_world) : ClipRect{},
            kSunShadowFeatures);
    }
    return locals;
}

void MeshPass::draw_in_parts(const DrawRun& run,
                             FeatureSet features,
                             std::span<const Local> locals,
                             const ClipRect& within,
                             const MeshView& view,
                             SceneResources& resources,
                             FrameStats& stats) const {
    if (locals.empty()) {
        scissor(within, view.size_px);
        draw(run, features, view, resources, stats);
        return;
    }
    const Local& local = locals.front();
    const auto others = locals.subspan(1);
    const ClipRect both = intersection(within, local.part);
    if (!both.empty()) draw_in_parts(run, features, others, both, view, resources, stats);
    draw_in_parts(run, features & ~local.features, others, within, view, resources, stats);
}

void MeshPass::draw(const DrawRun& run,
                    FeatureSet features,
                    const MeshView& view,
                    SceneResources& resources,
                    FrameStats& stats) const {
    const GpuMesh& mesh = resources.meshes.get(run.mesh);
    const FeatureSet variant = variant_of(resources.materials.features(run.material),
                                          features_with(features, mesh),
                                          resources.smooth_looks);
    const gl::Program* program =
        resources.shaders.find_or_similar(kMeshShader, variant, kSubstitutes);
    if (program == nullptr) return;
    program->use();
    resources.materials.bind(run.material);
    if ((variant & feature::kRefraction) != 0) bind_behind(view, *program);
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
