#include "engine/render/culling/occlusion_culling.h"

#include "engine/render/culling/frustum.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace plumbline::render {
namespace {

constexpr std::size_t kCorners = 8;
constexpr float kNearest_w = 1e-4F;

/// A box in the image. Rows run up, as OpenGL's; a pixel's centre lies at 0.5 beside its number.
struct Outline {
    std::array<Vec2f, kCorners> corners_px;  ///< bit k of the number: on axis k's far side
    Vec2f min_px{std::numeric_limits<float>::max()};
    Vec2f max_px{std::numeric_limits<float>::lowest()};
    float near_depth{std::numeric_limits<float>::max()};
    float far_depth{std::numeric_limits<float>::lowest()};
    bool is_before_eye{true};  ///< all of it
    bool hides{false};
};

/// Pixel numbers, the last one included.
struct PixelSpan {
    int first{0};
    int last{-1};

    bool empty() const { return first > last; }
};

/// Pixels whose centres lie from `min` to `max`, of `count` in all.
PixelSpan centers_within(float min, float max, int count) {
    const auto most = static_cast<float>(count);
    return {static_cast<int>(std::clamp(min + 0.5F, 0.0F, most)),
            static_cast<int>(std::clamp(max + 0.5F, 0.0F, most)) - 1};
}

float cross(const Vec2f& a, const Vec2f& b) {
    return a.x * b.y - a.y * b.x;
}

/// Calls fn(low, high) for the edges between a side that is seen and one that is not.
template <class Fn>
void for_each_silhouette_edge(const Outline& outline, Fn&& fn) {
    const auto& at = outline.corners_px;
    std::array<std::array<bool, 2>, 3> is_seen{};  // by axis; the near side and the far one
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = 1U << (axis + 1) % 3;
        const std::size_t v = 1U << (axis + 2) % 3;
        const std::size_t far = 1U << axis;
        is_seen[axis][0] = cross(at[u] - at[0], at[v] - at[0]) < 0.0F;
        is_seen[axis][1] = cross(at[far | u] - at[far], at[far | v] - at[far]) > 0.0F;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3;
        const std::size_t v = (axis + 2) % 3;
        for (std::size_t side = 0; side < 4; ++side) {
            if (is_seen[u][side & 1U] == is_seen[v][side >> 1U]) continue;
            const std::size_t corner = (side & 1U) << u | (side >> 1U) << v;
            const Vec2f& a = at[corner];
            const Vec2f& b = at[corner | std::size_t{1} << axis];
            fn(a.y < b.y ? a : b, a.y < b.y ? b : a);
        }
    }
}

/// One bit a pixel: whether a box covers its centre.
class CoverageMask {
public:
    CoverageMask(std::uint32_t width_px, std::uint32_t height_px)
        : width_(static_cast<int>(width_px)),
          height_(static_cast<int>(height_px)),
          words_((width_px + 63) / 64),
          bits_(words_ * height_px) {}

    /// Whether all centres no farther than `reach_px` from the outline's rectangle are covered.
    bool covers(const Outline& outline, float reach_px) const {
        const PixelSpan rows =
            centers_within(outline.min_px.y - reach_px, outline.max_px.y + reach_px, height_);
        const PixelSpan columns =
            centers_within(outline.min_px.x - reach_px, outline.max_px.x + reach_px, width_);
        if (columns.empty()) return true;
        for (int word = columns.first / 64; word <= columns.last / 64; ++word) {
            const std::uint64_t wanted = bits_of(columns, word);
            for (int row = rows.first; row <= rows.last; ++row) {
                if ((~bits_[index(row, word)] & wanted) != 0) return false;
            }
        }
        return true;
    }

