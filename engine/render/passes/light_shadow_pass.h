// The shadow maps of local lights: six round each that was chosen, a row of one image a light. A map is
// drawn again only when something moved in it, or the light itself.
#pragma once

#include "engine/render/passes/shadow_pass.h"
#include "engine/render/setup/frame_setup.h"

namespace plumbline::render {

class LightShadowPass {
public:
    /// The frame's choice of lamps is not empty.
    void render(const FrameSetup& setup, PassContext context);
    /// Frees the maps.
    void free();

    const gl::Texture& map() const { return maps_.map(); }
    std::size_t bytes() const { return maps_.bytes(); }

private:
    ShadowPass maps_;
    std::uint32_t rows_{0};
};

}  // namespace plumbline::render
