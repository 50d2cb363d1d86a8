// The shadow map of a light: what it sees, as depth; several cascades lie side by side in one image.
// Drawn again only when something in sight moved. Where far cascades show moving things only they
// may lag: a few frames behind, they are drawn in turns.
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

    const gl::Texture& map() const { return map_; }
    std::size_t bytes() const { return map_.bytes(); }

private:
    /// What one cascade shows.
    struct Cascade {
        std::uint64_t view_and_statics{0};  ///< hashes
        std::uint64_t moving{0};
        int age_frames{0};
    };
    void draw(const ShadowView& view,
              std::size_t cascade,
              SceneResources& resources,
              FrameStats& stats);

    gl::Texture map_;
    gl::Framebuffer framebuffer_;
    std::vector<Cascade> drawn_;
    DrawList draws_;
    InstanceStream instances_;
};

}  // namespace plumbline::render
