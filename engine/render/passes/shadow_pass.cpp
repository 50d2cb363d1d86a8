#include "engine/render/passes/shadow_pass.h"

#include "engine/core/hash.h"
#include "engine/render/culling/frustum.h"
#include "engine/render/culling/occlusion_culling.h"
#include "engine/render/light/shadow_reach.h"

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace plumbline::render {
namespace {

void add_caster(Hasher& hasher, const DrawItem& item, const assets::AssetLibrary& library) {
    hasher.add(&item.mesh, sizeof(item.mesh));
    // What bends or is read again keeps its id.
    const auto version = library.mesh(item.mesh).version;
    hasher.add(&version, sizeof(version));
    hasher.add(&item.world_from_body, sizeof(item.world_from_body));
}

/// All that casts and cannot move, in sight or not, but for so many floors that were left out.
std::uint64_t hash_of_statics(const RenderFrame& frame,
                              const assets::AssetLibrary& library,
                              std::size_t bare_floors,
                              float error_m) {
    Hasher hasher;
    hasher.add(&bare_floors, sizeof(bare_floors));
    hasher.add(&error_m, sizeof(error_m));
    for (const DrawItem& item : frame.items) {
        if (!item.is_static || !item.casts_shadow || item.mesh.value == 0) continue;
        add_caster(hasher, item, library);
        const std::span<const assets::MaterialId> materials = materials_of(frame, item);
        hasher.add(materials.data(), materials.size_bytes());
    }
    return hasher.digest();
}

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
        add_caster(hasher, item, library);
        hasher.add(caster.parts.data(), caster.parts.size_bytes());
        hasher.add(caster.materials.data(), caster.materials.size_bytes());
    }
    return hasher.digest();
}

bool is_static(const VisibleItem& caster) {
    return caster.item->is_static;
}

/// Resting bodies may have sunk so far into what they rest on.
constexpr float kSunk_m = 0.05F;

/// A floor that nothing lies below: as large as it is, it would fill the map for nothing.
bool is_bare_floor(const VisibleItem& caster,
                   const Mat4f& clip_from_world,
                   const RenderFrame& frame,
                   const assets::AssetLibrary& library) {
    const Vec3f along{clip_from_world[0][2], clip_from_world[1][2], clip_from_world[2][2]};
    if (!is_static(caster) || !is_parallel(clip_from_world)) return false;
    const Vec3f in_map = transformed(caster.bounds_world, clip_from_world).size();
    if (std::min(in_map.x, in_map.y) < 1.0F) return false;  // half of the map's width
    return shades_nothing(frame, library, *caster.item, glm::normalize(along), kSunk_m);
}

/// In the sun's map: what can move will in the next frame, which then finds the rest drawn. A lamp has six
/// maps, of places where less goes on.
bool is_likely_to_move(const ShadowView& view, const std::vector<VisibleItem>& casters) {
    if (view.from_lamp || view.moves) return false;
    const auto still = std::ranges::count_if(casters, is_static);
    return still > 0 && still < std::ssize(casters);
}

/// So many frames may a far cascade be behind what moves in it.
constexpr int kFarLag_frames = 3;

}  // namespace

std::vector<VisibleItem> casters_in(const Frustum& volume,
                                    const Vec3f& eye_world,
                                    float error_m,
                                    const RenderFrame& frame,
                                    const SceneResources& resources) {
    std::vector<VisibleItem> casters =
        cull(frame,
             resources.library,
             {.frustum = volume,
              .eye_world = eye_world,
              .lods = error_m > 0.0F ? &resources.meshes.lods() : nullptr,
              .error_m = error_m});
    std::erase_if(casters, [](const VisibleItem& caster) { return !caster.item->casts_shadow; });
    return casters;
}

void ShadowPass::make_map(Map& map) const {
    map.framebuffer = {};
    map.depth = gl::Texture::target(
        gl::TargetFormat::Depth32F, size_px_ * columns_, size_px_ * rows_, gl::Filter::Linear);
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
                        const ShadowSight* sight,
                        const RenderFrame& frame,
                        PassContext context) {
    resize(std::max(views.front().size_px, 16U), static_cast<std::uint32_t>(views.size()), 1);
    const assets::AssetLibrary& library = context.resources.library;
    for (std::size_t i = 0; i < views.size(); ++i) {
        ShadowView view = views[i];
        std::vector<VisibleItem> casters = casters_in(caster_volume(view.clip_from_world),
                                                      view.eye_world,
                                                      view.error_m,
                                                      frame,
                                                      context.resources);
        const std::size_t bare_floors = std::erase_if(casters, [&](const VisibleItem& caster) {
            return is_bare_floor(caster, view.clip_from_world, frame, library);
        });
        if (view.clip_from_world != drawn_[i].view && is_parallel(view.clip_from_world))
            view.statics = hash_of_statics(frame, library, bare_floors, view.error_m);
        view.may_lag = i > 0;
        show(i, view, i == 0 ? sight : nullptr, std::move(casters), context);
    }
}

