// The images that a frame is drawn into, as large as memory lets them be.
#pragma once

#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/scene_target.h"
#include "engine/render/passes/screen/post_pass.h"
#include "engine/render/setup/image_plan.h"

#include <cstddef>
#include <optional>

namespace plumbline::render {

class FrameTargets {
public:
    /// Plans the frame's images and makes them; with less quality where the driver has no memory, which
    /// is remembered until the frame's size changes. Nothing: there is nothing to draw into.
    std::optional<ImagePlan> fit(const RenderFrame& frame,
                                 const Device& device,
                                 const assets::AssetLibrary& library);

    /// Makes the finished image what is drawn into: the renderer's own, or the window's.
    void bind_present() const;
    unsigned int present_framebuffer() const { return own_framebuffer_.name(); }
    const PixelSize& present_px() const { return present_px_; }
    SceneTarget& scene() { return scene_; }
    const SceneTarget& scene() const { return scene_; }
    PostPass& post() { return post_; }
    const PostPass& post() const { return post_; }
    std::size_t bytes() const {
        return color_.bytes() + depth_.bytes() + scene_.bytes() + post_.image_bytes();
    }

private:
    void resize_present(const ImagePlan& plan, const Device& device);
    Result<Done> resize_scene(const ImagePlan& plan, const Device& device);

    PixelSize present_px_;
    gl::Texture color_;  ///< off screen only
    gl::Texture depth_;
    gl::Framebuffer own_framebuffer_;
    SceneTarget scene_;
    PostPass post_;
    PixelSize asked_px_;   ///< the size for which memory was short
    int failed_tries_{0};  ///< see quality_in_force()
};

/// Without half floats light is kept as sRGB codes: white is the brightest.
gl::TargetFormat light_format(const GpuLimits& limits);

}  // namespace plumbline::render
