// Every map of a material in every format of images that is read.
#include "engine/core/color.h"
#include "engine/render/resources/gpu_materials.h"
#include "engine/render/resources/gpu_textures.h"
#include "tests/engine/assets/image/uniform_images.h"
#include "tests/engine/render/image_fixture.h"

#include <glad/gl.h>

#include <array>

namespace plumbline::render {
namespace {

using assets::MaterialData;
using assets::test::UniformImage;

constexpr std::uint8_t kCode = 186;

using MapFormatsGl = ImageGl;

/// As shaders see it: an image in grey is one channel that stands for three.
std::array<std::uint8_t, 4> first_texel(const gl::Texture& texture) {
    std::array<std::uint8_t, 16> texels{};
    gl::bind_texture(0, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    std::array<GLint, 4> channels{};
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, channels.data());
    std::array<std::uint8_t, 4> seen{};
    for (std::size_t i = 0; i < 4; ++i) {
        if (channels[i] == GL_ONE) seen[i] = 255;
        if (channels[i] >= GL_RED && channels[i] <= GL_ALPHA)
            seen[i] = texels[static_cast<std::size_t>(channels[i] - GL_RED)];
    }
    return seen;
}

/// The code as what it is drawn with: as light in an image of colours, as a number in one of data.
std::vector<UniformImage> images_of(MipContent content) {
    const float share = kCode / 255.0F;
    return assets::test::uniform_images(
        kCode, content == MipContent::Color ? linear_from_srgb(share) : share);
}

// An EXR as a material's map once ended the program: "expected an 8-bit image".
TEST_F(MapFormatsGl, EveryMapHoldsTheSameNumbersInEveryFormat) {
    const assets::test::TempFolder folder;
    constexpr std::array kMaps{&MaterialData::base_color_map,
                               &MaterialData::normal_map,
                               &MaterialData::orm_map,
                               &MaterialData::emissive_map,
                               &MaterialData::height_map};
    GpuTextures textures(library_, 1024);
    for (const auto map : kMaps) {
        MaterialData material{.emissive = Vec3f{1.0F}, .height_depth = 0.1F};
        material.normal_map = folder.path() / "color/rgb8.png";  // a height map needs one
        const bool is_color =
            map == &MaterialData::base_color_map || map == &MaterialData::emissive_map;
        for (const UniformImage& image :
             images_of(is_color ? MipContent::Color : MipContent::Data)) {
            material.*map = folder.write(
                (is_color ? "color" : "data") / std::filesystem::path(image.name), image.bytes);
            bool found = false;
            for (const TextureRequest& request : textures_of(material)) {
                if (request.file != material.*map) continue;
                found = true;
                const auto texel = first_texel(textures.get(request));
                for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(texel[i], kCode, 1) << request.file;
                const bool has_alpha = image.name.find("a.") != std::string::npos ||
                                       image.name.find("a8.") != std::string::npos;
                EXPECT_NEAR(texel[3], has_alpha ? 128 : 255, 1) << request.file;
            }
            EXPECT_TRUE(found) << image.name;
        }
    }
}

TEST_F(MapFormatsGl, LightBeyondWhiteIsWhite) {
    const assets::test::TempFolder folder;
    const auto file = folder.write("a.exr", assets::test::exr_of(40.0F, 1.0F, Imf::WRITE_RGB));
    GpuTextures textures(library_, 1024);
    EXPECT_EQ(first_texel(textures.get({.file = file})),
              (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
}

}  // namespace
}  // namespace plumbline::render