void ShadowPass::show(std::size_t part,
                      const ShadowView& view,
                      const ShadowSight* sight,
                      std::vector<VisibleItem> casters,
                      PassContext context) {
    const assets::AssetLibrary& library = context.resources.library;
    const std::uint64_t statics = hash_of(view, casters, Casters::Static, library);
    const std::uint64_t moving = hash_of(view, casters, Casters::Moving, library);
    Part& shown = drawn_[part];
    const bool may_lag = view.may_lag && ++shown.age_frames <= kFarLag_frames;
    const bool same_statics = shown.statics == statics;
    const bool same_moving = shown.moving == moving;
    if (same_statics && (same_moving || may_lag) && !shown.is_partial) {
        ++context.stats.shadow_passes_cached;
        return;
    }
    ++context.stats.shadow_passes_rendered;
    if (!statics_.depth && (same_statics || is_likely_to_move(view, casters))) make_map(statics_);
    shown.statics = statics;
    shown.moving = moving;
    shown.age_frames = 0;
    const std::size_t all = casters.size();
    if (sight != nullptr && !same_moving) remove_unseen_casters(casters, library, *sight);
    shown.is_partial = casters.size() < all;
    if (statics_.depth && !view.moves) {
        draw_on_statics(view, part, std::move(casters), context);
    } else {
        clear(shown_, part, whole());
        shown.ground = 0;
        draw(view, std::move(casters), context);
    }
    shown.view = view.clip_from_world;
}

ShadowPass::TexelRect ShadowPass::placed(std::size_t part, const TexelRect& rect) const {
    const auto left = static_cast<int>(part % columns_ * size_px_);
    const auto bottom = static_cast<int>(part / columns_ * size_px_);
    return {left + rect.left, bottom + rect.bottom, left + rect.right, bottom + rect.top};
}

void ShadowPass::aim(const Map& map, std::size_t part, const TexelRect& rect) const {
    glBindFramebuffer(GL_FRAMEBUFFER, map.framebuffer.name());
    const auto size = static_cast<GLsizei>(size_px_);
    const TexelRect place = placed(part, {});
    glViewport(place.left, place.bottom, size, size);
    const TexelRect cut = placed(part, rect);
    glScissor(cut.left, cut.bottom, cut.right - cut.left, cut.top - cut.bottom);
}

void ShadowPass::clear(const Map& map, std::size_t part, const TexelRect& rect) const {
    aim(map, part, rect);
    glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
}

void ShadowPass::draw(const ShadowView& view,
                      std::vector<VisibleItem> casters,
                      PassContext context) {
    draws_.clear();
    const Emitters emitters = view.from_lamp ? Emitters::LetThrough : Emitters::Cast;
    remove_hidden(casters,
                  context.resources.library,
                  {.clip_from_world = view.clip_from_world,
                   .width_px = size_px_,
                   .height_px = size_px_,
                   .emitters = emitters});
    build_depth_draws(std::move(casters), context.resources.library, emitters, draws_);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    // Casters between the light and the box keep casting: their depth is clamped, not cut.
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(view.slope_bias, view.bias_units);
    instances_.upload(draws_.instances);
    for (const DrawRun& run : draws_.runs) {
        const bool masked = run.material.value != 0;
        const gl::Program* program =
            context.program(kDepthShader, depth_feature::kAlphaMask.when(masked));
        if (program == nullptr) continue;
        program->use();
        glUniformMatrix4fv(program->location("clip_from_world"),
                           1,
                           GL_FALSE,
                           glm::value_ptr(view.clip_from_world));
        if (masked) context.resources.materials.bind(run.material);
        // A closed body's far sides lie behind its near ones; cards and leaves have no far side.
        if (run.two_sided) {
            glDisable(GL_CULL_FACE);
        } else {
            glEnable(GL_CULL_FACE);
        }
        draw_instances(context.resources.meshes.get(run.mesh),
                       masked ? MeshDetail::Full : MeshDetail::DepthOnly,
                       instances_,
                       run);
        count_draw(context.stats, run);
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
