#include "engine/assets/image/image_import.h"

#include "engine/assets/image/image_codecs_impl.h"
#include "engine/core/io/files.h"
#include "engine/core/io/output.h"
#include "engine/core/limits.h"

#include <fmt/format.h>

namespace plumbline::assets {

Error ImageSource::refused(std::string_view why) const {
    return {.message = fmt::format("image {} is refused: {}", name, why),
            .exit_code = ExitCode::Refused};
}

Result<ImageData> ImageSource::image_of(std::uint64_t width,
                                        std::uint64_t height,
                                        PixelFormat format) const {
    const std::string fault = size_fault(width, height, format, allowed);
    if (!fault.empty()) return refused(fault);
    return blank_image(
        static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), format);
}

std::string size_fault(std::uint64_t width,
                       std::uint64_t height,
                       PixelFormat format,
                       const ImageBytesAllowed& allowed) {
    if (width == 0 || height == 0) return fmt::format("its size is {} x {}", width, height);
    if (width > limits::kImageSide || height > limits::kImageSide) {
        return fmt::format(
            "its size is {} x {}; a side has at most {} pixels", width, height, limits::kImageSide);
    }
    const std::uint64_t bytes = width * height * bytes_per_pixel(format);
    if (bytes > limits::kImageBytes) {
        return fmt::format(
            "decoded it takes {} bytes; at most {} are allowed", bytes, limits::kImageBytes);
    }
    if (!allowed(bytes)) {
        return fmt::format("it takes {} bytes; all images of a scene may take {}",
                           bytes,
                           limits::kSceneImageBytes);
    }
    return {};
}

ImageData blank_image(std::uint32_t width, std::uint32_t height, PixelFormat format) {
    ImageData image{.width = width, .height = height, .format = format, .bytes = {}};
    image.bytes.resize(std::size_t{width} * height * bytes_per_pixel(format));
    return image;
}

Result<std::string> read_image_file(const std::filesystem::path& file) {
    Result<std::string> bytes = read_file(file, limits::kImageBytes);
    if (!bytes) return Error{.message = bytes.error().message, .exit_code = ExitCode::Refused};
    return bytes;
}

Result<ImageData> import_image(const std::filesystem::path& file,
                               const ImageBytesAllowed& allowed) {
    const Result<std::string> bytes = read_image_file(file);
    if (!bytes) return bytes.error();
    return decode_image(*bytes, file.string(), allowed);
}

Result<ImageData> decode_image(std::string_view content,
                               const std::string& name,
                               const ImageBytesAllowed& allowed) {
    const ImageSource source{.bytes = content, .name = name, .allowed = allowed};
    if (content.starts_with("\x89PNG\r\n\x1a\n")) return decode_png(source);
    if (content.starts_with("\xff\xd8\xff")) return decode_jpeg(source);
    if (content.starts_with("\x76\x2f\x31\x01")) return decode_exr(source);
    if (looks_like_tga(content)) return decode_tga(source);
    return source.refused("its content is none of PNG, JPEG, OpenEXR and TGA");
}

Result<Done> write_png(const std::filesystem::path& file, const ImageData& image) {
    const Result<std::string> bytes = encode_png(image);
    if (!bytes) return bytes.error();
    return write_output(file, *bytes);
}

}  // namespace plumbline::assets
