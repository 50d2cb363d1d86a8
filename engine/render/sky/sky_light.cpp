#include "engine/render/sky/sky_light.h"

#include "engine/core/color.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace plumbline::render {
namespace {

using Basis = std::array<float, kSkyCoefficients>;

/// Real spherical harmonics, orthonormal over the sphere; order 1, y z x, xy yz 3z2-1 xz x2-y2.
Basis basis_at(const Vec3f& d) {
    return {0.282095F,
            0.488603F * d.y,
            0.488603F * d.z,
            0.488603F * d.x,
            1.092548F * d.x * d.y,
            1.092548F * d.y * d.z,
            0.315392F * (3.0F * d.z * d.z - 1.0F),
            1.092548F * d.x * d.z,
            0.546274F * (d.x * d.x - d.y * d.y)};
}

float linear_from_code(std::uint8_t code) {
    return linear_from_srgb(static_cast<float>(code) / 255.0F);
}

float component(const assets::ImageData& image, std::size_t pixel, std::size_t channel) {
    const std::size_t at = pixel * assets::bytes_per_pixel(image.format);
    if (assets::is_half_float(image.format)) {
        std::uint16_t half = 0;
        std::memcpy(&half, image.bytes.data() + at + channel * 2, sizeof(half));
        return glm::unpackHalf1x16(half);
    }
    const bool gray = image.format == assets::PixelFormat::R8;
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < 256; ++i) {
            table[i] = linear_from_code(static_cast<std::uint8_t>(i));
        }
        return table;
    }();
    return linear[image.bytes[at + (gray ? 0 : channel)]];
}

/// Calls fn(direction, radiance, weight); weights are as the solid angles that pixels cover.
template <class Fn>
void for_each_pixel(std::span<const RadianceImage> faces, Fn&& fn) {
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const RadianceImage& image = faces[face];
        const auto width = static_cast<float>(image.width);
        const auto height = static_cast<float>(image.height);
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const float u = (static_cast<float>(x) + 0.5F) / width;
                const float v = (static_cast<float>(y) + 0.5F) / height;
                // A pixel's solid angle falls with the cube of its distance from the centre.
                const float s = 2.0F * u - 1.0F;
                const float t = 2.0F * v - 1.0F;
                const float weight = std::pow(1.0F + s * s + t * t, -1.5F) / (width * height);
                fn(cube_direction(face, u, v),
                   image.pixels[std::size_t{y} * image.width + x],
                   weight);
            }
        }
    }
}

}  // namespace

RadianceImage radiance_of(const assets::ImageData& image, std::uint32_t block) {
    RadianceImage radiance{
        .width = image.width / block, .height = image.height / block, .pixels = {}};
    radiance.pixels.reserve(std::size_t{radiance.width} * radiance.height);
    const float share = 1.0F / static_cast<float>(block * block);
    for (std::uint32_t y = 0; y < radiance.height; ++y) {
        for (std::uint32_t x = 0; x < radiance.width; ++x) {
            Vec3f sum{0.0F};
            for (std::uint32_t i = 0; i < block * block; ++i) {
                const std::size_t pixel =
                    std::size_t{y * block + i / block} * image.width + x * block + i % block;
                sum += Vec3f{component(image, pixel, 0),
                             component(image, pixel, 1),
                             component(image, pixel, 2)};
            }
            radiance.pixels.push_back(sum * share);
        }
    }
    return radiance;
}

RadianceImage halved(const RadianceImage& image) {
    RadianceImage half{.width = std::max(image.width / 2, 1U),
                       .height = std::max(image.height / 2, 1U),
                       .pixels = {}};
    half.pixels.reserve(std::size_t{half.width} * half.height);
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
        return image.pixels[std::size_t{std::min(y, image.height - 1)} * image.width +
                            std::min(x, image.width - 1)];
    };
    for (std::uint32_t y = 0; y < half.height; ++y) {
        for (std::uint32_t x = 0; x < half.width; ++x) {
            half.pixels.push_back((at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) +
                                   at(2 * x + 1, 2 * y + 1)) *
                                  0.25F);
        }
    }
    return half;
}

