// What cannot move, in a map of its own: drawn once, copied under what moves, and taken along when the
// light's view goes aside.
#include "engine/render/culling/frustum.h"
#include "engine/render/passes/shadow_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace plumbline::render {
namespace {

/// Steps are whole texels; so far off they may be in floating point.
constexpr float kRounding_px = 0.02F;

}  // namespace

void ShadowPass::draw_on_statics(const ShadowView& view,
                                 std::size_t part,
                                 std::vector<VisibleItem> casters,
                                 PassContext context) {
    const auto first_moving =
        std::stable_partition(casters.begin(), casters.end(), [](const VisibleItem& caster) {
            return caster.item->is_static;
        });
    std::vector<VisibleItem> moving{first_moving, casters.end()};
    casters.erase(first_moving, casters.end());
    Part& shown = drawn_[part];
    if (shown.in_statics_map != shown.statics) {
        if (const std::optional<glm::ivec2> shift = shift_of(part, view)) {
            shift_statics(view, part, *shift, casters, context);
        } else {
            clear(statics_, part, whole());
            draw(view, std::move(casters), context);
        }
        shown.in_statics_map = shown.statics;
        shown.all_statics = view.statics;
    }
    // A copy of a part is cheaper on software GL than to clear it.
    const TexelRect rect = placed(part, shown.ground == shown.statics ? shown.drawn_over : whole());
    copy(statics_, rect, shown_, rect);
    shown.ground = shown.statics;
    shown.drawn_over = texels_of(view, moving);
    aim(shown_, part, whole());
    draw(view, std::move(moving), context);
}

std::optional<glm::ivec2> ShadowPass::shift_of(std::size_t part, const ShadowView& view) const {
    const Part& held = drawn_[part];
    if (view.statics == 0 || view.statics != held.all_statics) return {};
    const Mat4f& now = view.clip_from_world;
    const Mat4f& before = held.view;
    if (!is_parallel(now) || Mat3f{now} != Mat3f{before} || now[3].z != before[3].z) return {};
    const auto size = static_cast<float>(size_px_);
    const Vec2f moved_px = Vec2f{now[3] - before[3]} * (0.5F * size);
    const Vec2f whole_px = glm::round(moved_px);
    const Vec2f off_px = glm::abs(moved_px - whole_px);
    if (std::max(off_px.x, off_px.y) > kRounding_px) return {};
    if (std::max(std::abs(whole_px.x), std::abs(whole_px.y)) >= size) return {};
    return glm::ivec2{whole_px};
}

void ShadowPass::shift_statics(const ShadowView& view,
                               std::size_t part,
                               glm::ivec2 shift,
                               std::span<const VisibleItem> casters,
                               PassContext context) {
    const TexelRect all = whole();
    const TexelRect kept{std::max(shift.x, 0),
                         std::max(shift.y, 0),
                         std::min(all.right + shift.x, all.right),
                         std::min(all.top + shift.y, all.top)};
    const TexelRect before{
        kept.left - shift.x, kept.bottom - shift.y, kept.right - shift.x, kept.top - shift.y};
    // By way of the other map: within one image such copies may not overlap.
    copy(statics_, placed(part, before), shown_, placed(part, kept));
    const std::array<TexelRect, 4> bare{{{0, 0, kept.left, all.top},
                                         {kept.right, 0, all.right, all.top},
                                         {kept.left, 0, kept.right, kept.bottom},
                                         {kept.left, kept.top, kept.right, all.top}}};
    for (const TexelRect& rect : bare) {
        if (rect.empty()) continue;
        std::vector<VisibleItem> within;
        std::ranges::copy_if(casters, std::back_inserter(within), [&](const VisibleItem& caster) {
            return rect.overlaps(texels_of(view, {&caster, 1}));
        });
        clear(shown_, part, rect);
        draw(view, std::move(within), context);
    }
    copy(shown_, placed(part, all), statics_, placed(part, all));
    drawn_[part].ground = drawn_[part].statics;
    drawn_[part].drawn_over = {};
}

ShadowPass::TexelRect ShadowPass::texels_of(const ShadowView& view,
                                            std::span<const VisibleItem> casters) const {
    if (!is_parallel(view.clip_from_world)) return whole();
    Aabb clip;
    for (const VisibleItem& caster : casters)
        clip.include(transformed(caster.bounds_world, view.clip_from_world));
    if (clip.empty()) return {};
    const auto size = static_cast<float>(size_px_);
    const auto texel = [size](float at, float beside) {
        return static_cast<int>(std::clamp((at * 0.5F + 0.5F) * size + beside, 0.0F, size));
    };
    return {texel(clip.min.x, -1.0F),
            texel(clip.min.y, -1.0F),
            texel(clip.max.x, 2.0F),
            texel(clip.max.y, 2.0F)};
}

void ShadowPass::copy(const Map& from,
                      const TexelRect& rect,
                      const Map& to,
                      const TexelRect& into) {
    if (rect.empty()) return;
    glDisable(GL_SCISSOR_TEST);
    gl::copy(from.framebuffer, rect, to.framebuffer, into, GL_DEPTH_BUFFER_BIT);
}

}  // namespace plumbline::render
