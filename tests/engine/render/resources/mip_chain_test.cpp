#include "engine/render/resources/mip_chain.h"

#include "engine/assets/image/image_import.h"

#include <gtest/gtest.h>

namespace plumbline::render {
namespace {

using assets::ImageData;
using assets::PixelFormat;

TEST(MipChain, HalvesDownToOnePixel) {
    const ImageData image{.width = 12,
                          .height = 5,
                          .format = PixelFormat::Rgb8,
                          .bytes = std::vector<std::uint8_t>(12 * 5 * 3, 100)};
    const auto levels = mip_chain(image, MipContent::Data, 0.0F);
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_EQ(levels[0].width, 6U);
    EXPECT_EQ(levels[0].height, 2U);
    EXPECT_EQ(levels[1].width, 3U);
    EXPECT_EQ(levels[1].height, 1U);
    EXPECT_EQ(levels[2].width, 1U);
    EXPECT_EQ(levels[2].height, 1U);
    for (const ImageData& level : levels) {
        EXPECT_EQ(level.bytes.size(), std::size_t{level.width} * level.height * 3);
        for (const std::uint8_t byte : level.bytes) EXPECT_EQ(byte, 100);
    }
}

TEST(MipChain, AveragesColourAsLightAndDataAsNumbers) {
    const ImageData checker{
        .width = 2, .height = 2, .format = PixelFormat::R8, .bytes = {0, 255, 255, 0}};
    EXPECT_EQ(mip_chain(checker, MipContent::Data, 0.0F)[0].bytes[0], 128);
    // Half the light of white is code value 188 in sRGB.
    EXPECT_EQ(mip_chain(checker, MipContent::Color, 0.0F)[0].bytes[0], 188);
}

TEST(MipChain, KeepsTheShareOfPixelsThatPassTheCutoff) {
    // Thin lines: one column in four is opaque. Plain averages pass nowhere at half the cutoff.
    ImageData image{.width = 64, .height = 64, .format = PixelFormat::Rgba8, .bytes = {}};
    for (int i = 0; i < 64 * 64; ++i) {
        const std::uint8_t alpha = i % 4 == 0 ? 255 : 0;
        image.bytes.insert(image.bytes.end(), {10, 200, 10, alpha});
    }
    const auto levels = mip_chain(image, MipContent::Color, 0.5F);
    for (std::size_t i = 0; i < 3; ++i) {
        std::size_t passing = 0;
        for (std::size_t at = 3; at < levels[i].bytes.size(); at += 4) {
            if (levels[i].bytes[at] >= 128) ++passing;
        }
        const double share = static_cast<double>(passing) / (levels[i].width * levels[i].height);
        EXPECT_GE(share, 0.25) << "level " << i;
    }
}

// Crowns stay as dense with distance: of our twigs each level down to eight pixels a side covers what
// the image itself covers, to 2 % of the square.
TEST(MipChain, OurTwigsCoverTheSameAtEveryLevel) {
    for (const char* name : {"twig_oak_base.png", "twig_oval_base.png"}) {
        const auto image =
            assets::import_image(std::filesystem::path{PL_SOURCE_DIR "/assets/textures"} / name);
        ASSERT_TRUE(image.ok()) << image.error().message;
        const auto share = [](const ImageData& level) {
            std::size_t passing = 0;
            for (std::size_t at = 3; at < level.bytes.size(); at += 4)
                passing += static_cast<std::size_t>(level.bytes[at] >= 128);
            return static_cast<double>(passing) / (level.width * level.height);
        };
        const double wanted = share(*image);
        EXPECT_GT(wanted, 0.1);
        for (const ImageData& level : mip_chain(*image, MipContent::Color, 0.5F)) {
            if (level.width < 8) break;
            EXPECT_NEAR(share(level), wanted, 0.02) << name << ", " << level.width << " px";
        }
    }
}

}  // namespace
}  // namespace plumbline::render
