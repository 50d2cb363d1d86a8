#include "engine/study/image/light_image.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

LightImage grey(std::uint32_t width_px, std::uint32_t height_px, float light) {
    return {.width_px = width_px,
            .height_px = height_px,
            .light = std::vector<Vec3f>(std::size_t{width_px} * height_px, Vec3f{light})};
}

TEST(LightImage, FollowsTheStandardsCurve) {
    EXPECT_EQ(light_of_code(0), 0.0F);
    EXPECT_EQ(light_of_code(255), 1.0F);
    // ((188/255 + 0.055) / 1.055)^2.4, and the straight part: 10/255 / 12.92.
    EXPECT_NEAR(light_of_code(188), 0.50289F, 1e-5F);
    EXPECT_NEAR(light_of_code(10), 0.0030353F, 1e-7F);
}

TEST(LightImage, EveryCodeComesBack) {
    assets::ImageData codes{
        .width = 256, .height = 1, .format = assets::PixelFormat::Rgb8, .bytes = {}};
    for (int code = 0; code < 256; ++code) {
        for (const int each : {code, 255 - code, 7}) {
            codes.bytes.push_back(static_cast<std::uint8_t>(each));
        }
    }
    const LightImage light = light_of(codes);
    EXPECT_EQ(light.width_px, 256U);
    EXPECT_EQ(codes_of(light).bytes, codes.bytes);
}

TEST(LightImage, AlphaIsNoLight) {
    const assets::ImageData codes{.width = 2, .height = 1, .bytes = {255, 0, 0, 9, 0, 0, 255, 200}};
    const LightImage light = light_of(codes);
    ASSERT_EQ(light.light.size(), 2U);
    EXPECT_EQ(light.at(0, 0), (Vec3f{1.0F, 0.0F, 0.0F}));
    EXPECT_EQ(light.at(1, 0), (Vec3f{0.0F, 0.0F, 1.0F}));
    EXPECT_NEAR(mean_luminance(light), 0.5 * (0.2126 + 0.0722), 1e-6);
}

TEST(ImageError, OfAnEvenDifferenceIsThatDifference) {
    const ImageError error = image_error(grey(8, 4, 0.55F), grey(8, 4, 0.5F));
    EXPECT_NEAR(error.mean, 0.1, 1e-6);
    EXPECT_NEAR(error.rms, 0.1, 1e-6);
}

TEST(ImageError, OfOnePixelFallsWithTheirNumberAndItsRoot) {
    LightImage off = grey(10, 10, 0.5F);
    off.light[37] += 0.2F;
    const ImageError error = image_error(off, grey(10, 10, 0.5F));
    EXPECT_NEAR(error.mean, 0.4 / 100.0, 1e-6);
    EXPECT_NEAR(error.rms, 0.4 / 10.0, 1e-6);
}

TEST(ImageError, OfABlackReferenceIsFinite) {
    EXPECT_TRUE(std::isfinite(image_error(grey(2, 2, 0.5F), grey(2, 2, 0.0F)).rms));
    EXPECT_EQ(image_error(grey(2, 2, 0.0F), grey(2, 2, 0.0F)).rms, 0.0);
}

}  // namespace
}  // namespace plumbline::study
