// The shadow maps of local lights: six round each that was chosen, a row of one image a light. A map is
// drawn again only when something moved in it, or the light itself.
#pragma once

#include "engine/render/light/light_shadows.h"
#include "engine/render/passes/shadow_pass.h"

namespace plumbline::render {

class LightShadowPass {
public:
    /// `chosen`: of the frame's lights, not empty. `error_m`: casters may be coarser by so much; 0: full
    /// meshes.
    void render(std::span<const ShadowedLight> chosen,
                std::uint32_t size_px,
                float error_m,
                const RenderFrame& frame,
                SceneResources& resources,
                FrameStats& stats);
    /// Frees the maps.
    void free();

    const gl::Texture& map() const { return maps_.map(); }
    std::size_t bytes() const { return maps_.bytes(); }

private:
    ShadowPass maps_;
    std::uint32_t rows_{0};
};

}  // namespace plumbline::render
