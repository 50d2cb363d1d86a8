// The scene through a lens: sharp at one distance.
#pragma once

#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/setup/frame_setup.h"

#include <cstddef>

namespace plumbline::render {

class FocusPass {
public:
    /// The light as the lens sees it, as large as the scene's image. Null: the driver has no memory
    /// for it.
    const gl::Texture* render(const FrameSetup& setup,
                              const SceneLight& light,
                              const FullscreenTriangle& triangle,
                              SceneResources& resources,
                              FrameStats& stats);
    std::size_t bytes() const {
        return half_.image.bytes() + blurred_.image.bytes() + joined_.image.bytes();
    }
    void free() { *this = {}; }

private:
    PassImage half_;
    PassImage blurred_;
    PassImage joined_;
};

}  // namespace plumbline::render
