// Light in clear air against closed forms.
#include "engine/render/sky/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::render {
namespace {

// Straight up through layers of known thickness the depth is their sum in closed form: air 8 km and
// haze 1.2 km thick, ozone a triangle of 15 km.
TEST(Atmosphere, LetsThroughWhatLayersOfKnownDepthLetThrough) {
    const Atmosphere air(1.0F);
    const Vec3f depth = Vec3f{5.802e-6F, 13.558e-6F, 33.1e-6F} * 8e3F + Vec3f{4.44e-6F * 1.2e3F} +
                        Vec3f{0.65e-6F, 1.881e-6F, 0.085e-6F} * 15e3F;
    const Vec3f through = air.transmittance(1.0F);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(through[i], std::exp(-depth[i]), 0.01F) << i;
}

TEST(Atmosphere, PhaseFunctionsKeepAllLight) {
    for (float (*phase)(float) : {&Atmosphere::rayleigh_phase, &Atmosphere::haze_phase}) {
        double sum = 0;
        constexpr int kSteps = 20'000;
        for (int i = 0; i < kSteps; ++i) {
            const double cosine = 2 * (i + 0.5) / kSteps - 1;
            sum += static_cast<double>(phase(static_cast<float>(cosine))) * 2 / kSteps;
        }
        EXPECT_NEAR(sum * 2 * glm::pi<double>(), 1.0, 1e-3);
    }
}

TEST(Atmosphere, LightSinksBelowTheHorizonWithinHalfADegree) {
    const Atmosphere air(1.0F);
    EXPECT_EQ(air.transmittance(-0.01F), Vec3f{0.0F});
    EXPECT_EQ(air.transmittance(-1.0F), Vec3f{0.0F});
    EXPECT_GT(air.transmittance(0.0F).x, 1.5F * air.transmittance(-0.002F).x);
    EXPECT_GT(air.transmittance(0.0048F).x, 1.5F * air.transmittance(0.0F).x);
    EXPECT_GT(air.transmittance(-0.002F).x, 0.0F);
    // Higher up, light comes from below the level horizon: 2 km up, by 1.4 degrees.
    EXPECT_GT(air.transmittance(-0.01F, 2e3F).x, 0.0F);
    EXPECT_EQ(air.transmittance(-0.04F, 2e3F), Vec3f{0.0F});
}

TEST(Atmosphere, WithoutHazeLosesNothingToIt) {
    const Atmosphere clean(0.0F);
    const Atmosphere hazy(5.0F);
    const Vec3f ratio = hazy.transmittance(1.0F) / clean.transmittance(1.0F);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(ratio[i], std::exp(-5.0F * 4.44e-6F * 1.2e3F), 1e-3F) << i;
    EXPECT_EQ(clean.scattered(0.5F, 0.0F, 0.5F).haze, Vec3f(0.0F));
    EXPECT_EQ(Atmosphere(-3.0F).transmittance(1.0F), clean.transmittance(1.0F)) << "0 to 20";
    EXPECT_EQ(Atmosphere(99.0F).transmittance(1.0F), Atmosphere(20.0F).transmittance(1.0F));
}

TEST(Atmosphere, ScattersNothingWithoutLightAndBelowTheHorizonAsAtIt) {
    const Atmosphere air(1.0F);
    const Atmosphere::Scattered night = air.scattered(0.3F, 0.5F, -1.0F);
    EXPECT_EQ(night.air, Vec3f(0.0F));
    EXPECT_EQ(night.haze, Vec3f(0.0F));
    EXPECT_EQ(night.often, Vec3f(0.0F));
    const Atmosphere::Scattered level = air.scattered(0.0F, 0.5F, 0.5F);
    const Atmosphere::Scattered down = air.scattered(-0.7F, 0.5F, 0.5F);
    EXPECT_EQ(down.air, level.air);
    EXPECT_EQ(down.often, level.often);
    // Blue is scattered most: by the fourth power of its frequency.
    const Vec3f up = air.scattered(1.0F, 0.0F, 0.7F).air;
    EXPECT_GT(up.z, 2.0F * up.y);
    EXPECT_GT(up.y, 1.5F * up.x);
}

}  // namespace
}  // namespace plumbline::render
