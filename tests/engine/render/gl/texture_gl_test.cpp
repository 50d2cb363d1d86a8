// Images on the GPU: what they hold, read back.
#include "engine/assets/image/image_import.h"
#include "engine/render/gl/texture.h"
#include "tests/engine/render/gl_fixture.h"

#include <glad/gl.h>
#include <glm/gtc/packing.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

namespace plumbline::render {
namespace {

class TextureGl : public GlTest {};

TEST_F(TextureGl, ShowsImagesOfOneChannelGreyNotRed) {
    const auto file = std::filesystem::temp_directory_path() / "plumbline_grey_image.png";
    ASSERT_TRUE(assets::write_png(file,
                                  {.width = 4,
                                   .height = 4,
                                   .format = assets::PixelFormat::R8,
                                   .bytes = std::vector<std::uint8_t>(16, 120)})
                    .ok());
    const auto grey = library_.add_material(
        {.name = "grey", .shading = assets::Shading::Unlit, .base_color_map = file});
    RenderFrame frame = empty_frame(9, 9);
    frame.camera = camera_at({0.0F, 0.0F, 3.0F}, Vec3f{0.0F});
    add_box(frame, Vec3f{4.0F}, {0.0F, 0.0F, -2.0F}, grey);
    const Pixel pixel = pixel_at(draw(frame), 4, 4);
    EXPECT_NEAR(pixel.r, 120, 1);
    EXPECT_EQ(pixel.g, pixel.r);
    EXPECT_EQ(pixel.b, pixel.r);
    std::filesystem::remove(file);
}

/// Half floats of one pixel a face, uploaded and read back.
std::vector<Vec3f> kept_light(const std::vector<Vec3f>& light) {
    std::vector<assets::ImageData> faces;
    for (const Vec3f& each : light) {
        assets::ImageData face{
            .width = 1, .height = 1, .format = assets::PixelFormat::Rgb16F, .bytes = {}};
        face.bytes.resize(6);
        for (int i = 0; i < 3; ++i) {
            const std::uint16_t half = glm::packHalf1x16(each[i]);
            std::memcpy(face.bytes.data() + 2 * i, &half, 2);
        }
        faces.push_back(std::move(face));
    }
    const gl::Texture cube = gl::Texture::cube(faces, 1);
    EXPECT_EQ(cube.bytes(), 6U * 4U);
    std::vector<Vec3f> kept(6);
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.name());
    for (unsigned i = 0; i < 6; ++i)
        glGetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGB, GL_FLOAT, &kept[i]);
    return kept;
}

// Nine bits a colour with one exponent: exact for what they hold, else off by half a step of the
// strongest colour.
TEST_F(TextureGl, LightKeepsNineBitsOfItsStrongestColour) {
    const float infinity = std::numeric_limits<float>::infinity();
    const auto kept = kept_light({{0.0F, 0.0F, 0.0F},
                                  {1.0F, 0.5F, 0.25F},
                                  {1000.0F, 1.0F, 0.1F},
                                  {-2.0F, 0.75F, -0.0F},
                                  {infinity, 65'504.0F, 1.0F},
                                  {0.9995F, 0.0F, 0.0F}});
    EXPECT_EQ(kept[0], Vec3f(0.0F));
    EXPECT_EQ(kept[1], Vec3f(1.0F, 0.5F, 0.25F));
    EXPECT_NEAR(kept[2].x, 1000.0F, 1.0F);
    EXPECT_NEAR(kept[2].y, 1.0F, 1.0F);
    EXPECT_EQ(kept[3], Vec3f(0.0F, 0.75F, 0.0F)) << "negative light is none";
    EXPECT_EQ(kept[4], Vec3f(65'408.0F, 65'408.0F, 0.0F)) << "the most that there is";
    EXPECT_EQ(kept[5].x, 1.0F) << "rounded up into the next exponent";
}

TEST_F(TextureGl, CountsItsBytesByFormatLevelsAndSamples) {
    using enum gl::TargetFormat;
    for (const auto& [format, bytes] : {std::pair{Rgba8, 4U},
                                        std::pair{Srgb8, 4U},
                                        std::pair{HdrColor, 8U},
                                        std::pair{Pair16F, 4U},
                                        std::pair{Depth32F, 4U},
                                        std::pair{Depth24, 4U}}) {
        EXPECT_EQ(gl::bytes_per_pixel(format), bytes);
        EXPECT_EQ(gl::Texture::target(format, 5, 3, gl::Filter::Nearest).bytes(), 15U * bytes);
    }
    const assets::ImageData large{.width = 2,
                                  .height = 2,
                                  .format = assets::PixelFormat::Rgb8,
                                  .bytes = std::vector<std::uint8_t>(12)};
    const assets::ImageData small{.width = 1,
                                  .height = 1,
                                  .format = assets::PixelFormat::Rgb8,
                                  .bytes = std::vector<std::uint8_t>(3)};
    const std::array<const assets::ImageData*, 2> levels{&large, &small};
    EXPECT_EQ(gl::Texture::tiling(levels, gl::Filter::Trilinear).bytes(), 5U * 4U)
        << "three bytes take four";
    const gl::Texture samples = gl::Texture::multisampled(HdrColor, 4, 4, 10'000);
    EXPECT_LT(samples.samples(), 10'000U) << "as many as the driver has";
    EXPECT_EQ(samples.bytes(), 16U * 8U * samples.samples());
    EXPECT_FALSE(gl::Texture());
}

}  // namespace
}  // namespace plumbline::render
