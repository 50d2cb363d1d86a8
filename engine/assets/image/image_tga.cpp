#include "engine/assets/byte_reader.h"
#include "engine/assets/image/image_codecs_impl.h"

#include <array>
#include <optional>

namespace plumbline::assets {
namespace {

constexpr std::uint8_t kPackedTga = 8;  // beside the kind
constexpr std::uint8_t kTrueColor = 2;
constexpr std::uint8_t kGreyTga = 3;
constexpr std::uint8_t kFromRight = 0x10;
constexpr std::uint8_t kFromTop = 0x20;

struct TgaHeader {
    std::uint8_t id_bytes{0};
    std::uint8_t kind{0};
    std::uint16_t width{0};
    std::uint16_t height{0};
    std::uint8_t bits{0};
    std::uint8_t order{0};

    std::optional<PixelFormat> format() const {
        const unsigned plain = kind & ~unsigned{kPackedTga};
        if (plain == kGreyTga && bits == 8) return PixelFormat::R8;
        if (plain == kTrueColor && bits == 24) return PixelFormat::Rgb8;
        if (plain == kTrueColor && bits == 32) return PixelFormat::Rgba8;
        return std::nullopt;
    }
};

TgaHeader tga_header_of(ByteReader& reader) {
    TgaHeader header;
    header.id_bytes = reader.number<std::uint8_t>();
    const bool has_palette = reader.number<std::uint8_t>() != 0;
    header.kind = reader.number<std::uint8_t>();
    if (has_palette) header.kind = 0;
    reader.take(9);
    header.width = reader.number<std::uint16_t>();
    header.height = reader.number<std::uint16_t>();
    header.bits = reader.number<std::uint8_t>();
    header.order = reader.number<std::uint8_t>();
    return header;
}

/// TgaPixels in the order of the file, runs of equal ones unpacked.
class TgaPixels {
public:
    TgaPixels(ByteReader& reader, bool packed, std::size_t bytes)
        : reader_(reader), packed_(packed), bytes_(bytes) {}

    std::string_view next() {
        if (!packed_) return reader_.take(bytes_);
        if (left_ == 0) {
            const auto packet = reader_.number<std::uint8_t>();
            left_ = (packet & 0x7FU) + 1;
            repeats_ = (packet & 0x80U) != 0;
            if (repeats_) pixel_ = reader_.take(bytes_);
        }
        --left_;
        return repeats_ ? pixel_ : reader_.take(bytes_);
    }

private:
    ByteReader& reader_;
    bool packed_;
    std::size_t bytes_;
    unsigned left_{0};
    bool repeats_{false};
    std::string_view pixel_;
};

}  // namespace

bool looks_like_tga(std::string_view bytes) {
    ByteReader reader(bytes);
    return tga_header_of(reader).format().has_value() && !reader.failed();
}

Result<ImageData> decode_tga(const ImageSource& source) {
    ByteReader reader(source.bytes);
    const TgaHeader header = tga_header_of(reader);
    const std::optional<PixelFormat> format = header.format();
    if (!format) return source.refused("its header is none of a TGA that is read");
    const std::string fault = size_fault(header.width, header.height, *format, source.allowed);
    if (!fault.empty()) return source.refused(fault);
    const std::size_t width = bytes_per_pixel(*format);
    const std::size_t count = std::size_t{header.width} * header.height;
    const bool packed = (header.kind & kPackedTga) != 0;
    reader.take(header.id_bytes);
    // A packet of 128 equal pixels is a byte and the pixel.
    if (reader.left() < (packed ? count / 128 : count) * width) {
        return source.refused("it breaks off");
    }
    ImageData image = blank_image(header.width, header.height, *format);
    TgaPixels pixels(reader, packed, width);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view pixel = pixels.next();
        if (pixel.size() < width) return source.refused("it breaks off");
        std::size_t x = i % header.width;
        std::size_t y = i / header.width;
        if ((header.order & kFromRight) != 0) x = header.width - 1 - x;
        if ((header.order & kFromTop) == 0) y = header.height - 1 - y;
        std::uint8_t* to = image.bytes.data() + (y * header.width + x) * width;
        // Blue comes first; alpha and grey stay where they are.
        const std::array<std::size_t, 4> places{width >= 3 ? 2U : 0U, 1, width >= 3 ? 0U : 2U, 3};
        for (std::size_t k = 0; k < width; ++k) {
            to[places[k]] = static_cast<std::uint8_t>(pixel[k]);
        }
    }
    return image;
}

}  // namespace plumbline::assets
