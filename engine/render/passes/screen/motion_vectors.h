// Which way things moved across the image while the shutter was open.
#pragma once

#include "engine/render/gl/framebuffer.h"
#include "engine/render/passes/pass_context.h"
#include "engine/render/resources/gpu_meshes.h"

#include <cstddef>
#include <vector>

namespace plumbline::render {

struct ShutterView {
    Mat4f clip_from_world{1.0F};
    Mat4f clip_before_from_world{1.0F};  ///< as the shutter opened
};

class MotionVectors {
public:
    /// Of each pixel the way in pixels of what was there, as shaders/velocity.frag says; no less than
    /// `depth`'s things hide. Null: nothing moved in sight, or the driver has no memory for it.
    const gl::Texture* render(const MotionBlur& blur,
                              const ShutterView& view,
                              const gl::Texture& depth,
                              PassContext context);
    std::size_t bytes() const { return image_.bytes(); }

private:
    struct Seen {
        const MovedMesh* moved{nullptr};
        DrawRun run;
    };
    /// Fills seen_ and instances_.
    void find_seen(const MotionBlur& blur,
                   const ShutterView& view,
                   const Vec2f& size_px,
                   const assets::AssetLibrary& library);
    bool make_image(const gl::Texture& depth);

    gl::Texture image_;
    gl::Framebuffer framebuffer_;  ///< with the scene's depth, of this frame
    std::vector<Seen> seen_;
    std::vector<Instance> instances_;
    InstanceStream moments_;
};

}  // namespace plumbline::render
