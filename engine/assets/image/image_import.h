// PNG, JPEG, OpenEXR and TGA to ImageData; ImageData to PNG.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/result.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// Asked after the header is read, with the bytes that the pixels will take: false refuses them.
using ImageBytesAllowed = std::function<bool(std::size_t bytes)>;
inline bool any_image_bytes(std::size_t /*bytes*/) {
    return true;
}

/// The kind is told by the content, not the name. 8-bit files become R8, Rgb8 or Rgba8 (16-bit,
/// palette and CMYK are converted); EXR becomes Rgb16F, or Rgba16F where it has
/// alpha, negatives and non-finite values clamped.
Result<ImageData> import_image(const std::filesystem::path& file,
                               const ImageBytesAllowed& allowed = any_image_bytes);
/// The same for bytes that are there already; `name` is for messages.
Result<ImageData> decode_image(std::string_view content,
                               const std::string& name,
                               const ImageBytesAllowed& allowed = any_image_bytes);
/// The bytes for that. The error is for what is no regular file, or too large.
Result<std::string> read_image_file(const std::filesystem::path& file);

/// R8, Rgb8 or Rgba8, to where write_output takes it.
Result<Done> write_png(const std::filesystem::path& file, const ImageData& image);

}  // namespace plumbline::assets
