// PNG, JPEG and OpenEXR to ImageData; ImageData to PNG.
#pragma once

#include "engine/assets/image_data.h"
#include "engine/core/result.h"

#include <filesystem>

namespace plumbline::assets {

/// The kind is told by the content, not the name. 8-bit files become R8, Rgb8 or Rgba8 (16-bit,
/// palette and CMYK are converted); EXR becomes Rgb16F, negatives and non-finite values clamped.
Result<ImageData> import_image(const std::filesystem::path& file);

/// R8, Rgb8 or Rgba8; written atomically.
Result<Done> write_png(const std::filesystem::path& file, const ImageData& image);

}  // namespace plumbline::assets
