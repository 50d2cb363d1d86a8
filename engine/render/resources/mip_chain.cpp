#include "engine/render/resources/mip_chain.h"

#include "engine/core/assert.h"
#include "engine/core/color.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace plumbline::render {
namespace {

using assets::ImageData;
using assets::PixelFormat;

constexpr std::size_t kLightSteps = 4096;

/// Light of a code value, 0 to kLightSteps - 1.
std::array<std::uint16_t, 256> make_light_from_code() {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) {
        const double c = static_cast<double>(code) / 255.0;
        table[code] =
            static_cast<std::uint16_t>(std::lround(linear_from_srgb(c) * (kLightSteps - 1)));
    }
    return table;
}

std::array<std::uint8_t, kLightSteps> make_code_from_light() {
    std::array<std::uint8_t, kLightSteps> table{};
    for (std::size_t step = 0; step < table.size(); ++step) {
        const double light = static_cast<double>(step) / (kLightSteps - 1);
        table[step] = static_cast<std::uint8_t>(std::lround(srgb_from_linear(light) * 255.0));
    }
    return table;
}

/// The four pixels that one pixel of the next level covers; at odd edges some repeat.
struct Corners {
    const std::uint8_t* a;
    const std::uint8_t* b;
    const std::uint8_t* c;
    const std::uint8_t* d;
};

template <class Average>
ImageData halved(const ImageData& image, Average&& average) {
    ImageData half{.width = std::max(image.width / 2, 1U),
                   .height = std::max(image.height / 2, 1U),
                   .format = image.format,
                   .bytes = {}};
    const std::size_t channels = assets::bytes_per_pixel(image.format);
    half.bytes.resize(std::size_t{half.width} * half.height * channels);
    const std::size_t row = image.width * channels;
    const std::size_t right = image.width > 1 ? channels : 0;
    const std::size_t below = image.height > 1 ? row : 0;
    std::uint8_t* out = half.bytes.data();
    for (std::uint32_t y = 0; y < half.height; ++y) {
        const std::uint8_t* in = image.bytes.data() + std::size_t{y} * 2 * row;
        for (std::uint32_t x = 0; x < half.width; ++x) {
            average(Corners{in, in + right, in + below, in + below + right}, out);
            in += 2 * channels;
            out += channels;
        }
    }
    return half;
}

std::uint8_t mean(unsigned int a, unsigned int b, unsigned int c, unsigned int d) {
    return static_cast<std::uint8_t>((a + b + c + d + 2U) / 4U);
}

ImageData halved_data(const ImageData& image) {
    const std::size_t channels = assets::bytes_per_pixel(image.format);
    return halved(image, [channels](const Corners& in, std::uint8_t* out) {
        for (std::size_t i = 0; i < channels; ++i) {
            out[i] = mean(in.a[i], in.b[i], in.c[i], in.d[i]);
        }
    });
}

ImageData halved_color(const ImageData& image) {
    static const std::array<std::uint16_t, 256> light = make_light_from_code();
    static const std::array<std::uint8_t, kLightSteps> code = make_code_from_light();
    const std::size_t channels = assets::bytes_per_pixel(image.format);
    const std::size_t colors = channels == 1 ? 1 : 3;
    return halved(image, [=](const Corners& in, std::uint8_t* out) {
        for (std::size_t i = 0; i < colors; ++i) {
            const unsigned int sum = static_cast<unsigned int>(light[in.a[i]]) + light[in.b[i]] +
                                     light[in.c[i]] + light[in.d[i]];
            out[i] = code[(sum + 2U) / 4U];
        }
        if (channels == 4) out[3] = mean(in.a[3], in.b[3], in.c[3], in.d[3]);
    });
}

using AlphaCounts = std::array<std::size_t, 256>;

AlphaCounts alpha_counts(const ImageData& image) {
    AlphaCounts counts{};
    for (std::size_t i = 3; i < image.bytes.size(); i += 4) ++counts[image.bytes[i]];
    return counts;
}

