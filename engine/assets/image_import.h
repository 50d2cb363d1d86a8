// PNG, JPEG and OpenEXR to ImageData; ImageData to PNG.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline::assets {

/// The kind is told by the content, not the name. 8-bit files become R8, Rgb8 or Rgba8 (16-bit,
/// palette and CMYK are converted); EXR becomes Rgb16F, negatives and non-finite values clamped.
Result<ImageData> import_image(const std::filesystem::path& file);
/// The same for bytes that are there already; `name` is for messages.
Result<ImageData> decode_image(std::string_view content, const std::string& name);

/// R8, Rgb8 or Rgba8; written atomically.
Result<Done> write_png(const std::filesystem::path& file, const ImageData& image);

}  // namespace plumbline::assets
