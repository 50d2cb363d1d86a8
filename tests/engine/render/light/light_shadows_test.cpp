// Which lights cast shadows, and where the maps round a light look.
#include "engine/render/light/light_shadows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::render {
namespace {

const Vec3f kEye{0.0F, 0.0F, 10.0F};

/// From kEye along -z.
Frustum sight() {
    Mat4f view_from_world{1.0F};
    view_from_world[3] = Vec4f{-kEye, 1.0F};
    return Frustum{glm::perspective(1.0F, 1.0F, 0.05F, 100.0F) * view_from_world};
}

LocalLight lamp(const Vec3f& place, float intensity = 10.0F) {
    return {.position_world = place,
            .intensity = Vec3f{intensity},
            .radius_m = 2.0F,
            .casts_shadow = true};
}

TEST(LightShadowChoice, TakesThoseInSightThatAsk) {
    std::vector<LocalLight> lights{lamp({0, 0, 0}), lamp({1, 0, 0}), lamp({0, 0, 20})};
    lights[1].casts_shadow = false;
    LightShadowChoice choice;
    choice.choose(lights, sight(), kEye, 8);
    ASSERT_EQ(choice.chosen().size(), 1U);
    EXPECT_EQ(choice.chosen()[0].light, 0U);
    EXPECT_EQ(choice.left_out(), 0U);
    choice.choose(lights, sight(), kEye, 0);
    EXPECT_TRUE(choice.chosen().empty());
    EXPECT_EQ(choice.left_out(), 1U);
}

TEST(LightShadowChoice, TakesTheBrightestAtTheEyeAndSaysHowManyGoWithout) {
    std::vector<LocalLight> lights;
    for (int i = 0; i < 12; ++i)
        lights.push_back(lamp({0, 0, -static_cast<float>(i)}, i == 11 ? 1000.0F : 10.0F));
    LightShadowChoice choice;
    choice.choose(lights, sight(), kEye, 3);
    ASSERT_EQ(choice.chosen().size(), 3U);
    EXPECT_EQ(choice.chosen()[0].light, 11U);
    EXPECT_EQ(choice.chosen()[1].light, 0U);
    EXPECT_EQ(choice.chosen()[2].light, 1U);
    EXPECT_EQ(choice.left_out(), 9U);
    choice.choose(lights, sight(), kEye, 100);
    EXPECT_EQ(choice.chosen().size(), std::size_t{PL_MAX_SHADOWED_LIGHTS});
}

TEST(LightShadowChoice, ALightKeepsItsRowWhereverItStandsInTheList) {
    LightShadowChoice choice;
    choice.choose(std::vector{lamp({0, 0, 0}), lamp({0, 0, -3})}, sight(), kEye, 2);
    ASSERT_EQ(choice.chosen().size(), 2U);
    const std::uint32_t row = choice.chosen()[1].row;
    EXPECT_NE(choice.chosen()[0].row, row);
    // The first has gone out, the second swings.
    choice.choose(std::vector{lamp({0.1F, 0, -3})}, sight(), kEye, 2);
    ASSERT_EQ(choice.chosen().size(), 1U);
    EXPECT_EQ(choice.chosen()[0].row, row);
    EXPECT_TRUE(choice.chosen()[0].moved);
    choice.choose(std::vector{lamp({0.1F, 0, -3})}, sight(), kEye, 2);
    EXPECT_FALSE(choice.chosen()[0].moved);
}

TEST(LightShadowChoice, TwoOfOneBrightnessDoNotTakeTurns) {
    LightShadowChoice choice;
    choice.choose(std::vector{lamp({-1, 0, 0}), lamp({1, 0, 0}, 9.0F)}, sight(), kEye, 1);
    EXPECT_EQ(choice.chosen()[0].light, 0U);
    choice.choose(std::vector{lamp({-1, 0, 0}), lamp({1, 0, 0}, 14.0F)}, sight(), kEye, 1);
    EXPECT_EQ(choice.chosen()[0].light, 0U);
    choice.choose(std::vector{lamp({-1, 0, 0}), lamp({1, 0, 0}, 16.0F)}, sight(), kEye, 1);
    EXPECT_EQ(choice.chosen()[0].light, 1U);
}

// Straight ahead of each face is its middle; a place at 45 degrees lies a margin off its rim; depth is
// what the shader computes.
TEST(LightShadowMaps, LookAllWaysRound) {
    const LocalLight light = lamp({1.0F, 2.0F, 3.0F});
    constexpr std::uint32_t kSize_px = 256;
    const Vec4f numbers = shadow_numbers(light, 5, kSize_px);
    EXPECT_EQ(numbers.x, 5.0F);
    for (std::uint32_t face = 0; face < kLightFaces; ++face) {
        Vec3f ahead{0.0F};
        const int axis = static_cast<int>(face / 2);
        ahead[axis] = face % 2 == 0 ? 1.5F : -1.5F;
        Vec3f side{0.0F};
        side[(axis + 2) % 3] = 1.5F;
        const Mat4f matrix = clip_from_world(light, face, kSize_px);
        const Vec4f middle = matrix * Vec4f{light.position_world + ahead, 1.0F};
        EXPECT_NEAR(middle.x / middle.w, 0.0F, 1e-5F) << face;
        EXPECT_NEAR(middle.y / middle.w, 0.0F, 1e-5F) << face;
        EXPECT_NEAR(middle.z / middle.w * 0.5F + 0.5F, numbers.y - numbers.z / 1.5F, 1e-5F) << face;
        const Vec4f rim = matrix * Vec4f{light.position_world + ahead + side, 1.0F};
        EXPECT_NEAR((1.0F - rim.y / rim.w) * 0.5F * kSize_px, PL_LIGHT_SHADOW_MARGIN_PX, 1e-3F);
    }
    EXPECT_NEAR(numbers.w * 0.5F * (kSize_px - 2.0F * PL_LIGHT_SHADOW_MARGIN_PX), 1.0F, 1e-5F);
}

TEST(LightShadowMaps, ASpotHasOnlyThoseThatItShinesInto) {
    LocalLight spot = lamp(Vec3f{0.0F});
    for (std::uint32_t face = 0; face < kLightFaces; ++face) EXPECT_TRUE(shines_into(spot, face));
    spot.is_spot = true;
    spot.direction_world = {0.0F, -1.0F, 0.0F};
    spot.outer_cos = std::cos(0.5F);
    for (std::uint32_t face = 0; face < kLightFaces; ++face)
        EXPECT_EQ(shines_into(spot, face), face == 3) << face;
    spot.outer_cos = std::cos(0.9F);
    EXPECT_TRUE(shines_into(spot, 0)) << "past the rim of the lower face";
    EXPECT_FALSE(shines_into(spot, 2));
}

}  // namespace
}  // namespace plumbline::render
