// From HDR radiance to the screen: bloom and tone map. Exists only while a frame asks for bloom;
// without bloom the shaders of the passes before write the finished picture themselves.
#pragma once

#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/scene_resources.h"
#include "engine/render/passes/sky_pass.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plumbline::render {

class PostPass {
public:
    /// Makes the images for that size; nothing if they are there. The error: out of memory.
    Result<Done> resize(std::uint32_t width_px, std::uint32_t height_px);
    void free();

    bool ready() const { return static_cast<bool>(hdr_framebuffer_); }
    /// What opaque, sky and translucent draw into.
    const gl::Framebuffer& hdr_framebuffer() const { return hdr_framebuffer_; }
    std::size_t bytes() const;

    void render_bloom(const FullscreenTriangle& triangle,
                      SceneResources& resources,
                      FrameStats& stats);
    /// Into the framebuffer that is bound. `features` may hold kBloom and kKeepDepth.
    void render_tone_map(const FullscreenTriangle& triangle,
                         FeatureSet features,
                         SceneResources& resources,
                         FrameStats& stats) const;

private:
    struct Level {
        gl::Texture image;
        gl::Framebuffer framebuffer;
    };

    gl::Texture hdr_image_;
    gl::Texture depth_image_;
    gl::Framebuffer hdr_framebuffer_;
    std::vector<Level> bloom_levels_;
};

}  // namespace plumbline::render
