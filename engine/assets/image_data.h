// Pixels on the CPU.
#pragma once

#include <cstdint>
#include <vector>

namespace plumbline::assets {

enum class PixelFormat : std::uint8_t { R8, Rgb8, Rgba8, Rgb16F };

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
    }
    return 4;
}

}  // namespace plumbline::assets
