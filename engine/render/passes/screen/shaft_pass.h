// Which share of the sun's light the air sends to each place of the image.
#pragma once

#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/pair_blur.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/setup/frame_setup.h"

#include <cstddef>

namespace plumbline::render {

class ShaftPass {
public:
    /// A quarter as wide and as high as `depth`: the share, and metres along the line of sight. Null:
    /// the driver has no memory for it. `sun_shadow_map` is null without shadows.
    const gl::Texture* render(const FrameSetup& setup,
                              const gl::Texture& depth,
                              const gl::Texture* sun_shadow_map,
                              const FullscreenTriangle& triangle,
                              SceneResources& resources,
                              FrameStats& stats);
    std::size_t bytes() const { return images_.bytes(); }
    void free() { images_ = {}; }

private:
    PairImages images_;
};

}  // namespace plumbline::render
