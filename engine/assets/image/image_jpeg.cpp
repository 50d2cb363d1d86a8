#include "engine/assets/image/image_codecs_impl.h"

#include <jerror.h>
#include <jpeglib.h>

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE
#include <cstring>

namespace plumbline::assets {
namespace {

// libjpeg is left by longjmp. decode_rows holds only trivial objects between setjmp and a jump;
// what needs destruction lives in decode_jpeg.

/// A file of a few kilobytes can hold thousands of passes over a large image.
constexpr int kMaxScans = 200;

struct JpegProgress {
    jpeg_error_mgr errors;  // first: libjpeg hands back a pointer to it
    jpeg_progress_mgr watch;
    std::jmp_buf on_error;
    char message[JMSG_LENGTH_MAX];
    bool breaks_off;
};

JpegProgress& progress_of(j_common_ptr jpeg) {
    return *static_cast<JpegProgress*>(jpeg->client_data);
}

[[noreturn]] void keep_message_and_jump(j_common_ptr jpeg) {
    JpegProgress& progress = progress_of(jpeg);
    jpeg->err->format_message(jpeg, progress.message);
    std::longjmp(progress.on_error, 1);
}

void note_warning(j_common_ptr jpeg, int level) {
    if (level >= 0) return;  // a trace
    const int code = jpeg->err->msg_code;
    if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER) progress_of(jpeg).breaks_off = true;
}

void print_nothing(j_common_ptr /*jpeg*/) {}

void count_scans(j_common_ptr jpeg) {
    auto* decoder = static_cast<jpeg_decompress_struct*>(static_cast<void*>(jpeg));
    if (decoder->input_scan_number > kMaxScans) {
        std::strcpy(progress_of(jpeg).message, "it has too many scans");
        std::longjmp(progress_of(jpeg).on_error, 1);
    }
}

bool read_header(jpeg_decompress_struct& jpeg, JpegProgress& progress, std::string_view bytes) {
    if (setjmp(progress.on_error) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg.client_data = &progress;
    jpeg.progress = &progress.watch;
    jpeg_mem_src(&jpeg,
                 static_cast<const unsigned char*>(static_cast<const void*>(bytes.data())),
                 bytes.size());
    jpeg_read_header(&jpeg, TRUE);
    if (jpeg.num_components == 4) {
        jpeg.out_color_space = JCS_CMYK;
    } else if (jpeg.num_components == 1) {
        jpeg.out_color_space = JCS_GRAYSCALE;
    } else {
        jpeg.out_color_space = JCS_RGB;
    }
    return true;
}

bool decode_rows(jpeg_decompress_struct& jpeg,
                 JpegProgress& progress,
                 unsigned char* pixels,
                 std::size_t row_bytes) {
    if (setjmp(progress.on_error) != 0) return false;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW row = pixels + row_bytes * jpeg.output_scanline;
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

/// Four bytes a pixel, stored inverted as Adobe's programs write them, to three.
ImageData rgb_from_cmyk(const ImageData& cmyk, bool inverted) {
    ImageData rgb = blank_image(cmyk.width, cmyk.height, PixelFormat::Rgb8);
    const std::size_t pixels = std::size_t{cmyk.width} * cmyk.height;
    for (std::size_t i = 0; i < pixels; ++i) {
        const auto light = [&](std::size_t channel) {
            const unsigned value = cmyk.bytes[i * 4 + channel];
            return inverted ? value : 255U - value;
        };
        for (std::size_t channel = 0; channel < 3; ++channel) {
            rgb.bytes[i * 3 + channel] =
                static_cast<std::uint8_t>((light(channel) * light(3) + 127U) / 255U);
        }
    }
    return rgb;
}

/// Releases what libjpeg holds, however decoding ends.
struct JpegDecoder {
    jpeg_decompress_struct jpeg{};
    JpegDecoder() = default;
    ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
};

}  // namespace

Result<ImageData> decode_jpeg(const ImageSource& source) {
    JpegProgress progress{};
    JpegDecoder decoder;
    jpeg_decompress_struct& jpeg = decoder.jpeg;
    jpeg.err = jpeg_std_error(&progress.errors);
    jpeg.client_data = &progress;
    progress.errors.error_exit = keep_message_and_jump;
    progress.errors.emit_message = note_warning;
    progress.errors.output_message = print_nothing;
    progress.watch.progress_monitor = count_scans;
    if (!read_header(jpeg, progress, source.bytes)) return source.refused(progress.message);

    PixelFormat format = PixelFormat::Rgb8;
    if (jpeg.num_components == 1) format = PixelFormat::R8;
    if (jpeg.num_components == 4) format = PixelFormat::Rgba8;  // for a moment: C, M, Y, K
    Result<ImageData> image = source.image_of(jpeg.image_width, jpeg.image_height, format);
    if (!image) return image;
    const std::size_t row_bytes = std::size_t{image->width} * bytes_per_pixel(format);
    if (!decode_rows(jpeg, progress, image->bytes.data(), row_bytes)) {
        return source.refused(progress.message);
    }
    if (progress.breaks_off) return source.refused("it breaks off");
    if (format == PixelFormat::Rgba8) return rgb_from_cmyk(*image, jpeg.saw_Adobe_marker != FALSE);
    return image;
}

}  // namespace plumbline::assets
