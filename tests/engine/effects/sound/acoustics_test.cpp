#include "engine/effects/sound/acoustics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::effects {
namespace {

double dB(float share) {
    return -20.0 * std::log10(static_cast<double>(share));
}

// pi f m / (rho c): 10 kg/m2 at 1 kHz are 76.07, 37.6 dB; each doubling of mass or pitch is 6 dB.
TEST(Acoustics, AWallLetsThroughByTheMassLaw) {
    EXPECT_NEAR(dB(share_through_wall(10, 1'000)), 37.62, 0.01);
    EXPECT_NEAR(dB(share_through_wall(20, 1'000)), 43.64, 0.01);
    EXPECT_NEAR(dB(share_through_wall(10, 2'000)), 43.64, 0.01);
    EXPECT_FLOAT_EQ(share_through_wall(0, 1'000), 1.0F);
    EXPECT_FLOAT_EQ(share_through_wall(-1, 1'000), 1.0F);
}

// Kurze and Anderson: 5 dB at the edge; a Fresnel number of 1 is 5 + 20 log(2.507 / tanh 2.507).
TEST(Acoustics, RoundAnEdgeLittleOfHighTonesBends) {
    EXPECT_NEAR(dB(share_round_edge(0, 1'000)), 5.0, 0.01);
    EXPECT_NEAR(dB(share_round_edge(343.0F / 2'000.0F, 1'000)), 13.10, 0.02);
    EXPECT_NEAR(dB(share_round_edge(1, 5'000)) - dB(share_round_edge(1, 250)), 13.0, 0.3);
}

// 6 m x 4 m x 3 m that swallow a tenth: 72 m3, 108 m2.
TEST(Acoustics, ReverberationIsSabines) {
    EXPECT_NEAR(reverberation_s(72, 10.8F), 1.0733, 1e-3);
    EXPECT_TRUE(std::isinf(reverberation_s(72, 0)));
    EXPECT_NEAR(reverberant_share(50.265F), 1.0, 1e-4);
    EXPECT_NEAR(reverberant_share(4 * 50.265F), 0.5, 1e-4);
}

TEST(Acoustics, WaterLandsWithThePowerOfItsJet) {
    EXPECT_NEAR(water_power_W(0.2F, 4, 0, 9.81F), 1.6, 1e-4);
    EXPECT_NEAR(water_power_W(0.2F, 0, 1, 9.81F), 1.962, 1e-4);
    EXPECT_EQ(water_power_W(0, 4, 1, 9.81F), 0.0F);
}

}  // namespace
}  // namespace plumbline::effects