    /// Covers the centres that lie in the box, but for those `reach_px` within its edge.
    void add(const Outline& outline, float reach_px) {
        const PixelSpan rows =
            centers_within(outline.min_px.y + reach_px, outline.max_px.y - reach_px, height_);
        if (rows.empty()) return;
        find_spans(outline, rows, reach_px);
        for (int row = rows.first; row <= rows.last; ++row) {
            const Span& span = spans_[static_cast<std::size_t>(row - rows.first)];
            const PixelSpan columns = centers_within(span.left, span.right, width_);
            if (columns.empty()) continue;
            for (int word = columns.first / 64; word <= columns.last / 64; ++word)
                bits_[index(row, word)] |= bits_of(columns, word);
        }
    }

private:
    struct Span {
        float left{std::numeric_limits<float>::max()};
        float right{std::numeric_limits<float>::lowest()};
    };

    std::size_t index(int row, int word) const {
        return static_cast<std::size_t>(row) * words_ + static_cast<std::size_t>(word);
    }
    /// Of the columns those that lie in the word; there is one at least.
    static std::uint64_t bits_of(const PixelSpan& columns, int word) {
        std::uint64_t bits = ~std::uint64_t{0};
        if (word == columns.first / 64) bits &= ~std::uint64_t{0} << columns.first % 64;
        if (word == columns.last / 64) bits &= ~std::uint64_t{0} >> (63 - columns.last % 64);
        return bits;
    }

    /// Where the outline begins and ends at the centres of each row, `reach_px` within its edge.
    void find_spans(const Outline& outline, const PixelSpan& rows, float reach_px) {
        const int count = rows.last - rows.first + 1;
        spans_.assign(static_cast<std::size_t>(count), {});
        for_each_silhouette_edge(outline, [&](const Vec2f& low, const Vec2f& high) {
            if (high.y - low.y < 1e-5F) return;
            const PixelSpan crossed = centers_within(low.y, high.y, height_);
            const float slope = (high.x - low.x) / (high.y - low.y);
            const float inset = reach_px * (1.0F + std::abs(slope));
            const int first = std::max(crossed.first, rows.first);
            const int last = std::min(crossed.last, rows.last);
            float x = low.x + slope * (static_cast<float>(first) + 0.5F - low.y);
            for (int row = first; row <= last; ++row, x += slope) {
                Span& span = spans_[static_cast<std::size_t>(row - rows.first)];
                span.left = std::min(span.left, x + inset);
                span.right = std::max(span.right, x - inset);
            }
        });
    }

    int width_{0};
    int height_{0};
    std::size_t words_{0};  ///< a row
    std::vector<std::uint64_t> bits_;
    std::vector<Span> spans_;  ///< of one outline
};

/// Takes a point into the rectangle and the range of depths, and gives its place in the image.
Vec2f include(Outline& outline, const Vec4f& clip, const OcclusionView& view) {
    const bool parallel = is_parallel(view.clip_from_world);
    // What the near plane cuts open hides nothing; parallel light's casters are not cut.
    if (!(clip.w > kNearest_w) || (!parallel && clip.z < -clip.w)) {
        outline.is_before_eye = false;
        return {};
    }
    const Vec2f half_size = Vec2f{view.width_px, view.height_px} * 0.5F;
    const Vec2f at_px = (Vec2f{clip} / clip.w + 1.0F) * half_size;
    const float depth = parallel ? clip.z : clip.w;
    outline.min_px = glm::min(outline.min_px, at_px);
    outline.max_px = glm::max(outline.max_px, at_px);
    outline.near_depth = std::min(outline.near_depth, depth);
    outline.far_depth = std::max(outline.far_depth, depth);
    return at_px;
}

/// Calls fn(number, place) for the corners of a box after the transform: bit k of the number for axis k's
/// far side.
template <class Fn>
void for_each_corner(const Aabb& box, const Mat4f& target_from_source, Fn&& fn) {
    const Vec3f size = box.size();
    const Vec4f first = target_from_source * Vec4f{box.min, 1.0F};
    const Vec4f x = target_from_source[0] * size.x;
    const Vec4f y = target_from_source[1] * size.y;
    const Vec4f z = target_from_source[2] * size.z;
    const std::array<Vec4f, 4> near_side{first, first + x, first + y, first + x + y};
    for (std::size_t i = 0; i < near_side.size(); ++i) {
        fn(i, near_side[i]);
        fn(i + near_side.size(), near_side[i] + z);
    }
}

