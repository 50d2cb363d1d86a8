#include "engine/core/color.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

TEST(Color, EveryCodeComesBack) {
    for (int code = 0; code < 256; ++code) {
        const double value = code / 255.0;
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(value)), value, 1e-6) << code;
    }
}

TEST(Color, MiddleGrayIsAFifthOfTheLight) {
    // IEC 61966-2-1: code 119 of 255 is a linear 0.1845.
    EXPECT_NEAR(linear_from_srgb(119.0 / 255.0), 0.1845, 1e-4);
    EXPECT_EQ(linear_from_srgb(0.0F), 0.0F);
    EXPECT_NEAR(linear_from_srgb(1.0F), 1.0F, 1e-6F);
}

TEST(Color, WhiteHasTheLuminanceOfOne) {
    EXPECT_NEAR(luminance(Vec3f{1.0F}), 1.0F, 1e-6F);
    EXPECT_GT(luminance({0, 1, 0}), luminance({1, 0, 0}));
    EXPECT_GT(luminance({1, 0, 0}), luminance({0, 0, 1}));
}

}  // namespace
}  // namespace plumbline
