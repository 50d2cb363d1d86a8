// From the scene's light to the finished image: bloom, tone map and sRGB, smooth edges, scaling
// up. Each step has its images only while a frame asks for it; without any there is one pass, from
// the scene's image straight to the screen, or none where the renderer's own target encodes.
#pragma once

#include "engine/render/passes/pass_context.h"
#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_target.h"
#include "engine/render/passes/screen/pass_image.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::render {

class PostPass {
public:
    /// Makes the images that the steps need and frees those that none does. The error: no memory.
    Result<Done> resize(const ImagePlan& plan);
    std::size_t bloom_bytes() const;
    std::size_t image_bytes() const { return toned_.image.bytes() + smooth_.image.bytes(); }

    void render_bloom(const SceneLight& light, PassContext context);
    /// All steps after bloom; the last one draws into `present_framebuffer`.
    void render_image(const SceneLight& light,
                      const gl::Texture& depth,
                      const ImagePlan& plan,
                      unsigned int present_framebuffer,
                      PassContext context) const;

private:
    bool resize_bloom(const ImagePlan& plan);

    std::vector<PassImage> bloom_levels_;  ///< from half the scene's size down
    PassImage toned_;   ///< the image before its edges are smoothed; only with FXAA
    PassImage smooth_;  ///< the image before it is scaled up; only when it is
};

}  // namespace plumbline::render