Outline outline_of(const Aabb& bounds_body,
                   const Mat4f& world_from_body,
                   const OcclusionView& view) {
    Outline outline;
    for_each_corner(bounds_body,
                    view.clip_from_world * world_from_body,
                    [&](std::size_t corner, const Vec4f& clip) {
                        outline.corners_px[corner] = include(outline, clip, view);
                    });
    return outline;
}

/// Of all that lies in the shadow of a caster, down to the lowest that is visible.
Outline shadow_outline(const VisibleItem& caster,
                       const Aabb& bounds_body,
                       float lowest_m,
                       const ShadowSight& sight) {
    const Mat4f& clip_from_world = sight.view.clip_from_world;
    const Vec3f fall =
        sight.light_direction_world / -sight.light_direction_world.y;  // a metre down
    const Vec4f clip_fall = clip_from_world * Vec4f{fall, 0.0F};
    Outline outline;
    for_each_corner(bounds_body, caster.item->world_from_body, [&](std::size_t, const Vec4f& at) {
        const Vec4f clip = clip_from_world * at;
        include(outline, clip, sight.view);
        include(outline, clip + clip_fall * std::max(at.y - lowest_m, 0.0F), sight.view);
    });
    // Twice as wide as the margin looks at the nearest place, as what lies nearer looks farther out.
    const float near_m = outline.near_depth - sight.margin_m;
    outline.is_before_eye = outline.is_before_eye && near_m > kNearest_w;
    const float scale = glm::length(Vec3f{glm::row(sight.view.clip_from_world, 1)});
    const float margin_px =
        sight.margin_m * scale * static_cast<float>(sight.view.height_px) / near_m;
    outline.min_px -= margin_px;
    outline.max_px += margin_px;
    outline.near_depth = near_m;
    return outline;
}

bool is_opaque(const VisibleItem& item, const assets::AssetLibrary& library, Emitters emitters) {
    return std::ranges::all_of(item.parts, [&](const assets::SubMesh& part) {
        const assets::MaterialData& look = look_of(library, material_of(item, part));
        if (emitters == Emitters::LetThrough && look.emissive != Vec3f{0.0F}) return false;
        return look.alpha_mode == assets::AlphaMode::Opaque;
    });
}

/// One for each item; empty if nothing hides anything.
std::vector<Outline> outlines_of(std::span<const VisibleItem> visible,
                                 const assets::AssetLibrary& library,
                                 const OcclusionView& view) {
    assets::MeshId last_mesh{};
    bool last_is_box = false;
    const auto is_box_mesh = [&](const VisibleItem& item) {
        if (item.item->mesh != last_mesh) {
            last_mesh = item.item->mesh;
            last_is_box = is_box(library.mesh(last_mesh));
        }
        return last_is_box;
    };
    std::vector<bool> hides;
    hides.reserve(visible.size());
    for (const VisibleItem& item : visible)
        hides.push_back(is_box_mesh(item) && is_opaque(item, library, view.emitters));
    std::vector<Outline> outlines;
    if (std::ranges::find(hides, true) == hides.end()) return outlines;
    outlines.reserve(visible.size());
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const DrawItem& item = *visible[i].item;
        outlines.push_back(outline_of(library.mesh(item.mesh).bounds, item.world_from_body, view));
        outlines.back().hides = hides[i] && outlines.back().is_before_eye;
    }
    return outlines;
}

struct DepthEntry {
    float depth{0.0F};
    std::uint32_t index{0};
};

