#include "engine/assets/image/image_codecs_impl.h"

#include <ImathBox.h>
#include <ImfArray.h>
#include <ImfIO.h>
#include <ImfRgbaFile.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>

namespace plumbline::assets {
namespace {

/// OpenEXR reads through this, so that only checked regular files are ever opened.
class ExrStream final : public Imf::IStream {
public:
    ExrStream(std::string_view bytes, const std::string& name)
        : Imf::IStream(name.c_str()), bytes_(bytes) {}

    bool read(char target[], int count) override {
        const auto wanted = static_cast<std::uint64_t>(count);
        if (count < 0 || wanted > bytes_.size() - place_) throw std::runtime_error("it breaks off");
        std::memcpy(target, bytes_.data() + place_, static_cast<std::size_t>(wanted));
        place_ += wanted;
        return place_ < bytes_.size();
    }
    std::uint64_t tellg() override { return place_; }
    void seekg(std::uint64_t place) override {
        if (place > bytes_.size()) throw std::runtime_error("it breaks off");
        place_ = place;
    }
    void clear() override {}

private:
    std::string_view bytes_;
    std::uint64_t place_{0};
};

/// Light is never negative; compressors ring below zero at bright edges.
Imath::half clamped(Imath::half value) {
    if (value.isNan() || value.isNegative()) return Imath::half(0.0F);
    if (value.isInfinity()) return Imath::half(HALF_MAX);
    return value;
}

Result<ImageData> decode(const ImageSource& source) {
    ExrStream stream(source.bytes, source.name);
    Imf::RgbaInputFile file(stream, 1);
    const Imath::Box2i window = file.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width < 1 || height < 1) return source.refused("its data window is empty");
    const bool has_alpha = (file.channels() & Imf::WRITE_A) != 0;
    const PixelFormat format = has_alpha ? PixelFormat::Rgba16F : PixelFormat::Rgb16F;
    Result<ImageData> image = source.image_of(
        static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), format);
    if (!image) return image;
    const std::size_t pixel_bytes = bytes_per_pixel(format);
    // A band of rows at a time: the decoder's pixels are wider than ours.
    constexpr std::int64_t kBandRows = 64;
    const auto columns = static_cast<std::size_t>(width);
    std::vector<Imf::Rgba> band(columns * kBandRows);
    std::uint8_t* target = image->bytes.data();
    for (std::int64_t row = 0; row < height; row += kBandRows) {
        const std::int64_t count = std::min(kBandRows, height - row);
        const std::int64_t first_y = window.min.y + row;
        // OpenEXR addresses pixels by their absolute coordinates.
        const std::ptrdiff_t origin = -std::ptrdiff_t{window.min.x} - first_y * width;
        file.setFrameBuffer(band.data() + origin, 1, columns);
        file.readPixels(static_cast<int>(first_y), static_cast<int>(first_y + count - 1));
        for (std::size_t i = 0; i < static_cast<std::size_t>(count) * columns; ++i) {
            const Imath::half rgba[4]{
                clamped(band[i].r), clamped(band[i].g), clamped(band[i].b), clamped(band[i].a)};
            std::memcpy(target, static_cast<const void*>(rgba), pixel_bytes);
            target += pixel_bytes;
        }
    }
    return image;
}

}  // namespace

Result<ImageData> decode_exr(const ImageSource& source) {
    try {
        return decode(source);
    } catch (const std::exception& fault) {
        return source.refused(fault.what());
    }
}

}  // namespace plumbline::assets
