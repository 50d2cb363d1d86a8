// Image files made in code.
#pragma once

#include "engine/assets/image/image_import.h"
#include "tests/engine/assets/fixture.h"

#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::assets::test {

inline Result<ImageData> import_image_bytes(std::string_view bytes, const char* name = "i.png") {
    const TempFolder folder;
    return import_image(folder.write(name, bytes));
}

inline void append_big_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes += static_cast<char>(static_cast<std::uint8_t>(value >> shift));
    }
}

/// A PNG put together chunk by chunk, so that its header can say anything.
class PngFile {
public:
    PngFile(std::uint32_t width, std::uint32_t height, int depth, int color, int interlaced = 0) {
        std::string header;
        append_big_u32(header, width);
        append_big_u32(header, height);
        header += static_cast<char>(depth);
        header += static_cast<char>(color);
        header += std::string(2, '\0') + static_cast<char>(interlaced);
        chunk("IHDR", header);
    }
    PngFile& chunk(const std::string& name, const std::string& content) {
        append_big_u32(bytes_, static_cast<std::uint32_t>(content.size()));
        const std::string body = name + content;
        bytes_ += body;
        append_big_u32(
            bytes_,
            static_cast<std::uint32_t>(crc32(
                0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
        return *this;
    }
    PngFile& pixels(const std::string& rows) { return chunk("IDAT", deflated(rows)); }
    std::string done() { return chunk("IEND", "").bytes_; }

    static std::string deflated(const std::string& plain) {
        uLongf size = compressBound(plain.size());
        std::string packed(size, '\0');
        compress2(reinterpret_cast<Bytef*>(packed.data()),
                  &size,
                  reinterpret_cast<const Bytef*>(plain.data()),
                  plain.size(),
                  9);
        packed.resize(size);
        return packed;
    }

private:
    std::string bytes_{"\x89PNG\r\n\x1a\n"};
};

using Bytes = std::vector<std::uint8_t>;

}  // namespace plumbline::assets::test
