// Images of materials on the GPU: halved, shared, counted.
#include "engine/assets/image/image_import.h"
#include "engine/render/resources/gpu_textures.h"
#include "tests/engine/render/image_fixture.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>

namespace plumbline::render {
namespace {

class GpuTexturesGl : public ImageGl {
protected:
    std::filesystem::path image(const char* name, std::uint32_t width, std::uint32_t height) {
        const std::filesystem::path file = folder_ / name;
        EXPECT_TRUE(assets::write_png(
                        file,
                        {.width = width,
                         .height = height,
                         .format = assets::PixelFormat::Rgba8,
                         .bytes = std::vector<std::uint8_t>(std::size_t{width} * height * 4, 200)})
                        .ok());
        return file;
    }

    test::TemporaryFolder folder_;
};

// EXPERIENCE G21
TEST_F(GpuTexturesGl, ImagesLargerThanTheDriverTakesAreHalvedUntilTheyFit) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "plumbline_large_image.png";
    assets::ImageData stripes{.width = 256,
                              .height = 64,
                              .format = assets::PixelFormat::Rgb8,
                              .bytes = std::vector<std::uint8_t>(256 * 64 * 3, 200)};
    ASSERT_TRUE(assets::write_png(file, stripes).ok());
    const auto material = library_.add_material(
        {.name = "stripes", .shading = assets::Shading::Unlit, .base_color_map = file});
    const RenderFrame frame = wall(material);
    const Pixel whole = center(frame);
    const std::uint64_t before = bytes_of("textures");
    make_renderer(PL_SOURCE_DIR "/shaders", {.texture_px = 64});
    const Pixel halved = center(frame);
    EXPECT_NEAR(halved.r, whole.r, 1);
    EXPECT_NEAR(whole.r, 200, 1);
    // 256 x 64 with all levels is a little over 4/3 of 65536; 64 x 16 a sixteenth of it.
    EXPECT_NEAR(
        static_cast<double>(bytes_of("textures")) / static_cast<double>(before), 1.0 / 16.0, 0.001);
    std::filesystem::remove(file);
}

TEST_F(GpuTexturesGl, AreUploadedOnceForEachUseOfTheirPixels) {
    GpuTextures textures(library_, 1024);
    const auto file = image("a.png", 4, 4);
    const gl::Texture& color = textures.get({.file = file, .content = MipContent::Color});
    // 16, 4 and 1 pixels of four bytes.
    EXPECT_EQ(color.bytes(), 4U * 21U);
    EXPECT_EQ(&textures.get({.file = file, .content = MipContent::Color}), &color);
    EXPECT_EQ(textures.bytes(), 4U * 21U);
    const gl::Texture& normals = textures.get({.file = file, .content = MipContent::Data});
    EXPECT_NE(normals.name(), color.name()) << "halved another way";
    EXPECT_EQ(textures.bytes(), 2U * 4U * 21U);
    textures.clear();
    EXPECT_EQ(textures.bytes(), 0U);
}

TEST_F(GpuTexturesGl, LargerThanAllowedTheyBeginAtTheFirstLevelThatFits) {
    GpuTextures textures(library_, 4);
    const gl::Texture& wide = textures.get({.file = image("w.png", 16, 2)});
    EXPECT_EQ(wide.width(), 4U);
    EXPECT_EQ(wide.height(), 1U);
    EXPECT_EQ(wide.bytes(), 4U * (4U + 2U + 1U));
}

TEST_F(GpuTexturesGl, ManyAreLoadedAtOnceAndEachIsTold) {
    GpuTextures textures(library_, 1024);
    std::vector<TextureRequest> requests;
    for (int i = 0; i < 7; ++i)
        requests.push_back({.file = image((std::to_string(i) + ".png").c_str(), 2, 2)});
    requests.push_back(requests.front());
    int told = 0;
    textures.load(requests, [&] { ++told; });
    EXPECT_EQ(told, 8);
    EXPECT_EQ(textures.bytes(), 7U * 4U * 5U) << "the one that is asked for twice is there once";
    textures.load(requests, [&] { ++told; });
    EXPECT_EQ(textures.bytes(), 7U * 4U * 5U);
}

}  // namespace
}  // namespace plumbline::render
