// Images in linear light, and the error between two.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/math.h"
#include "engine/study/findings/image_findings.h"

#include <cstdint>
#include <vector>

namespace plumbline::study {

/// Linear light, 1 is what the screen shows at most; rows from the top.
struct LightImage {
    std::uint32_t width_px{0};
    std::uint32_t height_px{0};
    std::vector<Vec3f> light;

    const Vec3f& at(std::uint32_t x, std::uint32_t y) const {
        return light[std::size_t{y} * width_px + x];
    }
};

/// Of an sRGB code, by the standard's curve (IEC 61966-2-1).
float light_of_code(std::uint8_t code);
/// `codes`: Rgb8 or Rgba8, sRGB.
LightImage light_of(const assets::ImageData& codes);
/// Rgb8, sRGB: for looking at.
assets::ImageData codes_of(const LightImage& image);
/// Of all pixels, by the eye's weights of the colours (Rec. 709).
double mean_luminance(const LightImage& image);

/// Both of one size, not empty.
ImageError image_error(const LightImage& image, const LightImage& reference);

}  // namespace plumbline::study
