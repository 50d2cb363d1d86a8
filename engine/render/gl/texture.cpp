#include "engine/render/gl/texture.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <future>
#include <vector>

namespace plumbline::render::gl {
namespace {

struct GlFormat {
    GLenum internal;
    GLenum format;
    GLenum type;
    std::size_t bytes_per_pixel;
};

// By PixelFormat. Colour images are plain 8-bit, not GL_SRGB8: the shader decodes after filtering.
// Software GL filters plain bytes in a fast path of its own; decoding each of eight samples costs more
// than the whole rest of the lookup.
constexpr std::array<GlFormat, 5> kPixelFormats{
    {{GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1},
     {GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 4},
     {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
     // Half the memory of half floats, and no bands in a clear sky: nine bits a colour.
     {GL_RGB9_E5, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV, 4},
     {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8}}};
static_assert(assets::PixelFormat::Rgba16F == assets::PixelFormat{kPixelFormats.size() - 1});

// By TargetFormat.
constexpr std::array<GlFormat, 6> kTargetFormats{
    {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
     {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
     {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8},
     {GL_RG16F, GL_RG, GL_HALF_FLOAT, 4},
     {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4},
     {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4}}};

const GlFormat& format_of(TargetFormat format) {
    return kTargetFormats[static_cast<std::size_t>(format)];
}

// By Filter.
constexpr std::array<GLint, 4> kMinFilters{
    GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR};

// No shader reads from this unit: filling a new image takes none away from those that are drawn with.
constexpr GLenum kFillUnit = GL_TEXTURE31;

void set_parameters(GLenum target, Filter filter, GLint wrap) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, kMinFilters[static_cast<std::size_t>(filter)]);
    glTexParameteri(
        target, GL_TEXTURE_MAG_FILTER, filter == Filter::Nearest ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
    glTexParameteri(target, GL_TEXTURE_WRAP_R, wrap);
}

float from_half(std::uint16_t half) {
    // The exponent's bias differs by 112. Negative light is none.
    const float scaled = std::bit_cast<float>((half & 0x7FFFU) << 13U);
    return (half & 0x8000U) != 0 ? 0.0F : scaled * 0x1p112F;
}

/// Three nine-bit parts and the exponent that they share, as GL_RGB9_E5 defines it.
std::uint32_t shared_exponent(float red, float green, float blue) {
    constexpr float kLargest = 65408.0F;  // 511/512 * 2^16
    constexpr int kBias = 15;
    constexpr int kPartBits = 9;
    const auto part = [&](float light) { return light > 0.0F ? std::min(light, kLargest) : 0.0F; };
    const float r = part(red);
    const float g = part(green);
    const float b = part(blue);
    const float most = std::max({r, g, b});
    const int log2 = static_cast<int>(std::bit_cast<std::uint32_t>(most) >> 23U) - 127;
    int exponent = std::max(log2, -kBias - 1) + 1 + kBias;
    const auto steps_in_one = [](int e) {
        const int power = 127 - (e - kBias - kPartBits);
        return std::bit_cast<float>(static_cast<std::uint32_t>(power) << 23U);
    };
    if (most * steps_in_one(exponent) + 0.5F >= 512.0F) ++exponent;
    const float steps = steps_in_one(exponent);
    const auto rounded = [&](float light) {
        return static_cast<std::uint32_t>(light * steps + 0.5F);
    };
    return rounded(r) | rounded(g) << 9U | rounded(b) << 18U |
           static_cast<std::uint32_t>(exponent) << 27U;
}

/// Packed here and not by the driver, whose thread is the only one that may upload.
assets::ImageData packed(const assets::ImageData& image) {
    if (image.format != assets::PixelFormat::Rgb16F) return image;
    assets::ImageData out{
        .width = image.width, .height = image.height, .format = image.format, .bytes = {}};
    const std::size_t count = std::size_t{image.width} * image.height;
    out.bytes.resize(count * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < count; ++i) {
        std::array<std::uint16_t, 3> half{};
        std::memcpy(half.data(), image.bytes.data() + i * sizeof(half), sizeof(half));
        const std::uint32_t texel =
            shared_exponent(from_half(half[0]), from_half(half[1]), from_half(half[2]));
        std::memcpy(out.bytes.data() + i * sizeof(texel), &texel, sizeof(texel));
    }
    return out;
}

/// Half floats must have been packed.
std::size_t upload_level(GLenum target, GLint level, const assets::ImageData& image) {
    const GlFormat& format = kPixelFormats[static_cast<std::size_t>(image.format)];
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(target,
                 level,
                 static_cast<GLint>(format.internal),
                 static_cast<GLsizei>(image.width),
                 static_cast<GLsizei>(image.height),
                 0,
                 format.format,
                 format.type,
                 image.bytes.data());
    return std::size_t{image.width} * image.height * format.bytes_per_pixel;
}

}  // namespace

std::size_t bytes_per_pixel(TargetFormat format) {
    return format_of(format).bytes_per_pixel;
}

Texture::Texture(unsigned int target, std::uint32_t width, std::uint32_t height)
    : object_(new_texture()), kind_(target), width_(width), height_(height) {
    glActiveTexture(kFillUnit);
    glBindTexture(target, object_.name());
}

Texture Texture::target(TargetFormat format,
                        std::uint32_t width,
                        std::uint32_t height,
                        Filter filter) {
    const GlFormat& gl_format = format_of(format);
    Texture texture(GL_TEXTURE_2D, width, height);
    texture.bytes_ = std::size_t{width} * height * gl_format.bytes_per_pixel;
    set_parameters(GL_TEXTURE_2D, filter, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    const bool compares = gl_format.format == GL_DEPTH_COMPONENT && filter == Filter::Linear;
    if (compares) {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    glTexImage2D(GL_TEXTURE_2D,
                 0,
                 static_cast<GLint>(gl_format.internal),
                 static_cast<GLsizei>(width),
                 static_cast<GLsizei>(height),
                 0,
                 gl_format.format,
                 gl_format.type,
                 nullptr);
    return texture;
}

Texture Texture::multisampled(TargetFormat format,
                              std::uint32_t width,
                              std::uint32_t height,
                              std::uint32_t samples) {
    const GlFormat& gl_format = format_of(format);
    GLint most = 1;
    glGetIntegerv(gl_format.format == GL_DEPTH_COMPONENT ? GL_MAX_DEPTH_TEXTURE_SAMPLES
                                                         : GL_MAX_COLOR_TEXTURE_SAMPLES,
                  &most);
    Texture texture(GL_TEXTURE_2D_MULTISAMPLE, width, height);
    texture.samples_ = std::min(samples, static_cast<std::uint32_t>(std::max(most, 1)));
    texture.bytes_ = std::size_t{width} * height * gl_format.bytes_per_pixel * texture.samples_;
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE,
                            static_cast<GLsizei>(texture.samples_),
                            gl_format.internal,
                            static_cast<GLsizei>(width),
                            static_cast<GLsizei>(height),
                            GL_TRUE);
    return texture;
}

Texture Texture::tiling(std::span<const assets::ImageData* const> levels, Filter filter) {
    Texture texture(GL_TEXTURE_2D, levels.front()->width, levels.front()->height);
    set_parameters(GL_TEXTURE_2D, filter, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    if (levels.front()->format == assets::PixelFormat::R8) {  // grey, not red
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_RED);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_B, GL_RED);
    }
    for (std::size_t level = 0; level < levels.size(); ++level) {
        texture.bytes_ += upload_level(GL_TEXTURE_2D, static_cast<GLint>(level), *levels[level]);
    }
    return texture;
}

Texture Texture::cube(std::span<const assets::ImageData> faces, std::uint32_t levels) {
    Texture texture(GL_TEXTURE_CUBE_MAP, faces.front().width, faces.front().height);
    set_parameters(
        GL_TEXTURE_CUBE_MAP, levels > 1 ? Filter::Trilinear : Filter::Linear, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels) - 1);
    std::vector<std::future<assets::ImageData>> under_way;
    for (const assets::ImageData& face : faces) {
        under_way.push_back(std::async(std::launch::async | std::launch::deferred,
                                       [&face] { return packed(face); }));
    }
    for (std::uint32_t i = 0; i < levels * 6; ++i) {
        texture.bytes_ += upload_level(
            GL_TEXTURE_CUBE_MAP_POSITIVE_X + i % 6, static_cast<GLint>(i / 6), under_way[i].get());
    }
    return texture;
}

Texture Texture::volume(const std::array<std::uint32_t, 3>& counts, std::span<const Vec4f> texels) {
    Texture texture(GL_TEXTURE_3D, counts[0], counts[1]);
    texture.bytes_ = texels.size() * 4 * sizeof(std::uint16_t);
    set_parameters(GL_TEXTURE_3D, Filter::Linear, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexImage3D(GL_TEXTURE_3D,
                 0,
                 GL_RGBA16F,
                 static_cast<GLsizei>(counts[0]),
                 static_cast<GLsizei>(counts[1]),
                 static_cast<GLsizei>(counts[2]),
                 0,
                 GL_RGBA,
                 GL_FLOAT,
                 texels.data());
    return texture;
}

void bind_texture(unsigned int unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(texture.kind(), texture.name());
}

}  // namespace plumbline::render::gl
