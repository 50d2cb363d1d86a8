// From the scene's light to the finished image: bloom, tone map and sRGB, smooth edges, scaling
// up. Each step has its images only while a frame asks for it; without any there is one pass, from
// the scene's image straight to the screen, or none where the renderer's own target encodes.
#pragma once

#include "engine/render/passes/scene_light.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/scene_target.h"
#include "engine/render/passes/screen/pass_image.h"
#include "engine/render/passes/sky_pass.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::render {

struct PostView {
    PixelSize scene_px;    ///< the scene's image
    PixelSize image_px;    ///< after its samples became pixels
    PixelSize present_px;  ///< the finished image
    bool bloom{false};
    bool tone_curve{false};
    bool fxaa{false};
    std::uint32_t samples{1};  ///< of a pixel of the scene's image
    bool keeps_depth{false};   ///< lines will be drawn over the image
    bool adds_light{false};    ///< passes read the scene's light before it is encoded

    bool is_scaled() const { return image_px != present_px; }
    bool has_samples() const { return scene_px != image_px; }
    /// Light has to be encoded, nothing else.
    bool has_no_steps() const {
        return !bloom && !tone_curve && !fxaa && !is_scaled() && !has_samples() && samples == 1 &&
               !adds_light;
    }
};

class PostPass {
public:
    /// Makes the images that the steps need and frees those that none does. The error: no memory.
    Result<Done> resize(const PostView& view);
    std::size_t bloom_bytes() const;
    std::size_t image_bytes() const { return toned_.image.bytes() + smooth_.image.bytes(); }

    void render_bloom(const SceneLight& light,
                      const FullscreenTriangle& triangle,
                      SceneResources& resources,
                      FrameStats& stats);
    /// All steps after bloom; the last one draws into `present_framebuffer`.
    void render_image(const SceneLight& light,
                      const gl::Texture& depth,
                      const PostView& view,
                      unsigned int present_framebuffer,
                      const FullscreenTriangle& triangle,
                      SceneResources& resources,
                      FrameStats& stats) const;

private:
    bool resize_bloom(const PostView& view);

    std::vector<PassImage> bloom_levels_;  ///< from half the scene's size down
    PassImage toned_;   ///< the image before its edges are smoothed; only with FXAA
    PassImage smooth_;  ///< the image before it is scaled up; only when it is
};

}  // namespace plumbline::render
