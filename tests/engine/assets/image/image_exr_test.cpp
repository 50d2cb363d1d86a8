// OpenEXR files: half floats, windows away from the origin, and ones that break off.
#include "tests/engine/assets/image/image_files.h"

#include <ImfHeader.h>
#include <ImfRgbaFile.h>

#include <array>
#include <cstring>
#include <limits>

namespace plumbline::assets::test {
namespace {

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
    EXPECT_EQ(image->format, PixelFormat::Rgba16F);
    ASSERT_EQ(image->width, 2U);
    ASSERT_EQ(image->height, 2U);
    ASSERT_EQ(image->bytes.size(), 32U);
    const std::array<float, 16> expected{
        0.5F, 2.0F, 1024.0F, 1, 0, 0, 65'504.0F, 1, 0, 0, 65'504.0F, 1, 1, 1, 1, 1};
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

TEST(ExrImport, reads_images_taller_than_one_band_of_rows) {
    const TempFolder folder;
    const fs::path file = folder.path() / "tall.exr";
    std::vector<Imf::Rgba> rows(130);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y].r = static_cast<float>(y);
    {
        Imf::RgbaOutputFile out(file.c_str(), 1, 130, Imf::WRITE_RGB);
        out.setFrameBuffer(rows.data(), 1, 1);
        out.writePixels(130);
    }
    const Result<ImageData> image = import_image(file);
    ASSERT_TRUE(image.ok()) << image.error().message;
    ASSERT_EQ(image->bytes.size(), 130U * 6);
    for (std::size_t y = 0; y < 130; ++y) {
        Imath::half red;
        std::memcpy(&red, image->bytes.data() + y * 6, 2);
        EXPECT_EQ(static_cast<float>(red), static_cast<float>(y));
    }
    const Result<ImageData> charged = import_image(file, [](std::size_t) { return false; });
    ASSERT_FALSE(charged.ok());
    EXPECT_TRUE(contains(charged.error().message, "it takes 780 bytes")) << charged.error().message;
}

}  // namespace
}  // namespace plumbline::assets::test
