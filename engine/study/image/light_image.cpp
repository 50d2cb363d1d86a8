#include "engine/study/image/light_image.h"

#include "engine/core/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumbline::study {
namespace {

std::array<float, 256> light_by_code() {
    std::array<float, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) {
        light[i] = linear_from_srgb(static_cast<float>(i) / 255.0F);
    }
    return light;
}

std::uint8_t code_of(float light) {
    return static_cast<std::uint8_t>(
        std::lround(srgb_from_linear(std::clamp(light, 0.0F, 1.0F)) * 255.0F));
}

}  // namespace

float light_of_code(std::uint8_t code) {
    static const std::array<float, 256> kLight = light_by_code();
    return kLight[code];
}

LightImage light_of(const assets::ImageData& codes) {
    LightImage image{.width_px = codes.width, .height_px = codes.height, .light = {}};
    const std::size_t step = assets::bytes_per_pixel(codes.format);
    for (std::size_t i = 0; i + step <= codes.bytes.size(); i += step) {
        image.light.emplace_back(light_of_code(codes.bytes[i]),
                                 light_of_code(codes.bytes[i + 1]),
                                 light_of_code(codes.bytes[i + 2]));
    }
    return image;
}

assets::ImageData codes_of(const LightImage& image) {
    assets::ImageData codes{.width = image.width_px,
                            .height = image.height_px,
                            .format = assets::PixelFormat::Rgb8,
                            .bytes = {}};
    for (const Vec3f& light : image.light) {
        for (int channel = 0; channel < 3; ++channel)
            codes.bytes.push_back(code_of(light[channel]));
    }
    return codes;
}

double mean_luminance(const LightImage& image) {
    double sum = 0;
    for (const Vec3f& light : image.light) sum += static_cast<double>(luminance(light));
    return sum / static_cast<double>(std::max<std::size_t>(image.light.size(), 1));
}

ImageError image_error(const LightImage& image, const LightImage& reference) {
    const double scale = std::max(mean_luminance(reference), 1e-9);
    const auto count = static_cast<double>(reference.light.size());
    ImageError error;
    for (std::size_t i = 0; i < reference.light.size(); ++i) {
        const auto off =
            static_cast<double>(luminance(glm::abs(image.light[i] - reference.light[i])));
        error.mean += off / count;
        error.rms += off * off / count;
    }
    error.mean /= scale;
    error.rms = std::sqrt(error.rms) / scale;
    return error;
}

}  // namespace plumbline::study
