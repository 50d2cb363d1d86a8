#include "engine/assets/image/image_codecs_impl.h"
#include "engine/core/limits.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <vector>

namespace plumbline::assets {
namespace {

// libpng leaves by longjmp. Every function below that a jump may leave or land in holds only
// trivial objects; what needs destruction lives in their callers.

constexpr std::size_t kMessageBytes = 128;
constexpr png_alloc_size_t kChunkBytes = 8 * 1024 * 1024;
constexpr png_uint_32 kChunksKept = 64;

struct PngProgress {
    const unsigned char* bytes;
    std::size_t size;
    std::size_t place;
    char message[kMessageBytes];
};

[[noreturn]] void keep_message_and_jump(png_structp png, png_const_charp message) {
    auto& progress = *static_cast<PngProgress*>(png_get_error_ptr(png));
    std::strncpy(progress.message, message, kMessageBytes - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

void read_bytes(png_structp png, png_bytep target, std::size_t count) {
    auto& progress = *static_cast<PngProgress*>(png_get_io_ptr(png));
    if (count > progress.size - progress.place) png_error(png, "it breaks off");
    std::memcpy(target, progress.bytes + progress.place, count);
    progress.place += count;
}

void append_bytes(png_structp png, png_bytep source, std::size_t count) {
    auto& target = *static_cast<std::string*>(png_get_io_ptr(png));
    bool appended = true;
    try {
        target.append(static_cast<const char*>(static_cast<const void*>(source)), count);
    } catch (...) {  // no exception may cross C code
        appended = false;
    }
    if (!appended) png_error(png, "out of memory");
}

void flush_nothing(png_structp /*png*/) {}

/// The two halves of a libpng reader; released together.
struct Reader {
    explicit Reader(PngProgress& progress)
        : png(png_create_read_struct(
              PNG_LIBPNG_VER_STRING, &progress, keep_message_and_jump, ignore_warning)) {
        if (png != nullptr) info = png_create_info_struct(png);
        if (info != nullptr) png_set_read_fn(png, &progress, read_bytes);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    png_structp png{nullptr};
    png_infop info{nullptr};
};

struct Writer {
    explicit Writer(PngProgress& progress)
        : png(png_create_write_struct(
              PNG_LIBPNG_VER_STRING, &progress, keep_message_and_jump, ignore_warning)) {
        if (png != nullptr) info = png_create_info_struct(png);
    }
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    png_structp png{nullptr};
    png_infop info{nullptr};
};

struct Header {
    png_uint_32 width;
    png_uint_32 height;
    int channels;
};

/// Reads up to the pixels and asks for 8-bit grey, RGB or RGBA rows.
bool read_header(png_structp png, png_infop info, Header& header) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    // Text and other extras are skipped unread: compressed ones may swell to gigabytes.
    png_set_chunk_malloc_max(png, kChunkBytes);
    png_set_chunk_cache_max(png, kChunksKept);
    // Names end in a zero each, as libpng wants them.
    static constexpr char kExtras[] = "tEXt\0zTXt\0iTXt\0iCCP\0eXIf";
    png_set_keep_unknown_chunks(png,
                                PNG_HANDLE_CHUNK_NEVER,
                                static_cast<png_const_bytep>(static_cast<const void*>(kExtras)),
                                static_cast<int>(sizeof(kExtras) / 5));
    png_set_user_limits(png, 0x7FFFFFFF, 0x7FFFFFFF);  // ours come later, with a message of ours
    png_read_info(png, info);
    const png_byte color = png_get_color_type(png, info);
    if (png_get_bit_depth(png, info) == 16) png_set_scale_16(png);
    if (color == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png);
    if (color == PNG_COLOR_TYPE_GRAY) png_set_expand_gray_1_2_4_to_8(png);
    if (png_get_valid(png, info, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png);
    const bool has_alpha = (static_cast<unsigned>(color) & PNG_COLOR_MASK_ALPHA) != 0 ||
                           png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    if (has_alpha && (static_cast<unsigned>(color) & PNG_COLOR_MASK_COLOR) == 0) {
        png_set_gray_to_rgb(png);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    header = {png_get_image_width(png, info),
              png_get_image_height(png, info),
              static_cast<int>(png_get_channels(png, info))};
    return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_image(png, rows);
    return true;
}

bool write_rows(png_structp png, png_infop info, const ImageData& image, png_bytepp rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    int color = PNG_COLOR_TYPE_RGBA;
    if (image.format == PixelFormat::R8) color = PNG_COLOR_TYPE_GRAY;
    if (image.format == PixelFormat::Rgb8) color = PNG_COLOR_TYPE_RGB;
    // Screenshots are written while somebody waits; level 4 is near level 6 in size.
    png_set_compression_level(png, 4);
    png_set_IHDR(png,
                 info,
                 image.width,
                 image.height,
                 8,
                 color,
                 PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_image(png, rows);
    png_write_end(png, info);
    return true;
}

std::vector<png_bytep> rows_of(ImageData& image) {
    std::vector<png_bytep> rows(image.height);
    const std::size_t row_bytes = std::size_t{image.width} * bytes_per_pixel(image.format);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = image.bytes.data() + y * row_bytes;
    return rows;
}

}  // namespace

Result<ImageData> decode_png(const ImageSource& source) {
    const std::string_view bytes = source.bytes;
    PngProgress progress{
        .bytes = static_cast<const unsigned char*>(static_cast<const void*>(bytes.data())),
        .size = bytes.size(),
        .place = 0,
        .message = {}};
    const Reader reader(progress);
    if (reader.info == nullptr) return source.refused("libpng did not start");
    Header header{};
    if (!read_header(reader.png, reader.info, header)) return source.refused(progress.message);
    PixelFormat format = PixelFormat::Rgba8;
    if (header.channels == 1) format = PixelFormat::R8;
    if (header.channels == 3) format = PixelFormat::Rgb8;
    Result<ImageData> image = source.image_of(header.width, header.height, format);
    if (!image) return image;
    std::vector<png_bytep> rows = rows_of(*image);
    if (!read_rows(reader.png, rows.data())) return source.refused(progress.message);
    return image;
}

Result<std::string> encode_png(const ImageData& image) {
    PL_ASSERT(!is_half_float(image.format), "8-bit pixels");
    PL_ASSERT(image.bytes.size() ==
                  std::size_t{image.width} * image.height * bytes_per_pixel(image.format),
              "tightly packed pixels");
    PngProgress progress{};
    const Writer writer(progress);
    if (writer.info == nullptr) return Error{.message = "libpng did not start"};
    std::string bytes;
    png_set_write_fn(writer.png, &bytes, append_bytes, flush_nothing);
    ImageData copy = image;  // libpng's rows are not const
    std::vector<png_bytep> rows = rows_of(copy);
    if (!write_rows(writer.png, writer.info, copy, rows.data())) {
        return Error{.message = std::string("cannot make a PNG: ") + progress.message};
    }
    return bytes;
}

}  // namespace plumbline::assets
