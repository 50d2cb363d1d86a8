// Which share of the light from everywhere reaches each place of the image, from its depth image.
#pragma once

#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/pair_blur.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/setup/frame_setup.h"

#include <cstddef>

namespace plumbline::render {

class OcclusionPass {
public:
    /// Half as wide and as high as `depth`: visibility 0â¦1, and metres along the line of sight. Null:
    /// the driver has no memory for it.
    const gl::Texture* render(const FrameSetup& setup,
                              const gl::Texture& depth,
                              const FullscreenTriangle& triangle,
                              SceneResources& resources,
                              FrameStats& stats);
    std::size_t bytes() const { return images_.bytes(); }
    void free() { images_ = {}; }

private:
    PairImages images_;
};

}  // namespace plumbline::render
