// Light from air in the sun against closed forms.
#include "engine/core/color.h"
#include "tests/engine/render/image_fixture.h"

#include <cmath>

namespace plumbline::render {
namespace {

constexpr float kDensity_perm = 0.02F;

class ShaftPassGl : public ImageGl {
protected:
    /// A black wall 20 m ahead; the sun stands overhead.
    RenderFrame dusty() {
        RenderFrame frame = wall(unlit(Vec3f{0.0F}), 20.0F);
        frame.width_px = 256;
        frame.height_px = 256;
        frame.sun =
            DirectionalLight{.direction_world = {0.0F, -1.0F, 0.0F}, .radiance = Vec3f{8.0F}};
        frame.shafts = SunShafts{.density_per_m = kDensity_perm, .distance_m = 60.0F, .steps = 32};
        return frame;
    }
    /// Haze of asymmetry 0.7, seen at a right angle to the sun.
    static float phase() {
        return (1.0F - 0.49F) / (4.0F * glm::pi<float>() * std::pow(1.49F, 1.5F));
    }
    static float lit(float from_m, float to_m) {
        return 8.0F * phase() *
               (std::exp(-kDensity_perm * from_m) - std::exp(-kDensity_perm * to_m));
    }
    static float light_at(const assets::ImageData& image, std::uint32_t x, std::uint32_t y) {
        return linear_from_srgb(static_cast<float>(pixel_at(image, x, y).g) / 255.0F);
    }
};

TEST_F(ShaftPassGl, OpenAirSendsWhatIsScatteredOnTheWay) {
    EXPECT_NEAR(light_at(draw(dusty()), 128, 128), lit(0.0F, 20.0F), 0.003F);
    RenderFrame near = dusty();
    near.shafts->distance_m = 5.0F;
    EXPECT_NEAR(light_at(draw(near), 128, 128), lit(0.0F, 5.0F), 0.003F);
}

TEST_F(ShaftPassGl, AirInShadowSendsNone) {
    RenderFrame frame = dusty();
    // A roof from 5 m to 12 m ahead.
    add_box(frame, {60.0F, 0.5F, 7.0F}, {0.0F, 6.0F, -8.5F}, unlit(Vec3f{0.0F}));
    for (const std::uint32_t cascades : {1U, 3U}) {
        frame.sun_shadow = SunShadow{.size_px = 1024, .distance_m = 60.0F, .cascades = cascades};
        const auto image = draw(frame);
        EXPECT_NEAR(light_at(image, 128, 128), lit(0.0F, 5.0F) + lit(12.0F, 20.0F), 0.004F)
            << cascades;
    }
}

TEST_F(ShaftPassGl, NobodyPaysUnaskedOrWithoutASun) {
    RenderFrame frame = dusty();
    draw(frame);
    // Two images of a quarter of the width and height, two half floats a pixel.
    EXPECT_EQ(bytes_of("sun_shafts"), 2U * 64U * 64U * 4U);
    frame.quality.sun_shafts = Drawn::Never;
    const auto plain = draw(frame);
    EXPECT_EQ(bytes_of("sun_shafts"), 0U);
    EXPECT_EQ(light_at(plain, 128, 128), 0.0F);
    frame.quality.sun_shafts = Drawn::Always;
    frame.sun.reset();
    EXPECT_EQ(draw(frame).bytes, plain.bytes);
    EXPECT_EQ(bytes_of("sun_shafts"), 0U);
}

}  // namespace
}  // namespace plumbline::render
