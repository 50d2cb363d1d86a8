#include "engine/render/passes/shadow_pass.h"

#include "engine/core/hash.h"
#include "engine/render/culling/frustum.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace plumbline::render {
namespace {

/// The light's volume, on and on towards the light: what stands there casts too.
Frustum caster_volume(const Mat4f& clip_from_world) {
    constexpr float kDepth = 1e-4F;  // of the volume, over that of all casters
    Mat4f open = clip_from_world;
    for (int column = 0; column < 4; ++column) {
        open[column][2] = glm::mix(clip_from_world[column][3], clip_from_world[column][2], kDepth);
    }
    return Frustum{open};
}

enum class Casters { Static, Moving };

std::uint64_t hash_of(const ShadowView& view,
                      const std::vector<VisibleItem>& casters,
                      Casters which,
                      const assets::AssetLibrary& library) {
    Hasher hasher;
    hasher.add(&view.clip_from_world, sizeof(view.clip_from_world));
    hasher.add(&view.size_px, sizeof(view.size_px));
    for (const VisibleItem& caster : casters) {
        const DrawItem& item = *caster.item;
        if (item.is_static != (which == Casters::Static)) continue;
        hasher.add(&item.mesh, sizeof(item.mesh));
        // What bends or is read again keeps its id.
        const auto version = library.mesh(item.mesh).version;
        hasher.add(&version, sizeof(version));
        hasher.add(&item.world_from_body, sizeof(item.world_from_body));
        hasher.add(caster.parts.data(), caster.parts.size_bytes());
        hasher.add(caster.materials.data(), caster.materials.size_bytes());
    }
    return hasher.digest();
}

/// So many frames may a far cascade be behind what moves in it.
constexpr int kFarLag_frames = 3;

}  // namespace

void ShadowPass::make_map(Map& map) const {
    map.framebuffer = {};
    map.depth = gl::Texture::target(
        gl::TargetFormat::Depth16, size_px_ * columns_, size_px_ * rows_, gl::Filter::Linear);
    map.framebuffer = gl::Framebuffer{nullptr, &map.depth};
}

void ShadowPass::resize(std::uint32_t size_px, std::uint32_t columns, std::uint32_t rows) {
    if (size_px == size_px_ && columns == columns_ && rows == rows_) return;
    size_px_ = size_px;
    columns_ = columns;
    rows_ = rows;
    make_map(shown_);
    statics_ = {};
    drawn_.assign(std::size_t{columns} * rows, {});
}

void ShadowPass::render(std::span<const ShadowView> views,
                        const RenderFrame& frame,
                        SceneResources& resources,
                        FrameStats& stats) {
    resize(std::max(views.front().size_px, 16U), static_cast<std::uint32_t>(views.size()), 1);
    for (std::size_t i = 0; i < views.size(); ++i) {
        ShadowView view = views[i];
        std::vector<VisibleItem> casters =
            cull(frame,
                 resources.library,
                 {.frustum = caster_volume(view.clip_from_world),
                  .eye_world = view.eye_world,
                  .lods = view.error_m > 0.0F ? &resources.meshes.lods() : nullptr,
                  .error_m = view.error_m});
        std::erase_if(casters, [](const VisibleItem& c) { return !c.item->casts_shadow; });
        view.may_lag = i > 0;
        show(i, view, std::move(casters), resources, stats);
    }
}