/// Which of them the boxes hide; `tested` may be the boxes themselves.
std::vector<bool> find_hidden(std::span<const Outline> tested,
                              std::span<const Outline> boxes,
                              const OcclusionView& view) {
    std::vector<DepthEntry> by_near;
    for (std::uint32_t i = 0; i < tested.size(); ++i) {
        if (tested[i].is_before_eye) by_near.push_back({tested[i].near_depth, i});
    }
    std::vector<DepthEntry> by_far;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].hides) by_far.push_back({boxes[i].far_depth, i});
    }
    std::ranges::sort(by_near, {}, &DepthEntry::depth);
    std::ranges::sort(by_far, {}, &DepthEntry::depth);
    CoverageMask mask{view.width_px, view.height_px};
    std::vector<bool> hidden(tested.size());
    const bool hide_each_other = tested.data() == boxes.data();
    std::size_t next = 0;
    for (const DepthEntry& entry : by_near) {
        for (; next < by_far.size() && by_far[next].depth <= entry.depth; ++next) {
            const std::uint32_t box = by_far[next].index;
            // What is hidden hides nothing that is not hidden without it.
            if (!hide_each_other || !hidden[box]) mask.add(boxes[box], view.reach_px);
        }
        hidden[entry.index] = mask.covers(tested[entry.index], view.reach_px);
    }
    return hidden;
}

}  // namespace

bool is_box(const assets::MeshData& mesh) {
    if (mesh.indices.size() != 36) return false;
    const Vec3f size = mesh.bounds.size();
    const float rounding_m = 1e-5F * glm::length(size);
    const auto is_at_corner = [&](std::uint32_t index) {
        const Vec3f& at = mesh.vertices[index].position_body;
        const Vec3f off = glm::min(glm::abs(at - mesh.bounds.min), glm::abs(at - mesh.bounds.max));
        return std::max({off.x, off.y, off.z}) <= rounding_m;
    };
    if (!std::ranges::all_of(mesh.indices, is_at_corner)) return false;
    float volume_m3 = 0.0F;  // signed, by the divergence theorem
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return mesh.vertices[mesh.indices[i + k]].position_body - mesh.bounds.min;
        };
        volume_m3 += glm::dot(corner(0), glm::cross(corner(1), corner(2))) / 6.0F;
    }
    return volume_m3 > 0.999F * size.x * size.y * size.z;
}

void remove_hidden(std::vector<VisibleItem>& visible,
                   const assets::AssetLibrary& library,
                   const OcclusionView& view) {
    const std::vector<Outline> outlines = outlines_of(visible, library, view);
    if (outlines.empty()) return;
    const std::vector<bool> hidden = find_hidden(outlines, outlines, view);
    std::size_t index = 0;
    std::erase_if(visible, [&](const VisibleItem&) { return hidden[index++]; });
}

void remove_unseen_casters(std::vector<VisibleItem>& casters,
                           const assets::AssetLibrary& library,
                           const ShadowSight& sight) {
    constexpr float kLowest = 0.17F;  // sine of 10 degrees
    if (sight.light_direction_world.y > -kLowest) return;
    const std::vector<Outline> boxes = outlines_of(sight.visible, library, sight.view);
    if (boxes.empty()) return;
    float lowest_m = std::numeric_limits<float>::max();
    for (const VisibleItem& item : sight.visible)
        lowest_m = std::min(lowest_m, item.bounds_world.min.y);
    std::vector<Outline> shadows;
    shadows.reserve(casters.size());
    for (const VisibleItem& caster : casters) {
        if (caster.item->is_static) {
            shadows.push_back({.is_before_eye = false});
            continue;
        }
        const Aabb& bounds_body = library.mesh(caster.item->mesh).bounds;
        shadows.push_back(shadow_outline(caster, bounds_body, lowest_m, sight));
    }
    const std::vector<bool> hidden = find_hidden(shadows, boxes, sight.view);
    std::size_t index = 0;
    std::erase_if(casters, [&](const VisibleItem&) { return hidden[index++]; });
}

}  // namespace plumbline::render