RadianceImage resized(const RadianceImage& image, std::uint32_t side) {
    RadianceImage result{.width = side, .height = side, .pixels = {}};
    result.pixels.reserve(std::size_t{side} * side);
    const auto place = [side](std::uint32_t i, std::uint32_t source_side) {
        const float at = (static_cast<float>(i) + 0.5F) * static_cast<float>(source_side) /
                             static_cast<float>(side) -
                         0.5F;
        return glm::clamp(at, 0.0F, static_cast<float>(source_side - 1));
    };
    for (std::uint32_t y = 0; y < side; ++y) {
        const float v = place(y, image.height);
        const auto top = static_cast<std::uint32_t>(v);
        const auto bottom = std::min(top + 1, image.height - 1);
        for (std::uint32_t x = 0; x < side; ++x) {
            const float u = place(x, image.width);
            const auto left = static_cast<std::uint32_t>(u);
            const auto right = std::min(left + 1, image.width - 1);
            const auto row = [&](std::uint32_t line) {
                const Vec3f* pixels = image.pixels.data() + std::size_t{line} * image.width;
                return glm::mix(pixels[left], pixels[right], u - static_cast<float>(left));
            };
            result.pixels.push_back(glm::mix(row(top), row(bottom), v - static_cast<float>(top)));
        }
    }
    return result;
}

assets::ImageData half_floats_of(const RadianceImage& image) {
    assets::ImageData packed{.width = image.width,
                             .height = image.height,
                             .format = assets::PixelFormat::Rgb16F,
                             .bytes = {}};
    packed.bytes.resize(image.pixels.size() * 6);
    std::size_t at = 0;
    for (const Vec3f& pixel : image.pixels) {
        for (int channel = 0; channel < 3; ++channel) {
            const std::uint16_t half = glm::packHalf1x16(pixel[channel]);
            std::memcpy(packed.bytes.data() + at, &half, sizeof(half));
            at += sizeof(half);
        }
    }
    return packed;
}

Vec3f cube_direction(std::size_t face, float u, float v) {
    const float s = 2.0F * u - 1.0F;
    const float t = 2.0F * v - 1.0F;
    switch (face) {
        case 0:
            return glm::normalize(Vec3f{1.0F, -t, -s});
        case 1:
            return glm::normalize(Vec3f{-1.0F, -t, s});
        case 2:
            return glm::normalize(Vec3f{s, 1.0F, t});
        case 3:
            return glm::normalize(Vec3f{s, -1.0F, -t});
        case 4:
            return glm::normalize(Vec3f{s, -t, 1.0F});
        default:
            return glm::normalize(Vec3f{-s, -t, -1.0F});
    }
}

SkyCoefficients project_sky(std::span<const RadianceImage> faces) {
    SkyCoefficients sky{};
    float total_weight = 0.0F;
    for_each_pixel(faces, [&](const Vec3f& direction, const Vec3f& radiance, float weight) {
        const Basis basis = basis_at(direction);
        for (std::size_t i = 0; i < kSkyCoefficients; ++i) sky[i] += radiance * (weight * basis[i]);
        total_weight += weight;
    });
    const float scale = 4.0F * glm::pi<float>() / total_weight;
    for (Vec3f& coefficient : sky) coefficient *= scale;
    return sky;
}

float typical_radiance(std::span<const RadianceImage> faces) {
    float log_sum = 0.0F;
    float total_weight = 0.0F;
    for_each_pixel(faces, [&](const Vec3f& direction, const Vec3f& radiance, float weight) {
        if (direction.y < 0.0F) return;
        log_sum += std::log(std::max(luminance(radiance), 1e-6F)) * weight;
        total_weight += weight;
    });
    return std::exp(log_sum / total_weight);
}

Vec3f diffuse_light(const SkyCoefficients& sky, const Vec3f& normal) {
    // Convolution with the cosine lobe, over pi: 1, 2/3 and 1/4 for orders 0, 1 and 2
    // (Ramamoorthi and Hanrahan 2001).
    const Basis basis = basis_at(normal);
    Vec3f light = sky[0] * basis[0];
    for (std::size_t i = 1; i < 4; ++i) light += sky[i] * basis[i] * (2.0F / 3.0F);
    for (std::size_t i = 4; i < kSkyCoefficients; ++i) light += sky[i] * basis[i] * 0.25F;
    return light;
}

}  // namespace plumbline::render
