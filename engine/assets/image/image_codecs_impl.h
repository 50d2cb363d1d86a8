// The image decoders behind import_image. Private to engine/assets.
#pragma once

#include "engine/assets/image/image_import.h"
#include "engine/assets/image_data.h"
#include "engine/core/result.h"

#include <string>
#include <string_view>

namespace plumbline::assets {

/// What is decoded.
struct ImageSource {
    std::string_view bytes;
    const std::string& name;  ///< for messages
    const ImageBytesAllowed& allowed;

    /// "image NAME is refused: WHY".
    Error refused(std::string_view why) const;
    /// An image of that size, with room for its pixels, if it may be decoded.
    Result<ImageData> image_of(std::uint64_t width, std::uint64_t height, PixelFormat format) const;
};

/// Each looks at the header, checks it, and only then decodes.
Result<ImageData> decode_png(const ImageSource& source);
Result<ImageData> decode_jpeg(const ImageSource& source);
Result<ImageData> decode_exr(const ImageSource& source);
Result<ImageData> decode_tga(const ImageSource& source);
/// By its header: a TGA has no sign of its own.
bool looks_like_tga(std::string_view bytes);

/// The PNG file's bytes.
Result<std::string> encode_png(const ImageData& image);

/// Empty when an image of that size may be decoded.
std::string size_fault(std::uint64_t width,
                       std::uint64_t height,
                       PixelFormat format,
                       const ImageBytesAllowed& allowed);
/// Sets up `image` with room for its pixels.
ImageData blank_image(std::uint32_t width, std::uint32_t height, PixelFormat format);

}  // namespace plumbline::assets
