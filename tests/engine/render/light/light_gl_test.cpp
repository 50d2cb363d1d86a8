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

}  // namespace
}  // namespace plumbline::render
