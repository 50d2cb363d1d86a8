// Images: written and read back, converted, and refused before they are decoded.

#include "engine/assets/image/image_import.h"

#include "engine/assets/asset_library.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

#include <ImfHeader.h>
#include <ImfRgbaFile.h>
#include <jpeglib.h>
#include <png.h>
#include <zlib.h>

#include <cmath>
#include <limits>

namespace plumbline::assets::test {
namespace {

Result<ImageData> import_image_bytes(std::string_view bytes, const char* name = "i.png") {
    const TempFolder folder;
    return import_image(folder.write(name, bytes));
}

void append_big_u32(std::string& bytes, std::uint32_t value) {
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

/// 256 MiB decoded, in a file of 32 kB.
std::string largest_grey_png() {
    constexpr std::uint32_t kSide = limits::kImageSide;
    return PngFile(kSide, kSide, 1, 0)
        .pixels(std::string(std::size_t{kSide} * (kSide / 8 + 1), '\0'))
        .done();
}

// EXPERIENCE G19
TEST(SceneImages, take_a_gibibyte_and_no_byte_more) {
    const TempFolder folder;
    const std::string large = largest_grey_png();
    ASSERT_LT(large.size(), 50'000U);
    static_assert(limits::kSceneImageBytes == 4 * limits::kImageBytes);
    AssetLibrary library;
    for (const char* name : {"0.png", "1.png", "2.png"})
        EXPECT_EQ(library.take_image(folder.write(name, large))->width, limits::kImageSide);
    library.take_image(folder.path() / "2.png");  // counts once, however often
    library.take_image(folder.write("broken.png", large.substr(0, large.size() / 2)));
    EXPECT_EQ(library.take_image(folder.write("3.png", large))->width, limits::kImageSide);
    const fs::path one_more = folder.write("4.png", PngFile(1, 1, 8, 0).pixels({0, 1}).done());
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(library.take_image(one_more)->width, 64U) << "the checkerboard";
    const std::string log = ::testing::internal::GetCapturedStderr();
    EXPECT_TRUE(contains(log,
                         "4.png is refused: it takes 1 bytes; all images of a scene may take "
                         "1073741824; a checkerboard is shown instead"))
        << log;
}

TEST(PngImport, gives_back_what_was_written_in_every_format) {
    const TempFolder folder;
    for (const PixelFormat format : {PixelFormat::R8, PixelFormat::Rgb8, PixelFormat::Rgba8}) {
        ImageData image{.width = 5, .height = 3, .format = format, .bytes = {}};
        for (std::size_t i = 0; i < 15 * bytes_per_pixel(format); ++i) {
            image.bytes.push_back(static_cast<std::uint8_t>(i * 37));
        }
        const fs::path file = folder.path() / "written.png";
        ASSERT_TRUE(write_png(file, image).ok());
        const Result<ImageData> read = import_image(file);
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(read->width, 5U);
        EXPECT_EQ(read->height, 3U);
        EXPECT_EQ(read->format, format);
        EXPECT_EQ(read->bytes, image.bytes);
    }
}

TEST(PngImport, reports_a_folder_that_cannot_be_written) {
    const ImageData image{.width = 1, .height = 1, .format = PixelFormat::R8, .bytes = {0}};
    EXPECT_FALSE(write_png("/proc/nowhere/a.png", image).ok());
}

TEST(PngImport, converts_16_bit_palette_small_grey_and_grey_with_alpha) {
    const auto wide = import_image_bytes(
        PngFile(1, 1, 16, 2).pixels(std::string("\0\xFF\xFF\x80\x80\0\0", 7)).done());
    ASSERT_TRUE(wide.ok()) << wide.error().message;
    EXPECT_EQ(wide->format, PixelFormat::Rgb8);
    EXPECT_EQ(wide->bytes, (Bytes{255, 128, 0}));

    const auto palette = import_image_bytes(PngFile(2, 1, 8, 3)
                                                .chunk("PLTE", std::string("\1\2\3\4\5\6", 6))
                                                .pixels(std::string("\0\1\0", 3))
                                                .done());
    ASSERT_TRUE(palette.ok()) << palette.error().message;
    EXPECT_EQ(palette->format, PixelFormat::Rgb8);
    EXPECT_EQ(palette->bytes, (Bytes{4, 5, 6, 1, 2, 3}));

    const auto bits =
        import_image_bytes(PngFile(8, 1, 1, 0).pixels(std::string("\0\xA0", 2)).done());
    ASSERT_TRUE(bits.ok()) << bits.error().message;
    EXPECT_EQ(bits->format, PixelFormat::R8);
    EXPECT_EQ(bits->bytes, (Bytes{255, 0, 255, 0, 0, 0, 0, 0}));

    const auto grey =
        import_image_bytes(PngFile(1, 1, 8, 4).pixels(std::string("\0\7\x9", 3)).done());
    ASSERT_TRUE(grey.ok()) << grey.error().message;
    EXPECT_EQ(grey->format, PixelFormat::Rgba8);
    EXPECT_EQ(grey->bytes, (Bytes{7, 7, 7, 9}));
}

TEST(PngImport, reads_interlaced_rows) {
    // 2 x 2 grey in Adam7: pass 1 has pixel (0,0), pass 6 (1,0), pass 7 the second row.
    const auto image =
        import_image_bytes(PngFile(2, 2, 8, 0, 1).pixels(std::string("\0\1\0\2\0\3\4", 7)).done());
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->bytes, (Bytes{1, 2, 3, 4}));
}

TEST(PngImport, looks_at_the_header_before_it_decodes) {
    const auto error = [](std::uint32_t width, std::uint32_t height) {
        const auto image = import_image_bytes(PngFile(width, height, 8, 6).pixels("").done());
        return image.ok() ? std::string("read") : image.error().message;
    };
    EXPECT_TRUE(contains(error(65'535, 65'535),
                         "its size is 65535 x 65535; a side has at most 16384 pixels"));
    EXPECT_TRUE(contains(error(limits::kImageSide + 1, 1), "a side has at most 16384 pixels"));
    EXPECT_TRUE(contains(error(16'384, 4'097), "decoded it takes 268500992 bytes"));
    // At the limits the header passes and the missing pixels are what is wrong.
    EXPECT_FALSE(contains(error(limits::kImageSide, 1), "at most")) << error(16'384, 1);
}

TEST(PngImport, skips_text_that_would_swell) {
    const std::string bomb =
        std::string("Comment\0\0", 9) + PngFile::deflated(std::string(64 << 20, 'x'));
    const auto image = import_image_bytes(
        PngFile(1, 1, 8, 0).chunk("zTXt", bomb).pixels(std::string("\0\5", 2)).done());
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->bytes, Bytes{5});
}

TEST(PngImport, refuses_files_that_break_off_and_foreign_content) {
    const std::string good = PngFile(64, 64, 8, 0).pixels(std::string(65 * 64, '\0')).done();
    for (std::size_t size = 0; size + 12 < good.size(); size += 3) {
        EXPECT_FALSE(import_image_bytes(good.substr(0, size)).ok()) << size;
    }
    const auto text = import_image_bytes("hello");
    ASSERT_FALSE(text.ok());
    EXPECT_TRUE(
        contains(text.error().message, "its content is none of PNG, JPEG, OpenEXR and TGA"));
    EXPECT_EQ(text.error().exit_code, ExitCode::Refused);
    EXPECT_FALSE(import_image("/dev/zero").ok());
    EXPECT_FALSE(import_image("/tmp").ok());
}

/// A TGA header: kind 2 true colour, 3 grey, 8 more where runs are packed; order 0x20 from the top.
std::string tga_header(int kind, int width, int height, int bits, int order) {
    std::string bytes(18, '\0');
    bytes[2] = static_cast<char>(kind);
    bytes[12] = static_cast<char>(width);
    bytes[14] = static_cast<char>(height);
    bytes[16] = static_cast<char>(bits);
    bytes[17] = static_cast<char>(order);
    return bytes;
}

TEST(TgaImport, reads_rows_from_either_end_and_blue_first) {
    // Two pixels: red below or left, half-seen blue above or right.
    const std::string red("\0\0\xFF\xFF", 4);
    const std::string blue("\xFF\0\0\x80", 4);
    const Bytes from_above{0, 0, 255, 128, 255, 0, 0, 255};
    const auto up = import_image_bytes(tga_header(2, 1, 2, 32, 8) + red + blue);
    ASSERT_TRUE(up.ok()) << up.error().message;
    EXPECT_EQ(up->format, PixelFormat::Rgba8);
    EXPECT_EQ(up->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(2, 1, 2, 32, 0x28) + blue + red)->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(2, 2, 1, 32, 0x18) + red + blue)->bytes, from_above);
    EXPECT_EQ(import_image_bytes(tga_header(3, 2, 1, 8, 0) + "\x05\x09")->bytes, (Bytes{5, 9}));
}

TEST(TgaImport, unpacks_runs_that_go_on_over_a_rows_end) {
    // Three equal pixels, then two of their own, then one more: 3 x 2.
    const std::string packed = "\x82" + std::string("\1\2\3") + "\1" + "\4\5\6\7\10\11" +
                               std::string(1, '\0') + "\12\13\14";
    const auto image = import_image_bytes(tga_header(10, 3, 2, 24, 0x20) + packed);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->bytes, (Bytes{3, 2, 1, 3, 2, 1, 3, 2, 1, 6, 5, 4, 9, 8, 7, 12, 11, 10}));
    for (std::size_t size = 18; size < 18 + packed.size(); ++size) {
        const auto cut =
            import_image_bytes((tga_header(10, 3, 2, 24, 0x20) + packed).substr(0, size));
        ASSERT_FALSE(cut.ok()) << size;
        EXPECT_TRUE(contains(cut.error().message, "it breaks off"));
    }
    std::string huge = tga_header(10, 0, 0, 24, 0);
    for (const std::size_t i : {12U, 13U, 14U, 15U}) huge[i] = '\xFF';
    EXPECT_TRUE(contains(import_image_bytes(huge).error().message, "a side has at most"));
}

