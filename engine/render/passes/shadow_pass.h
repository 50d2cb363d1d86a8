// The shadow map of a light: what it sees, as depth; several cascades lie side by side in one image.
// Drawn again only when something in sight moved. Where something moves, what cannot is kept in a map of
// its own, from which the moving things' map starts; where the light's view goes aside by whole texels, it
// goes along, and only what comes into it is drawn. Where far cascades show moving things only they may lag:
// a few frames behind, they are drawn in turns.
//
// Does not move with its casters: the light's matrix comes from shadow_fit.
#pragma once

#include "engine/render/culling/occlusion_culling.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/light/shadow_view.h"
#include "engine/render/passes/pass_context.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace plumbline::render {

/// What casts shadows into a volume, as coarse as it may be: off by `error_m`; 0: full meshes.
std::vector<VisibleItem> casters_in(const Frustum& volume,
                                    const Vec3f& eye_world,
                                    float error_m,
                                    const RenderFrame& frame,
                                    const SceneResources& resources);

class ShadowPass {
public:
    /// Draws the casters in sight of the light, or nothing if the map shows them already. All views
    /// have one size; the first is the nearest. While things move, casters are left out of the first
    /// whose shadows `sight` does not see; null: none.
    void render(std::span<const ShadowView> views,
                const ShadowSight* sight,
                const RenderFrame& frame,
                PassContext context);
    /// Of a map that is made of many: `columns` in a row. Nothing is shown any more if the size changes.
    void resize(std::uint32_t size_px, std::uint32_t columns, std::uint32_t rows);
    /// One of those maps, row by row; drawn only if it does not show this already.
    void show(std::size_t part,
              const ShadowView& view,
              const ShadowSight* sight,
              std::vector<VisibleItem> casters,
              PassContext context);
    /// Frees the map.
    void free();

    const gl::Texture& map() const { return shown_.depth; }
    std::size_t bytes() const { return shown_.depth.bytes() + statics_.depth.bytes(); }

private:
    struct Map {
        gl::Texture depth;
        gl::Framebuffer framebuffer;
    };
    /// Texels of a part.
    using TexelRect = gl::PixelRect;
    /// What one part shows; hashes.
    struct Part {
        Mat4f view{0.0F};          ///< in which it is drawn: clip from world
        std::uint64_t statics{0};  ///< and the view
        std::uint64_t moving{0};
        std::uint64_t in_statics_map{0};
        std::uint64_t all_statics{0};  ///< the view's when that was drawn
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
    /// At the part, of which no more than `rect` is drawn on.
    void aim(const Map& map, std::size_t part, const TexelRect& rect) const;
    void clear(const Map& map, std::size_t part, const TexelRect& rect) const;
    /// Rectangles of one size in the whole maps.
    static void copy(const Map& from, const TexelRect& rect, const Map& to, const TexelRect& into);
    /// Texels by which what the statics' map holds has gone aside in this view; none: it holds nothing
    /// that this one can use.
    std::optional<glm::ivec2> shift_of(std::size_t part, const ShadowView& view) const;
    /// What cannot move, into both maps.
    void shift_statics(const ShadowView& view,
                       std::size_t part,
                       glm::ivec2 shift,
                       std::span<const VisibleItem> casters,
                       PassContext context);
    void draw_on_statics(const ShadowView& view,
                         std::size_t part,
                         std::vector<VisibleItem> casters,
                         PassContext context);
    /// Into the map aimed at.
    void draw(const ShadowView& view, std::vector<VisibleItem> casters, PassContext context);

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
