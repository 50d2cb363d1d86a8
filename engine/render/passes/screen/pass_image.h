// An image that a pass draws into.
#pragma once

#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/passes/scene_target.h"

namespace plumbline::render {

struct PassImage {
    gl::Texture image;
    gl::Framebuffer framebuffer;

    PixelSize size_px() const { return {image.width(), image.height()}; }
    /// Makes it anew where it has another size. False: no memory.
    bool resize(gl::TargetFormat format, const PixelSize& size_px);
    /// Makes it what is drawn into, all of it.
    void bind() const;
};

}  // namespace plumbline::render
