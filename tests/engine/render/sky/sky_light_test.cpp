#include "engine/render/sky/sky_light.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::render {
namespace {

template <class Fn>
std::array<RadianceImage, 6> sky_of(Fn&& radiance) {
    constexpr std::uint32_t kSide = 32;
    std::array<RadianceImage, 6> faces;
    for (std::size_t face = 0; face < 6; ++face) {
        faces[face] = {.width = kSide, .height = kSide, .pixels = {}};
        for (std::uint32_t y = 0; y < kSide; ++y) {
            for (std::uint32_t x = 0; x < kSide; ++x) {
                const float u = (static_cast<float>(x) + 0.5F) / kSide;
                const float v = (static_cast<float>(y) + 0.5F) / kSide;
                faces[face].pixels.push_back(radiance(cube_direction(face, u, v)));
            }
        }
    }
    return faces;
}

TEST(SkyLight, OfAnEvenSkyIsTheSkysRadianceEveryWay) {
    const auto sky = project_sky(sky_of([](const Vec3f&) { return Vec3f{0.2F, 0.5F, 0.8F}; }));
    for (const Vec3f& normal : {Vec3f{0, 1, 0}, Vec3f{1, 0, 0}, Vec3f{0, 0, -1}}) {
        const Vec3f light = diffuse_light(sky, normal);
        EXPECT_NEAR(light.x, 0.2F, 1e-3F);
        EXPECT_NEAR(light.y, 0.5F, 1e-3F);
        EXPECT_NEAR(light.z, 0.8F, 1e-3F);
    }
}

TEST(SkyLight, OfACosineSkyIsTwoThirdsOfIt) {
    // Radiance 1 + y: a matt surface facing n sends out 1 + 2/3 n.y.
    const auto sky = project_sky(sky_of([](const Vec3f& d) { return Vec3f{1.0F + d.y}; }));
    EXPECT_NEAR(diffuse_light(sky, {0.0F, 1.0F, 0.0F}).x, 1.0F + 2.0F / 3.0F, 2e-3F);
    EXPECT_NEAR(diffuse_light(sky, {0.0F, -1.0F, 0.0F}).x, 1.0F / 3.0F, 2e-3F);
    EXPECT_NEAR(diffuse_light(sky, {1.0F, 0.0F, 0.0F}).x, 1.0F, 2e-3F);
}

TEST(SkyLight, TypicalRadianceHardlyKnowsAboutTheSun) {
    const auto plain = sky_of([](const Vec3f&) { return Vec3f{0.5F}; });
    auto with_sun = plain;
    with_sun[2].pixels[0] = Vec3f{10'000.0F};
    EXPECT_NEAR(typical_radiance(plain), 0.5F, 1e-3F);
    EXPECT_NEAR(typical_radiance(with_sun), 0.5F, 0.01F);
}

TEST(RadianceImage, ResizedKeepsAnEvenImageAndItsHalfFloats) {
    const RadianceImage even{
        .width = 5, .height = 5, .pixels = std::vector<Vec3f>(25, Vec3f{0.25F})};
    const RadianceImage larger = resized(even, 8);
    ASSERT_EQ(larger.pixels.size(), 64U);
    const RadianceImage back = radiance_of(half_floats_of(larger));
    for (const Vec3f& pixel : back.pixels) EXPECT_EQ(pixel, Vec3f{0.25F});
}

}  // namespace
}  // namespace plumbline::render
