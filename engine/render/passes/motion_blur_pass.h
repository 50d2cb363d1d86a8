// The scene as a shutter sees it that stays open while the camera moves.
#pragma once

#include "engine/render/passes/pass_image.h"
#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/sky_pass.h"

#include <cstddef>

namespace plumbline::render {

class MotionBlurPass {
public:
    /// As large as the scene's image. `clip_before_from_world`: as the shutter opened. Null: the
    /// driver has no memory for it.
    const gl::Texture* render(const MotionBlur& blur,
                              const Mat4f& clip_before_from_world,
                              const SceneLight& light,
                              const FullscreenTriangle& triangle,
                              SceneResources& resources,
                              FrameStats& stats);
    std::size_t bytes() const { return blurred_.image.bytes(); }
    void free() { *this = {}; }

private:
    PassImage blurred_;
};

}  // namespace plumbline::render
