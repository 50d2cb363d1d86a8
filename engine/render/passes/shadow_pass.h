// The shadow map of a light: what it sees, as depth; several cascades lie side by side in one image.
// Drawn again only when something in sight moved. Where something moves, what cannot is kept in a map of
// its own, from which the moving things' map starts. Where far cascades show moving things only they may
// lag: a few frames behind, they are drawn in turns.
//
// Does not move with its casters: the light's matrix comes from shadow_fit.
#pragma once

#include "engine/render/culling/occlusion_culling.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/scene_resources.h"

#include <cstdint>
#include <span>
#include <vector>

namespace plumbline::render {

/// How a shadow map is drawn for one frame.
struct ShadowView {
    Mat4f clip_from_world{1.0F};
    Vec3f eye_world{0.0F};  ///< casters nearest to it are drawn first
    std::uint32_t size_px{1024};
    float slope_bias{1.5F};
    float error_m{0.0F};    ///< casters may be coarser by so much; 0: full meshes
    bool from_lamp{false};  ///< what shines does not cast: it is the lamp
    bool moves{false};      ///< itself: there is no use in keeping what it shows
    bool may_lag{false};    ///< behind moving things
    /// While things move, those are left out whose shadows it does not see; null: none.
    const ShadowSight* sight{nullptr};
};

class ShadowPass {
public:
    /// Draws the casters in sight of the light, or nothing if the map shows them already. All views
    /// have one size; the first is the nearest.
    void render(std::span<const ShadowView> views,
                const RenderFrame& frame,
                SceneResources& resources,
                FrameStats& stats);
    /// Of a map that is made of many: `columns` in a row. Nothing is shown any more if the size changes.
    void resize(std::uint32_t size_px, std::uint32_t columns, std::uint32_t rows);
    /// One of those maps, row by row; drawn only if it does not show this already.
    void show(std::size_t part,
              const ShadowView& view,
              std::vector<VisibleItem> casters,
              SceneResources& resources,
              FrameStats& stats);
    /// Frees the map.
    void free();

    const gl::Texture& map() const { return shown_.depth; }
    std::size_t bytes() const { return shown_.depth.bytes() + statics_.depth.bytes(); }

private:
    struct Map {
        gl::Texture depth;
        gl::Framebuffer framebuffer;
    };
    /// Texels of a part, from its left and its bottom.
    struct TexelRect {
        int left{0};
        int bottom{0};
        int right{0};
        int top{0};
    };
    /// What one part shows; hashes.
    struct Part {
        std::uint64_t statics{0};  ///< and the view
        std::uint64_t moving{0};
        std::uint64_t in_statics_map{0};
        int age_frames{0};
        bool is_partial{false};  ///< without casters whose shadows nobody saw
        std::uint64_t ground{
            0};  ///< what it shows outside of `drawn_over`: these statics; 0: unknown
        TexelRect drawn_over;
    };

    void make_map(Map& map) const;
    TexelRect whole() const {
        return {0, 0, static_cast<int>(size_px_), static_cast<int>(size_px_)};
    }
    /// Holds all texels that the casters can change.
    TexelRect texels_of(const ShadowView& view, std::span<const VisibleItem> casters) const;
    /// Relative to the whole map.
    TexelRect placed(std::size_t part, const TexelRect& rect) const;
    void aim(const Map& map, std::size_t part) const;
    void clear(const Map& map, std::size_t part) const;
    void copy_statics(std::size_t part, const TexelRect& rect) const;
    void draw_on_statics(const ShadowView& view,
                         std::size_t part,
                         std::vector<VisibleItem> casters,
                         SceneResources& resources,
                         FrameStats& stats);
    /// Into the map aimed at.
    void draw(const ShadowView& view,
              std::vector<VisibleItem> casters,
              SceneResources& resources,
              FrameStats& stats);

    Map shown_;
    Map statics_;  ///< empty until something moves, in the sun's map until something can
    std::uint32_t size_px_{0};  ///< of a part
    std::uint32_t columns_{0};
    std::uint32_t rows_{0};
    std::vector<Part> drawn_;
    DrawList draws_;
    InstanceStream instances_;
};

}  // namespace plumbline::render
