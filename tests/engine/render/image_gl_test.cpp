// Images whose colours can be computed by hand.
#include "engine/assets/image/image_import.h"
#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace plumbline::render {
namespace {

TEST_F(ImageGl, UnlitColoursComeOutAsSrgb) {
    for (const float light : {0.0F, 0.002F, 0.02F, 0.18F, 0.5F, 1.0F}) {
        const Pixel pixel = center(wall(unlit(Vec3f{light})));
        // The shader's fitted curve may round the other way.
        EXPECT_NEAR(pixel.r, code_of(light), 1) << light;
        EXPECT_EQ(pixel.r, pixel.g);
        EXPECT_EQ(pixel.r, pixel.b);
    }
}

TEST_F(ImageGl, ClearColourComesOutAsSrgb) {
    RenderFrame frame = empty_frame(8, 8);
    frame.clear_color = {0.5F, 0.7F, 0.9F};
    expect_near(pixel_at(draw(frame), 4, 4), srgb_from_linear(frame.clear_color), 1);
}

TEST_F(ImageGl, AmbientLightAloneGivesAlbedoTimesAmbient) {
    RenderFrame frame = wall(matt({0.5F, 0.25F, 0.1F}));
    frame.ambient = Vec3f{0.8F};
    // A dielectric mirrors a twenty-fifth of it; the rest gets in and comes out coloured.
    const Pixel pixel = center(frame);
    const Vec3f albedo{0.5F, 0.25F, 0.1F};
    expect_near(pixel, srgb_from_linear(0.8F * (0.04F + 0.96F * albedo)), 2);
}

TEST_F(ImageGl, FogIsTheClosedForm) {
    const float distance_m = 20.0F;
    RenderFrame frame = wall(unlit({0.9F, 0.1F, 0.1F}), distance_m);
    frame.fog = Fog{.color = {0.2F, 0.4F, 0.8F}, .density_per_m = 0.03F};
    const float through = std::exp(-std::pow(0.03F * distance_m, 2.0F));
    const Vec3f expected = frame.fog->color * (1.0F - through) + Vec3f{0.9F, 0.1F, 0.1F} * through;
    expect_near(center(frame), srgb_from_linear(expected), 1);
}

TEST_F(ImageGl, GlassBlendsOverWhatIsBehind) {
    RenderFrame frame = wall(unlit({1.0F, 1.0F, 1.0F}));
    const auto glass = library_.add_material({.name = "glass",
                                              .shading = assets::Shading::Unlit,
                                              .base_color = Vec3f{0.0F},
                                              .alpha = 0.5F,
                                              .alpha_mode = assets::AlphaMode::Blend});
    add_box(frame, {4.0F, 4.0F, 0.1F}, {0.0F, 0.0F, -1.0F}, glass);
    // Half of the light, not half of the code: 188, not 128. With a tone curve and without.
    EXPECT_NEAR(center(frame).r, code_of(0.5F), 1);
    frame.post = Post{.exposure = 1.0F};
    expect_near(center(frame), srgb_from_linear(tone_mapped(Vec3f{0.5F}, 1.0F)), 1);
}

}  // namespace
}  // namespace plumbline::render
