// One shadow map: what a light sees, as depth. Drawn again only when something it sees moved.
//
// Does not move with its casters: the light's matrix comes from shadow_fit.
#pragma once

#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/scene_resources.h"

#include <cstdint>
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
    /// Draws the casters in sight of the light, or nothing if the map shows them already.
    void render(const ShadowView& view,
                const RenderFrame& frame,
                SceneResources& resources,
                FrameStats& stats);
    /// Frees the map.
    void free();

    const gl::Texture& map() const { return map_; }
    std::size_t bytes() const { return map_.bytes(); }

private:
    void draw(const ShadowView& view, SceneResources& resources, FrameStats& stats);

    gl::Texture map_;
    gl::Framebuffer framebuffer_;
    std::uint64_t drawn_hash_{0};
    DrawList draws_;
    InstanceStream instances_;
};

}  // namespace plumbline::render
