// Images on the GPU. Each says how many bytes it holds, by format and mip count (the driver may
// round up).
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/math.h"
#include "engine/render/gl/object.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace plumbline::render::gl {

/// Srgb8: light that is drawn into it while GL_FRAMEBUFFER_SRGB is on becomes codes; else as Rgba8.
enum class TargetFormat { Rgba8, Srgb8, HdrColor, Pair16F, Depth24, Depth32F };
enum class Filter { Nearest, Linear, LinearMipNearest, Trilinear };

/// What an image of that format holds for one pixel.
std::size_t bytes_per_pixel(TargetFormat format);

class Texture {
public:
    Texture() = default;

    /// Storage to draw into; clamps at the edges. Depth formats compare when sampled with
    /// Filter::Linear (hardware percentage-closer filtering) and read plainly with Nearest.
    static Texture target(TargetFormat format,
                          std::uint32_t width,
                          std::uint32_t height,
                          Filter filter);
    /// Storage with several samples a pixel, to draw into and to resolve; at most as many samples as the
    /// driver has.
    static Texture multisampled(TargetFormat format,
                                std::uint32_t width,
                                std::uint32_t height,
                                std::uint32_t samples);
    /// A tiling image from its mip levels, largest first.
    static Texture tiling(std::span<const assets::ImageData* const> levels, Filter filter);
    /// Six faces in the order +x -x +y -y +z -z; level after level when `levels` > 1.
    static Texture cube(std::span<const assets::ImageData> faces, std::uint32_t levels);

    /// Half floats at the points of a grid, x fastest, blended between them; clamps at the sides.
    static Texture volume(const std::array<std::uint32_t, 3>& counts,
                          std::span<const Vec4f> texels);

    unsigned int name() const { return object_.name(); }
    /// GL_TEXTURE_2D, or where else GL binds it.
    unsigned int kind() const { return kind_; }
    explicit operator bool() const { return static_cast<bool>(object_); }
    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }
    std::uint32_t samples() const { return samples_; }
    std::size_t bytes() const { return bytes_; }

private:
    /// Bound to be filled. `target`: of GL.
    Texture(unsigned int target, std::uint32_t width, std::uint32_t height);

    TextureObject object_;
    unsigned int kind_{0};
    std::uint32_t width_{0};
    std::uint32_t height_{0};
    std::uint32_t samples_{1};
    std::size_t bytes_{0};
};

void bind_texture(unsigned int unit, const Texture& texture);

}  // namespace plumbline::render::gl