/// The share of pixels whose alpha is at least `threshold`.
double coverage(const AlphaCounts& counts, std::size_t pixels, int threshold) {
    std::size_t passing = 0;
    for (std::size_t alpha = static_cast<std::size_t>(threshold); alpha < 256; ++alpha) {
        passing += counts[alpha];
    }
    return static_cast<double>(passing) / static_cast<double>(pixels);
}

void restore_coverage(ImageData& level, double wanted, int cutoff) {
    const AlphaCounts counts = alpha_counts(level);
    const std::size_t pixels = std::size_t{level.width} * level.height;
    // The highest threshold at which this level covers at least as much as the full image does;
    // scaling alpha moves that threshold to the cutoff.
    int threshold = 1;
    while (threshold < 255 && coverage(counts, pixels, threshold + 1) >= wanted) ++threshold;
    const double scale = static_cast<double>(cutoff) / threshold;
    for (std::size_t i = 3; i < level.bytes.size(); i += 4) {
        level.bytes[i] =
            static_cast<std::uint8_t>(std::min(std::lround(level.bytes[i] * scale + 1e-6), 255L));
    }
}

constexpr std::uint16_t kHalfOfOne = 0x3C00;  // positive half floats are ordered as their codes are

/// The 8-bit code of each half float from 0 to 1.
std::vector<std::uint8_t> make_code_from_half(MipContent content) {
    std::vector<std::uint8_t> table;
    for (std::uint16_t half = 0; half <= kHalfOfOne; ++half) {
        const auto value = static_cast<double>(glm::unpackHalf1x16(half));
        const double code = content == MipContent::Color ? srgb_from_linear(value) : value;
        table.push_back(static_cast<std::uint8_t>(std::lround(code * 255.0)));
    }
    return table;
}

}  // namespace

std::shared_ptr<const ImageData> in_bytes(std::shared_ptr<const ImageData> image,
                                          MipContent content) {
    if (!assets::is_half_float(image->format)) return image;
    const std::vector<std::uint8_t> code = make_code_from_half(content);
    const auto code_of = [&](std::uint16_t half) { return code[std::min(half, kHalfOfOne)]; };
    const bool has_alpha = image->format == PixelFormat::Rgba16F;
    auto out = std::make_shared<ImageData>(
        ImageData{.width = image->width,
                  .height = image->height,
                  .format = has_alpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8,
                  .bytes = {}});
    const std::size_t pixel_bytes = assets::bytes_per_pixel(image->format);
    out->bytes.reserve(image->bytes.size() / 2);
    for (std::size_t at = 0; at < image->bytes.size(); at += pixel_bytes) {
        std::array<std::uint16_t, 4> pixel{0, 0, 0, kHalfOfOne};
        std::memcpy(pixel.data(), image->bytes.data() + at, pixel_bytes);
        const float alpha = glm::unpackHalf1x16(pixel[3]);
        for (std::size_t i = 0; i < 3; ++i) {
            const float whole = glm::unpackHalf1x16(pixel[i]) / alpha;
            out->bytes.push_back(
                code_of(alpha > 0.0F && alpha < 1.0F ? glm::packHalf1x16(whole) : pixel[i]));
        }
        if (has_alpha) {
            const long opacity = std::lround(std::min(alpha, 1.0F) * 255.0F);
            out->bytes.push_back(static_cast<std::uint8_t>(opacity));
        }
    }
    return out;
}

std::vector<ImageData> mip_chain(const ImageData& image, MipContent content, float alpha_cutoff) {
    PL_ASSERT(!assets::is_half_float(image.format), "an 8-bit image");
    std::vector<ImageData> levels;
    for (const ImageData* above = &image; above->width > 1 || above->height > 1;
         above = &levels.back()) {
        levels.push_back(content == MipContent::Color ? halved_color(*above) : halved_data(*above));
    }
    if (alpha_cutoff <= 0.0F || image.format != PixelFormat::Rgba8) return levels;
    const int cutoff = std::clamp(static_cast<int>(std::lround(alpha_cutoff * 255.0F)), 1, 255);
    const double wanted =
        coverage(alpha_counts(image), std::size_t{image.width} * image.height, cutoff);
    for (ImageData& level : levels) restore_coverage(level, wanted, cutoff);
    return levels;
}

}  // namespace plumbline::render
