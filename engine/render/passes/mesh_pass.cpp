#include "engine/render/passes/mesh_pass.h"

#include "engine/render/light/shadow_reach.h"

#include <glad/gl.h>

#include <algorithm>

namespace plumbline::render {

using namespace mesh_feature;

namespace {

constexpr FeatureSet kSunShadowFeatures = kSunShadow | kCascades | kContactHardening;
constexpr FeatureSet kShadowFilters = kSoftShadows | kHardShadows;
constexpr FeatureSet kLightFeatures = kSun | kSunShadowFeatures | kShadowFilters |
                                      kFlashlightFeatures | kLocalLights | kLightShadows |
                                      kSkyLight | kIndirect;

/// For the frames until a program is compiled: nothing that would be see-through is solid, and nothing
/// is read that is not bound.
constexpr Substitutes kSubstitutes{.kept = kUnlit | kBlinnPhong | kPhong | kAlphaMask | kBlend |
                                           kBaseMap | kVertexColor | kSun | kSkyLight,
                                   .harmless = kSoftShadows | kHardShadows | kCascades,
                                   .dear = kSunShadow | kSways};

// Lights and shadows are dear. A large thing of few triangles, as the ground is, is drawn in parts:
// first where the flashlight's beam and the sun's shadows can reach, then the rest without.
constexpr std::uint64_t kFewTriangles = 1000;
constexpr float kMostLit = 0.7F;     // of the image: more is not worth two draws
constexpr float kLeastSplit = 0.1F;  // of the image: less is not worth a look at all that casts

bool is_reached(const Aabb& box, std::span<const LocalLight> lights) {
    return std::ranges::any_of(lights, [&](const LocalLight& light) {
        return distance_to(box, light.position_world) < light.radius_m;
    });
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

void bind_behind(const PixelPart& behind, const Vec2f& depth_line, const gl::Program& program) {
    glUniform2f(program.location("depth_line"), depth_line.x, depth_line.y);
    glUniform4f(program.location("behind_px"),
                behind.first.x + 0.5F,
                behind.first.y + 0.5F,
                behind.last.x + 0.5F,
                behind.last.y + 0.5F);
}

/// Shader code that only a part of the image needs.
struct LocalCode {
    ClipRect part;
    FeatureSet features{0};
};

/// Draws the runs of one list.
struct RunDrawer {
    const FrameSetup& setup;
    const std::optional<PixelPart>& behind;
    const InstanceStream& instances;
    PassContext context;

    /// What of the frame's features the run needs.
    FeatureSet features_of(const DrawRun& run) const {
        FeatureSet features = setup.features;
        if (!is_reached(run.bounds_world, setup.lamps.lights)) features &= ~kLocalLights;
        const bool is_static = run.only_item != nullptr && run.only_item->is_static;
        if (!context.resources.light_grid.may_light(run.mesh, is_static, run.bounds_world))
            features &= ~kIndirect;
        if (!run.in_beam) features &= ~kFlashlightFeatures;
        return features;
    }

    /// The code that a large plain thing needs in a part of the image only.
    std::vector<LocalCode> local_code_of(const DrawRun& run, FeatureSet features) const {
        std::vector<LocalCode> locals;
        const Mat4f& clip_from_world = setup.block.clip_from_world;
        const auto add = [&](const ClipRect& part, FeatureSet needed) {
            if (part.share() < kMostLit) locals.push_back({part, needed});
        };
        if ((features & kFlashlightFeatures) != 0)
            add(setup.flashlight.beam->part_seen(run.bounds_world, clip_from_world),
                kFlashlightFeatures);
        const bool may_be_shadowed = (features & kSunShadow) != 0 && run.only_item != nullptr &&
                                     setup.sun.shadow_margin_m > 0.0F;
        if (may_be_shadowed && part_seen(run.bounds_world, clip_from_world).share() > kLeastSplit &&
            is_convex(context.resources.library.mesh(run.mesh))) {
            const std::optional<ConvexVolume> dark =
                shadows_of_others(*setup.frame,
                                  context.resources.library,
                                  *run.only_item,
                                  setup.sun.light->direction_world,
                                  setup.sun.shadow_margin_m);
            add(dark ? dark->part_seen(run.bounds_world, clip_from_world) : ClipRect{},
                kSunShadowFeatures);
        }
        return locals;
    }

    /// First where all of the local code is needed, last where none is: where one drew, the next is no
    /// nearer.
    void draw_in_parts(const DrawRun& run,
                       FeatureSet features,
                       std::span<const LocalCode> locals,
                       const ClipRect& within) const {
        if (locals.empty()) {
            scissor(within, setup.image.scene_px);
            draw(run, features);
            return;
        }
        const LocalCode& local = locals.front();
        const auto others = locals.subspan(1);
        const ClipRect both = intersection(within, local.part);
        if (!both.empty()) draw_in_parts(run, features, others, both);
        draw_in_parts(run, features & ~local.features, others, within);
    }

    void draw(const DrawRun& run, FeatureSet features) const {
        const GpuMesh& mesh = context.resources.meshes.get(run.mesh);
        FeatureSet look = context.resources.materials.features(run.material);
        if (!behind) look &= ~kRefraction;
        const FeatureSet variant =
            variant_of(look, features_with(features, mesh), context.resources.smooth_looks);
        const gl::Program* program =
            context.resources.shaders.find_or_similar(kMeshShader, variant, kSubstitutes);
        if (program == nullptr) return;
        program->use();
        context.resources.materials.bind(run.material);
        if ((variant & kRefraction) != 0) bind_behind(*behind, setup.screen.depth_line, *program);
        if (run.two_sided) {
            glDisable(GL_CULL_FACE);
        } else {
            glEnable(GL_CULL_FACE);
        }
        const bool covers_samples = (variant & kCoverage) != 0;
        if (covers_samples) glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        draw_instances(mesh, MeshDetail::Full, instances, run);
        if (covers_samples) glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        count_draw(context.stats, run);
    }
};

}  // namespace

FeatureSet features_with(FeatureSet frame_features, const GpuMesh& mesh) {
    if (mesh.sways) frame_features |= kSways;
    return mesh.faceted ? frame_features | kFaceted : frame_features;
}

FeatureSet variant_of(FeatureSet material_features,
                      FeatureSet frame_features,
                      const std::set<FeatureSet>& smooth_looks) {
    // With maps there is too little to gain for shaders of their own.
    constexpr FeatureSet kMaps = kBaseMap | kNormalMap | kOrmMap | kEmissiveMap | kUnlit;
    if ((material_features & kMaps) != 0 || smooth_looks.contains(material_features))
        frame_features &= ~kFaceted;
    if ((material_features & kUnlit) != 0) frame_features &= ~kLightFeatures;
    if ((frame_features & kSkyLight) == 0) material_features &= ~kSkyReflection;
    if ((material_features & kAlphaMask) == 0) frame_features &= ~kCoverage;
    if ((material_features & kBlend) != 0) frame_features &= ~(kOcclusion | kIndirect);
    // What only belongs to something that is not there makes no variant.
    if ((frame_features & kSunShadow) == 0) frame_features &= ~kSunShadowFeatures;
    if ((frame_features & kLocalLights) == 0) frame_features &= ~kLightShadows;
    const bool has_filter = (frame_features & (kSunShadow | kLightShadows)) != 0;
    if (!has_filter) frame_features &= ~kHardShadows;
    if (!has_filter && (frame_features & kFlashlight) == 0) frame_features &= ~kSoftShadows;
    return material_features | frame_features;
}

void MeshPass::render(const DrawList& draws,
                      DrawKind kind,
                      const FrameSetup& setup,
                      const std::optional<PixelPart>& behind,
                      PassContext context) {
    if (draws.runs.empty()) return;
    instances_.upload(draws.instances);
    const RunDrawer drawer{setup, behind, instances_, context};
    for (const DrawRun& run : draws.runs) {
        const FeatureSet features = drawer.features_of(run);
        std::vector<LocalCode> locals;
        if (kind == DrawKind::Opaque && triangles(run) <= kFewTriangles)
            locals = drawer.local_code_of(run, features);
        if (locals.empty()) {
            drawer.draw(run, features);
            continue;
        }
        constexpr ClipRect kAll{.min = Vec2f{-1.0F}, .max = Vec2f{1.0F}};
        drawer.draw_in_parts(run, features, locals, kAll);
        glDisable(GL_SCISSOR_TEST);
    }
}

}  // namespace plumbline::render
