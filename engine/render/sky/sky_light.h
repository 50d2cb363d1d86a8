// Light from a sky cube map, as nine coefficients of spherical harmonics. No GL.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/math.h"
#include "engine/render/shader_blocks.h"

#include <array>
#include <span>
#include <vector>

namespace plumbline::render {

/// Linear radiance, rows from the top.
struct RadianceImage {
    std::uint32_t width{0};
    std::uint32_t height{0};
    std::vector<Vec3f> pixels;
};

/// 8-bit images are decoded from sRGB. With `block` > 1, each pixel is the average of a square of
/// that many pixels each way; what is left at the right and lower edges is cut.
RadianceImage radiance_of(const assets::ImageData& image, std::uint32_t block = 1);

/// A quarter of the pixels, averaged; odd edges are cut.
RadianceImage halved(const RadianceImage& image);

/// Another size, each new pixel interpolated between the four around it.
RadianceImage resized(const RadianceImage& image, std::uint32_t side);

/// Half floats, for upload.
assets::ImageData half_floats_of(const RadianceImage& image);

/// The world direction of a point of a face; u and v from 0 to 1, v down. OpenGL's table, faces in
/// the order +x -x +y -y +z -z.
Vec3f cube_direction(std::size_t face, float u, float v);

using SkyCoefficients = std::array<Vec3f, kSkyCoefficients>;

/// Radiance in real spherical harmonics up to order 2.
SkyCoefficients project_sky(std::span<const RadianceImage> faces);

/// The geometric mean of the luminance above the horizon: a few very bright spots hardly matter.
float typical_radiance(std::span<const RadianceImage> faces);

/// What a matt white surface facing `normal` sends out, under this sky alone.
Vec3f diffuse_light(const SkyCoefficients& sky, const Vec3f& normal);

}  // namespace plumbline::render