/// `side` x `side` pixels of one value each, JPEG quality 100.
std::string jpeg_of(int side, const Bytes& pixel, J_COLOR_SPACE space) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &bytes, &size);
    jpeg.image_width = static_cast<JDIMENSION>(side);
    jpeg.image_height = static_cast<JDIMENSION>(side);
    jpeg.input_components = static_cast<int>(pixel.size());
    jpeg.in_color_space = space;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    Bytes row;
    for (int i = 0; i < side; ++i) row.insert(row.end(), pixel.begin(), pixel.end());
    while (jpeg.next_scanline < jpeg.image_height) {
        JSAMPROW rows[]{row.data()};
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::string file(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return file;
}

void expect_near(const Bytes& found, const Bytes& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 2) << i;
}

TEST(JpegImport, reads_colour_and_grey) {
    const auto color = import_image_bytes(jpeg_of(1, {200, 100, 50}, JCS_RGB), "a.jpg");
    ASSERT_TRUE(color.ok()) << color.error().message;
    EXPECT_EQ(color->format, PixelFormat::Rgb8);
    expect_near(color->bytes, {200, 100, 50});
    // Told by content: the name says PNG.
    const auto grey = import_image_bytes(jpeg_of(1, {77}, JCS_GRAYSCALE), "a.png");
    ASSERT_TRUE(grey.ok()) << grey.error().message;
    EXPECT_EQ(grey->format, PixelFormat::R8);
    expect_near(grey->bytes, {77});
}

