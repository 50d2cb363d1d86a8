// The scene as a shutter sees it that stays open while the camera moves.
#pragma once

#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/screen/motion_vectors.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/passes/sky_pass.h"
#include "engine/render/setup/frame_setup.h"

#include <cstddef>

namespace plumbline::render {

class MotionBlurPass {
public:
    /// As large as the scene's image. Null: the driver has no memory for it.
    const gl::Texture* render(const FrameSetup& setup,
                              const SceneLight& light,
                              const FullscreenTriangle& triangle,
                              SceneResources& resources,
                              FrameStats& stats);
    std::size_t bytes() const { return blurred_.image.bytes() + motion_vectors_.bytes(); }
    void free() { *this = {}; }

private:
    PassImage blurred_;
    MotionVectors motion_vectors_;
};

}  // namespace plumbline::render
