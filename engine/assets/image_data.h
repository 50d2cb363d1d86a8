// Pixels on the CPU.
#pragma once

#include <cstdint>
#include <vector>

namespace plumbline::assets {

/// Half floats hold linear light; in Rgba16F it is multiplied by alpha already, as OpenEXR stores it.
enum class PixelFormat : std::uint8_t { R8, Rgb8, Rgba8, Rgb16F, Rgba16F };

inline bool is_half_float(PixelFormat format) {
    return format == PixelFormat::Rgb16F || format == PixelFormat::Rgba16F;
}

/// Rows from the top, tightly packed.
struct ImageData {
    std::uint32_t width{0};
    std::uint32_t height{0};
    PixelFormat format{PixelFormat::Rgba8};
    std::vector<std::uint8_t> bytes;
};

inline std::uint32_t bytes_per_pixel(PixelFormat format) {
    switch (format) {
        case PixelFormat::R8:
            return 1;
        case PixelFormat::Rgb8:
            return 3;
        case PixelFormat::Rgba8:
            return 4;
        case PixelFormat::Rgb16F:
            return 6;
        case PixelFormat::Rgba16F:
            return 8;
    }
    return 4;
}

}  // namespace plumbline::assets
