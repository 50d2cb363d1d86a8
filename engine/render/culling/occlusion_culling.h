// Occlusion culling: what stands wholly behind boxes is not drawn. Near to far, boxes cover the pixels
// whose centres they hide, one bit a pixel; an item is left out if nearer boxes cover all of the rectangle
// round it. No depth is kept: a box covers only what lies behind its farthest corner. (Coverage masks:
// Greene 1996, "Hierarchical polygon tiling with coverage masks".) No GL.
#pragma once

#include "engine/assets/asset_library.h"
#include "engine/render/culling/draw_list.h"
#include "engine/render/render_frame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::render {

/// A driver rounds places in an image to a 256th of a pixel.
constexpr float kCenterReach_px = 0.01F;
constexpr float kSamplesReach_px = 0.5F;  ///< with several samples a pixel

/// What is drawn into.
struct OcclusionView {
    Mat4f clip_from_world{1.0F};
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    /// So far from a pixel's centre, in x and in y, something shows in it.
    float reach_px{kCenterReach_px};
    Emitters emitters{Emitters::Cast};  ///< LetThrough: what shines hides nothing
};

/// Whether the mesh is a closed box as large as its bounds.
bool is_box(const assets::MeshData& mesh);

/// Leaves out the items that opaque boxes among the others hide; keeps their order. What the wind bends
/// counts as large as its bounds.
void remove_hidden(std::vector<VisibleItem>& visible,
                   const assets::AssetLibrary& library,
                   const OcclusionView& view);

/// Who sees the shadows that a light throws.
struct ShadowSight {
    OcclusionView view;                    ///< the camera's
    std::span<const VisibleItem> visible;  ///< all that it shows
    Vec3f light_direction_world{0.0F};     ///< unit
    float margin_m{0.0F};                  ///< so far beside its caster a shadow may be drawn
};

/// Leaves out the casters that can move and whose shadows, wherever they may fall on what is visible, boxes
/// hide; keeps their order. A light that is less than 10 degrees high leaves all.
void remove_unseen_casters(std::vector<VisibleItem>& casters,
                           const assets::AssetLibrary& library,
                           const ShadowSight& sight);

}  // namespace plumbline::render
