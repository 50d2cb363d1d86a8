// What the passes of the scene draw into: one image of linear light with depth, of any size.
#pragma once

#include "engine/core/math.h"
#include "engine/core/result.h"
#include "engine/render/gl/framebuffer.h"
#include "engine/render/gl/texture.h"
#include "engine/render/setup/image_plan.h"

#include <cstddef>
#include <cstdint>

namespace plumbline::render {

class SceneTarget {
public:
    /// Makes the images for that size; nothing if they are there. The error: out of memory.
    Result<Done> resize(const PixelSize& size_px, gl::TargetFormat light, std::uint32_t samples);
    /// Bytes that images of that size hold.
    static std::size_t bytes_for(const PixelSize& size_px,
                                 gl::TargetFormat light,
                                 std::uint32_t samples);

    /// Makes it what is drawn into, all of it.
    void bind() const;
    /// Makes the light alone what is drawn into, so that depth() can be read meanwhile.
    void bind_light();
    /// What was drawn becomes color() and depth(), where a pixel has several samples.
    void resolve() const;
    /// Light and depth of what was drawn into another one of the same size, from the first to the
    /// last pixel; this one has one sample a pixel. Afterwards neither is what is drawn into.
    void copy(const SceneTarget& from, const Vec2f& first_px, const Vec2f& last_px) const;
    /// Of a pixel; fewer than asked for where the driver has no more.
    std::uint32_t samples() const { return samples_framebuffer_ ? color_samples_.samples() : 1; }
    const gl::Texture& color() const { return color_; }
    const gl::Texture& depth() const { return depth_; }
    std::size_t bytes() const {
        return color_.bytes() + depth_.bytes() + color_samples_.bytes() + depth_samples_.bytes();
    }

private:
    void resolve(unsigned int buffers) const;

    gl::Texture color_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture color_samples_;
    gl::Texture depth_samples_;
    gl::Framebuffer samples_framebuffer_;
    gl::Framebuffer light_framebuffer_;  ///< without depth; made when asked for
    std::uint32_t asked_samples_{1};
};

}  // namespace plumbline::render
