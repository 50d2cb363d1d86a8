// What flashlights, lamps and their shadows do, against closed forms.
#include "tests/engine/render/image_fixture.h"

namespace plumbline::render {
namespace {

TEST_F(ImageGl, FlashlightLightsItsConeAndCastsItsOwnShadow) {
    RenderFrame frame = wall(matt(Vec3f{0.8F}), 6.0F);
    frame.width_px = 301;
    frame.height_px = 301;
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{60.0F},
                                  .radius_m = 30.0F,
                                  .inner_rad = 0.15F,
                                  .outer_rad = 0.3F};
    const auto x_at = [](float angle_rad) {
        const float ndc = std::tan(angle_rad) / std::tan(radians_from_degrees(30.0F));
        return static_cast<std::uint32_t>((ndc * 0.5F + 0.5F) * 301.0F);
    };
    auto image = draw(frame);
    const int middle = pixel_at(image, 150, 150).r;
    EXPECT_GT(middle, 120);
    EXPECT_GT(pixel_at(image, x_at(0.1F), 150).r, 100);
    EXPECT_EQ(pixel_at(image, x_at(0.31F), 150).r, 0);
    EXPECT_EQ(pixel_at(image, x_at(-0.31F), 150).r, 0);

    // A small box half way throws a shadow twice its size. Seen from the eye, 0.3 m above the
    // hand, part of that shadow shows below the box.
    frame.flashlight->position_world = {0.0F, 0.3F, 0.0F};
    add_box(frame, Vec3f{0.3F}, {0.0F, 0.0F, -3.0F}, matt(Vec3f{0.8F}));
    image = draw(frame);
    // The shadow on the wall at 6 m: centred on y = 0.3 - 0.3 * 6 / 3 = -0.3.
    const float angle = std::atan(0.42F / 6.0F);
    const std::uint32_t below = 300 - x_at(angle);
    EXPECT_LT(pixel_at(image, 150, 300 - below).r, 20);
    EXPECT_GT(pixel_at(image, 150, below).r, 60);
}

TEST_F(ImageGl, AFlashlightAtTheEyeNeedsNoShadowMap) {
    RenderFrame frame = wall(matt(Vec3f{0.8F}), 6.0F);
    frame.width_px = 301;
    frame.height_px = 301;
    add_box(frame, Vec3f{0.6F}, {0.5F, 0.2F, -3.0F}, matt(Vec3f{0.8F, 0.2F, 0.2F}));
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{60.0F},
                                  .radius_m = 30.0F,
                                  .inner_rad = 0.15F,
                                  .outer_rad = 0.4F};
    const auto without = draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 0U);
    // A tenth of a millimetre aside it has one. What that hides is thinner than a pixel; the map's own
    // coarseness shows at the box's edge, where it is a texel of 6 m * 2 tan 0.4 / 1024 wide.
    frame.flashlight->position_world.x = 1e-4F;
    const auto with = draw(frame);
    EXPECT_EQ(renderer_->stats().shadow_passes_rendered, 1U);
    int unlike = 0;
    for (std::uint32_t y = 0; y < 301; ++y) {
        for (std::uint32_t x = 0; x < 301; ++x)
            unlike += std::abs(pixel_at(without, x, y).r - pixel_at(with, x, y).r) > 3;
    }
    EXPECT_LT(unlike, 301 * 301 / 200);
    EXPECT_GT(pixel_at(without, 150, 150).r, 100);
}

TEST_F(ImageGl, LightAtTheEyeMakesNoSpecks) {
    // V = H exactly: the power in Schlick's term would see a negative number.
    const auto shiny = library_.add_material(
        {.name = "shiny", .base_color = Vec3f{0.9F}, .roughness = 0.05F, .metallic = 1.0F});
    RenderFrame frame = wall(shiny, 3.0F);
    frame.width_px = 201;
    frame.height_px = 201;
    frame.flashlight = Flashlight{.position_world = Vec3f{0.0F},
                                  .direction_world = {0.0F, 0.0F, -1.0F},
                                  .intensity = Vec3f{2000.0F},
                                  .outer_rad = 1.2F};
    const auto image = draw(frame);
    for (std::uint32_t y = 95; y < 106; ++y) {
        for (std::uint32_t x = 95; x < 106; ++x) EXPECT_GT(pixel_at(image, x, y).r, 100);
    }
}

TEST_F(ImageGl, PointLightFallsWithTheSquareAndEndsAtItsRadius) {
    RenderFrame frame = wall(matt(Vec3f{1.0F}), 2.0F);
    frame.lights.push_back(
        {.position_world = {0.0F, 0.0F, 0.0F}, .intensity = Vec3f{4.0F}, .radius_m = 100.0F});
    // 4 cd at 2 m: irradiance 1; a matt white wall sends out 1 / pi, and mirrors little.
    EXPECT_NEAR(center(frame).r, code_of(glm::one_over_pi<float>()), 6);
    frame.lights[0].radius_m = 1.9F;
    EXPECT_EQ(center(frame).r, 0);
}

TEST_F(ImageGl, FarLightsBeyondTheFirst256AreLeftOut) {
    RenderFrame frame = wall(matt(Vec3f{1.0F}), 2.0F);
    for (int i = 0; i < 300; ++i) {
        frame.lights.push_back({.position_world = {0.0F, 0.0F, 500.0F + static_cast<float>(i)},
                                .intensity = Vec3f{1.0F},
                                .radius_m = 10.0F});
    }
    EXPECT_EQ(center(frame).r, 0);
    frame.lights[255].position_world = Vec3f{0.0F};
    EXPECT_GT(center(frame).r, 40);
}

}  // namespace
}  // namespace plumbline::render
