// JPEG files: grey, colour, CMYK, and ones that break off.
#include "tests/engine/assets/image/uniform_images.h"

namespace plumbline::assets::test {
namespace {

void expect_bytes_near(const Bytes& found, const Bytes& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 2) << i;
}

TEST(JpegImport, reads_colour_and_grey) {
    const auto color = import_image_bytes(jpeg_of(1, {200, 100, 50}, JCS_RGB), "a.jpg");
    ASSERT_TRUE(color.ok()) << color.error().message;
    EXPECT_EQ(color->format, PixelFormat::Rgb8);
    expect_bytes_near(color->bytes, {200, 100, 50});
    // Told by content: the name says PNG.
    const auto grey = import_image_bytes(jpeg_of(1, {77}, JCS_GRAYSCALE), "a.png");
    ASSERT_TRUE(grey.ok()) << grey.error().message;
    EXPECT_EQ(grey->format, PixelFormat::R8);
    expect_bytes_near(grey->bytes, {77});
}

TEST(JpegImport, converts_cmyk_as_adobe_stores_it) {
    // Inverted: 255 is no ink. Half the light passes the black plate.
    const auto image = import_image_bytes(jpeg_of(1, {255, 128, 0, 128}, JCS_CMYK), "a.jpg");
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->format, PixelFormat::Rgb8);
    expect_bytes_near(image->bytes, {128, 64, 0});
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

/// As jpeg_of, without the mark of Adobe's programs, which stands behind JFIF's.
TEST(JpegImport, takes_cmyk_without_adobes_mark_as_ink) {
    std::string file = jpeg_of(1, {255, 128, 0, 128}, JCS_CMYK);
    const std::size_t mark = file.find("\xFF\xEE");
    ASSERT_NE(mark, std::string::npos);
    const std::size_t bytes = 2 + static_cast<std::uint8_t>(file[mark + 3]);
    file.erase(mark, bytes);
    const auto image = import_image_bytes(file, "a.jpg");
    ASSERT_TRUE(image.ok()) << image.error().message;
    expect_bytes_near(image->bytes, {0, 64, 127});  // (255 - ink) x (255 - black) / 255
}

}  // namespace
}  // namespace plumbline::assets::test
