// The shadow map of a light: what it sees, as depth; several cascades lie side by side in one image.
// Drawn again only when something in sight moved. Once something moves, what cannot is kept in a map of
// its own, from which the moving things' map starts. Where far cascades show moving things only they may
// lag: a few frames behind, they are drawn in turns.
//
// Does not move with its casters: the light's matrix comes from shadow_fit.
#pragma once

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
    float error_m{0.0F};  ///< casters may be coarser by so much; 0: full meshes
};

class ShadowPass {
public:
    /// Draws the casters in sight of the light, or nothing if the map shows them already. All views
    /// have one size; the first is the nearest.
    void render(std::span<const ShadowView> views,
                const RenderFrame& frame,
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
    /// What one cascade shows; hashes.
    struct Cascade {
        std::uint64_t statics{0};  ///< and the view
        std::uint64_t moving{0};
        std::uint64_t in_statics_map{0};
        int age_frames{0};
    };
    static void make_map(Map& map, std::uint32_t size_px, std::uint32_t count);
    static void aim(const Map& map, std::size_t cascade);
    static void clear(const Map& map, std::size_t cascade);
    void draw_on_statics(const ShadowView& view,
                         std::size_t cascade,
                         std::vector<VisibleItem> casters,
                         SceneResources& resources,
                         FrameStats& stats);
    /// Into the map aimed at.
    void draw(const ShadowView& view,
              std::vector<VisibleItem> casters,
              SceneResources& resources,
              FrameStats& stats);

    Map shown_;
    Map statics_;  ///< empty until something moves
    std::vector<Cascade> drawn_;
    DrawList draws_;
    InstanceStream instances_;
};

}  // namespace plumbline::render