TEST(JpegImport, converts_cmyk_as_adobe_stores_it) {
    // Inverted: 255 is no ink. Half the light passes the black plate.
    const auto image = import_image_bytes(jpeg_of(1, {255, 128, 0, 128}, JCS_CMYK), "a.jpg");
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->format, PixelFormat::Rgb8);
    expect_near(image->bytes, {128, 64, 0});
}

TEST(JpegImport, refuses_files_that_break_off_anywhere) {
    const std::string good = jpeg_of(64, {200, 100, 50}, JCS_RGB);
    for (std::size_t size = 0; size + 2 < good.size(); size += 11) {
        EXPECT_FALSE(import_image_bytes(good.substr(0, size), "a.jpg").ok()) << size;
    }
}

TEST(JpegImport, looks_at_the_header_before_it_decodes) {
    std::string file = jpeg_of(8, {1, 2, 3}, JCS_RGB);
    const std::size_t frame = file.find("\xFF\xC0");
    ASSERT_NE(frame, std::string::npos);
    file.replace(frame + 5, 4, "\xFF\xDC\xFF\xDC");  // 65,500 x 65,500
    const auto image = import_image_bytes(file, "a.jpg");
    ASSERT_FALSE(image.ok());
    EXPECT_TRUE(contains(image.error().message, "its size is 65500 x 65500"))
        << image.error().message;
}

TEST(ExrImport, gives_half_floats_and_clamps_what_is_no_light) {
    const TempFolder folder;
    const fs::path file = folder.path() / "a.exr";
    const float infinity = std::numeric_limits<float>::infinity();
    // OpenEXR finds pixel (x, y) at x + 2 y: the window from (-1, 3) to (0, 4) begins at 5.
    const std::array<Imf::Rgba, 9> pixels{
        Imf::Rgba(),
        Imf::Rgba(),
        Imf::Rgba(),
        Imf::Rgba(),
        Imf::Rgba(),
        Imf::Rgba(0.5F, 2.0F, 1024.0F),
        Imf::Rgba(-3.0F, std::numeric_limits<float>::quiet_NaN(), infinity),
        Imf::Rgba(-infinity, -0.0F, 65'504.0F),
        Imf::Rgba(1.0F, 1.0F, 1.0F)};
    {
        // A data window that does not start at the origin.
        Imf::RgbaOutputFile out(file.c_str(),
                                Imath::Box2i({0, 0}, {9, 9}),
                                Imath::Box2i({-1, 3}, {0, 4}),
                                Imf::WRITE_RGBA);
        out.setFrameBuffer(pixels.data(), 1, 2);
        out.writePixels(2);
    }
    const Result<ImageData> image = import_image(file);
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->format, PixelFormat::Rgb16F);
    ASSERT_EQ(image->width, 2U);
    ASSERT_EQ(image->height, 2U);
    ASSERT_EQ(image->bytes.size(), 24U);
    const std::array<float, 12> expected{
        0.5F, 2.0F, 1024.0F, 0, 0, 65'504.0F, 0, 0, 65'504.0F, 1, 1, 1};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        Imath::half value;
        std::memcpy(&value, image->bytes.data() + i * 2, 2);
        EXPECT_EQ(static_cast<float>(value), expected[i]) << i;
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string good{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t size = 4; size + 4 < good.size(); size += 13) {
        EXPECT_FALSE(import_image(folder.write("cut.exr", good.substr(0, size))).ok()) << size;
    }
}

}  // namespace
}  // namespace plumbline::assets::test
