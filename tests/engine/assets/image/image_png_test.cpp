// PNG files: written and read back, converted, refused before they are decoded.
#include "engine/assets/image/image_import.h"
#include "engine/core/limits.h"
#include "tests/engine/assets/image/image_files.h"

namespace plumbline::assets::test {
namespace {

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

TEST(PngImport, takes_a_colour_that_stands_for_nothing_as_alpha) {
    // tRNS: the grey level 7 is not seen.
    const auto image = import_image_bytes(PngFile(2, 1, 8, 0)
                                              .chunk("tRNS", std::string("\0\7", 2))
                                              .pixels(std::string("\0\7\x9", 3))
                                              .done());
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->format, PixelFormat::Rgba8);
    EXPECT_EQ(image->bytes, (Bytes{7, 7, 7, 0, 9, 9, 9, 255}));
}

}  // namespace
}  // namespace plumbline::assets::test
