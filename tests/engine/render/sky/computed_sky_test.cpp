// A computed sky against what holds for every sky of clear air, and against closed forms of its light.
#include "engine/render/sky/computed_sky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::render {
namespace {

constexpr Vec3f kWhite{4.0F};

Vec3f towards(float height_deg, float turn_deg) {
    const float height = radians_from_degrees(height_deg);
    const float turn = radians_from_degrees(turn_deg);
    return {std::cos(height) * std::cos(turn), std::sin(height), std::cos(height) * std::sin(turn)};
}

ComputedSky sky_with_sun(float height_deg, float turn_deg = 0.0F, float haze = 1.0F) {
    ComputedSky sky;
    sky.want({.to_sun_world = towards(height_deg, turn_deg), .haze = haze}, kWhite);
    return sky;
}

float luminance(const Vec3f& c) {
    return glm::dot(c, Vec3f{0.2126F, 0.7152F, 0.0722F});
}

float red_share(const Vec3f& c) {
    return c.x / (c.x + c.y + c.z);
}

TEST(ComputedSky, IsBrighterAtTheHorizonThanOverheadByDay) {
    for (const float height_deg : {20.0F, 40.0F, 60.0F}) {
        const ComputedSky sky = sky_with_sun(height_deg);
        for (const float turn_deg : {60.0F, 120.0F, 180.0F, 270.0F}) {
            EXPECT_GT(luminance(sky.radiance(towards(2.0F, turn_deg))),
                      2.0F * luminance(sky.radiance({0.0F, 1.0F, 0.0F})))
                << height_deg << ' ' << turn_deg;
        }
        const Vec3f up = sky.radiance({0.0F, 1.0F, 0.0F});
        EXPECT_GT(up.z, 1.5F * up.y);
        EXPECT_GT(up.y, 1.5F * up.x);
    }
}

TEST(ComputedSky, IsTheSameOnBothSidesOfTheSun) {
    for (const float height_deg : {50.0F, 10.0F, -2.0F}) {
        const ComputedSky sky = sky_with_sun(height_deg, 35.0F);
        for (const float away_deg : {5.0F, 40.0F, 90.0F, 150.0F}) {
            for (const float up_deg : {1.0F, 25.0F, 70.0F}) {
                const Vec3f left = sky.radiance(towards(up_deg, 35.0F + away_deg));
                const Vec3f right = sky.radiance(towards(up_deg, 35.0F - away_deg));
                for (int i = 0; i < 3; ++i) EXPECT_NEAR(left[i] / right[i], 1.0F, 1e-2F);
            }
        }
    }
}

TEST(ComputedSky, SunsetsAreRedAndReddestOnTheSunsSide) {
    const ComputedSky noon = sky_with_sun(60.0F);
    const ComputedSky evening = sky_with_sun(1.0F);
    EXPECT_GT(red_share(evening.key_light().irradiance),
              red_share(noon.key_light().irradiance) + 0.3F);
    const Vec3f by_sun = evening.radiance(towards(2.0F, 0.0F));
    EXPECT_GT(red_share(by_sun), 0.6F);
    EXPECT_GT(red_share(by_sun), red_share(evening.radiance(towards(40.0F, 180.0F))) + 0.2F);
    EXPECT_GT(luminance(by_sun), 4.0F * luminance(evening.radiance(towards(2.0F, 180.0F))));
}

// No step in the day: a fifth of a degree of sun never changes the light by more than a tenth, from
// noon to the middle of the night.
TEST(ComputedSky, ChangesWithoutAStepAsTheSunSinks) {
    ComputedSky sky;
    float before = -1.0F;
    for (float height_deg = 30.0F; height_deg > -25.0F; height_deg -= 0.2F) {
        sky.want({.to_sun_world = towards(height_deg, 10.0F)}, kWhite);
        const float now = luminance(sky.irradiance());
        EXPECT_GT(now, 0.0F);
        if (before > 0.0F) {
            EXPECT_NEAR(now / before, 1.0F, 0.1F) << height_deg;
        }
        before = now;
    }
}

TEST(ComputedSky, NeverShinesByTwoLightsAtOnceAndByMoonlightAtNight) {
    bool was_dark = false;
    ComputedSky sky;
    for (float height_deg = 5.0F; height_deg > -30.0F; height_deg -= 0.5F) {
        sky.want({.to_sun_world = towards(height_deg, 0.0F)}, kWhite);
        const auto& light = sky.key_light();
        if (light.irradiance == Vec3f{0.0F}) {
            was_dark = true;
            continue;
        }
        const Vec3f& expected = was_dark ? sky.to_moon() : sky.model().to_sun_world;
        EXPECT_GT(glm::dot(light.to_light_world, expected), 0.9999F) << height_deg;
        EXPECT_GT(light.to_light_world.y, -0.02F);
    }
    EXPECT_TRUE(was_dark);
    EXPECT_LT(luminance(sky.irradiance()), 0.1F * luminance(sky_with_sun(30.0F).irradiance()));
    EXPECT_EQ(sky.stars(), 1.0F);
    EXPECT_EQ(sky_with_sun(10.0F).stars(), 0.0F);
}

TEST(ComputedSky, HoldsForAnySunHazeAndStrength) {
    for (const Vec3f& sun : {Vec3f{0, 1, 0}, Vec3f{0, -1, 0}, Vec3f{1, 0, 0}, Vec3f{0.0F}}) {
        for (const float haze : {0.0F, 1.0F, 20.0F}) {
            for (const float strength : {0.0F, 1e-3F, 1e4F}) {
                ComputedSky sky;
                sky.want({.to_sun_world = sun, .haze = haze}, Vec3f{strength});
                for (const Vec3f& at : {Vec3f{0, 1, 0}, Vec3f{0, -1, 0}, Vec3f{1, 0, 0}}) {
                    const Vec3f light = sky.radiance(at);
                    for (int i = 0; i < 3; ++i) {
                        EXPECT_TRUE(std::isfinite(light[i]));
                        EXPECT_GE(light[i], 0.0F);
                    }
                }
            }
        }
    }
}

TEST(ComputedSky, ComputesOnlyWhereTheSunMoved) {
    ComputedSky sky;
    const SkyModel model{.to_sun_world = towards(30.0F, 0.0F)};
    EXPECT_TRUE(sky.want(model, kWhite));
    EXPECT_FALSE(sky.want(model, kWhite));
    EXPECT_FALSE(sky.want({.to_sun_world = towards(30.02F, 0.0F)}, kWhite));
    EXPECT_TRUE(sky.want({.to_sun_world = towards(30.2F, 0.0F)}, kWhite));
    EXPECT_TRUE(sky.want({.to_sun_world = towards(30.2F, 0.0F)}, kWhite * 0.5F));
}

// What its small cube map holds is what falls on level ground, but for the light itself.
TEST(ComputedSky, ItsFacesShineAsItsIrradianceSays) {
    const ComputedSky sky = sky_with_sun(32.0F);
    const auto faces = sky.faces();
    const Vec3f level = diffuse_light(project_sky(faces), {0.0F, 1.0F, 0.0F}) * glm::pi<float>();
    const auto& light = sky.key_light();
    const Vec3f all = level + light.irradiance * light.to_light_world.y;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(all[i] / sky.irradiance()[i], 1.0F, 0.05F) << i;
}

}  // namespace
}  // namespace plumbline::render