void ShadowPass::show(std::size_t part,
                      const ShadowView& view,
                      std::vector<VisibleItem> casters,
                      SceneResources& resources,
                      FrameStats& stats) {
    const std::uint64_t statics = hash_of(view, casters, Casters::Static, resources.library);
    const std::uint64_t moving = hash_of(view, casters, Casters::Moving, resources.library);
    Part& shown = drawn_[part];
    const bool may_lag = view.may_lag && ++shown.age_frames <= kFarLag_frames;
    const bool same_statics = shown.statics == statics;
    if (same_statics && (shown.moving == moving || may_lag)) {
        ++stats.shadow_passes_cached;
        return;
    }
    ++stats.shadow_passes_rendered;
    if (same_statics && !statics_.depth) make_map(statics_);
    shown.statics = statics;
    shown.moving = moving;
    shown.age_frames = 0;
    if (statics_.depth && !view.moves) {
        draw_on_statics(view, part, std::move(casters), resources, stats);
    } else {
        clear(shown_, part);
        draw(view, std::move(casters), resources, stats);
    }
}

void ShadowPass::draw_on_statics(const ShadowView& view,
                                 std::size_t part,
                                 std::vector<VisibleItem> casters,
                                 SceneResources& resources,
                                 FrameStats& stats) {
    const auto first_moving =
        std::stable_partition(casters.begin(), casters.end(), [](const VisibleItem& caster) {
            return caster.item->is_static;
        });
    std::vector<VisibleItem> moving{first_moving, casters.end()};
    casters.erase(first_moving, casters.end());
    Part& drawn = drawn_[part];
    if (drawn.in_statics_map != drawn.statics) {
        drawn.in_statics_map = drawn.statics;
        clear(statics_, part);
        draw(view, std::move(casters), resources, stats);
    }
    const auto size = static_cast<GLint>(size_px_);
    const auto [left, bottom] = place_of(part);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, statics_.framebuffer.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shown_.framebuffer.name());
    glBlitFramebuffer(left,
                      bottom,
                      left + size,
                      bottom + size,
                      left,
                      bottom,
                      left + size,
                      bottom + size,
                      GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    aim(shown_, part);
    draw(view, std::move(moving), resources, stats);
}

ShadowPass::Place ShadowPass::place_of(std::size_t part) const {
    return {.left = static_cast<int>(part % columns_ * size_px_),
            .bottom = static_cast<int>(part / columns_ * size_px_)};
}

void ShadowPass::aim(const Map& map, std::size_t part) const {
    glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.name());
    const auto size = static_cast<GLsizei>(size_px_);
    const auto [left, bottom] = place_of(part);
    glViewport(left, bottom, size, size);
    glScissor(left, bottom, size, size);
}

void ShadowPass::clear(const Map& map, std::size_t part) const {
    aim(map, part);
    glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowPass::draw(const ShadowView& view,
                      std::vector<VisibleItem> casters,
                      SceneResources& resources,
                      FrameStats& stats) {
    draws_.clear();
    build_depth_draws(std::move(casters),
                      resources.library,
                      view.from_lamp ? Emitters::LetThrough : Emitters::Cast,
                      draws_);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    // Casters between the light and the box keep casting: their depth is clamped, not cut.
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(view.slope_bias, 2.0F);
    instances_.upload(draws_.instances);
    for (const DrawRun& run : draws_.runs) {
        const bool masked = run.material.value != 0;
        const gl::Program* program =
            resources.shaders.find(kDepthShader, masked ? feature::kAlphaMask : 0U);
        if (program == nullptr) continue;
        program->use();
        glUniformMatrix4fv(program->location("clip_from_world"),
                           1,
                           GL_FALSE,
                           glm::value_ptr(view.clip_from_world));
        if (masked) resources.materials.bind(run.material);
        // A closed body's far sides lie behind its near ones; cards and leaves have no far side.
        if (run.two_sided) {
            glDisable(GL_CULL_FACE);
        } else {
            glEnable(GL_CULL_FACE);
        }
        draw_instances(resources.meshes.get(run.mesh),
                       masked ? MeshDetail::Full : MeshDetail::DepthOnly,
                       instances_,
                       run);
        count_draw(stats, run);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_SCISSOR_TEST);
}

void ShadowPass::free() {
    shown_ = {};
    statics_ = {};
    drawn_.clear();
    size_px_ = 0;
}

}  // namespace plumbline::render
