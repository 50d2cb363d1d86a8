// Modes of a basin against their dispersion, and what bodies do to them.
#include "engine/scene/environment/wave_field.h"

#include "engine/core/hash.h"
#include "engine/core/io/archive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace plumbline::scene {
namespace {

constexpr double kG_mps2 = 9.81;

WaterDescription basin(int nx, int nz, double amplitude_m) {
    return {.name = "basin",
            .min_m = {-4, -2, -3},
            .max_m = {4, 0, 3},
            .surface = WaterSurface::Waves,
            .start = {.amplitude_m = static_cast<Real>(amplitude_m), .nx = nx, .nz = nz}};
}

TEST(WaveField, EachModeSwingsAsItsLengthAndDepthSay) {
    for (const auto& [nx, nz] : {std::pair{1, 0}, {0, 1}, {2, 3}, {5, 1}}) {
        WaveField waves(basin(nx, nz, 0.01), 16, kG_mps2);
        const double k = 3.14159265358979 * std::hypot(nx / 8.0, nz / 6.0);
        const double omega = std::sqrt(kG_mps2 * k * std::tanh(k * 2));
        double time_s = 0;
        for (int i = 0; i < 300; ++i) {
            waves.advance(1.0 / 60);
            time_s += 1.0 / 60;
            const double decay = std::exp(-2 * 2e-4 * k * k * time_s);
            EXPECT_NEAR(waves.height_m(-4, -3), 0.01 * decay * std::cos(omega * time_s), 1e-7);
        }
    }
}

TEST(WaveField, TheLengthOfStepsDoesNotMatter) {
    WaveField once(basin(2, 1, 0.05), 16, kG_mps2);
    WaveField often(basin(2, 1, 0.05), 16, kG_mps2);
    once.advance(0.8);
    for (int i = 0; i < 800; ++i) often.advance(0.001);
    EXPECT_NEAR(once.height_m(1, 2), often.height_m(1, 2), 1e-9);
}

TEST(WaveField, SlopesAreThoseOfTheHeights) {
    WaveField waves(basin(3, 2, 0.02), 16, kG_mps2);
    waves.displace({1, 0, -1}, 0.3, 0.05);
    constexpr double kApart_m = 1e-5;
    for (const auto& [x, z] : {std::pair{0.3, 0.4}, {-2.1, 1.7}, {3.3, -2.2}}) {
        const glm::dvec2 slope = waves.slope(x, z, 0.2);
        EXPECT_NEAR(slope.x,
                    (waves.height_m(x + kApart_m, z, 0.2) - waves.height_m(x - kApart_m, z, 0.2)) /
                        (2 * kApart_m),
                    1e-6);
        EXPECT_NEAR(slope.y,
                    (waves.height_m(x, z + kApart_m, 0.2) - waves.height_m(x, z - kApart_m, 0.2)) /
                        (2 * kApart_m),
                    1e-6);
    }
}

/// Work and its counterpart: lifting by dV where the felt surface stands at h takes rho g dV (h + response dV / 2).
TEST(WaveField, WhatIsDisplacedGivesTheWavesItsWork) {
    WaveField waves(basin(1, 1, 0.05), 32, kG_mps2);
    const double before_J = waves.energy_J();
    const double felt_m = waves.height_m(1, 1, 0.4);
    constexpr double kVolume_m3 = 0.01;
    const double response_pm2 = waves.response_pm2(1, 1, 0.4);
    waves.displace({1, 0, 1}, 0.4, kVolume_m3);
    EXPECT_NEAR(waves.height_m(1, 1, 0.4), felt_m + response_pm2 * kVolume_m3, 1e-9);
    EXPECT_NEAR(waves.energy_J() - before_J,
                1000 * kG_mps2 * kVolume_m3 * (felt_m + response_pm2 * kVolume_m3 / 2),
                1e-6);
    EXPECT_NEAR(waves.range().mean_m, 0, 1e-12) << "the mean level is raise_level's";
    waves.raise_level(0.48);
    EXPECT_NEAR(waves.range().mean_m, 0.01, 1e-9);
    EXPECT_NEAR(waves.raised_J(), 0.5 * 1000 * kG_mps2 * 48 * 1e-4, 1e-6);
}

TEST(WaveField, FallsAsleepWhenItIsLevelAndWakes) {
    WaveField waves(basin(1, 0, 0), 16, kG_mps2);
    EXPECT_FALSE(waves.is_asleep());
    for (int i = 0; i < 70; ++i) waves.advance(1.0 / 60);
    EXPECT_TRUE(waves.is_asleep());
    waves.displace({0, 0, 0}, 0.3, 0.02);
    EXPECT_FALSE(waves.is_asleep());
    WaveField high(basin(1, 0, 0.02), 16, kG_mps2);
    for (int i = 0; i < 600; ++i) high.advance(1.0 / 60);
    EXPECT_FALSE(high.is_asleep());
}

TEST(WaveField, IsSavedToTheBit) {
    WaveField waves(basin(2, 1, 0.03), 16, kG_mps2);
    waves.displace({1, 0, -1}, 0.3, 0.05);
    waves.advance(0.7);
    Archive saved;
    waves.serialize(saved);
    WaveField other(basin(0, 0, 0), 16, kG_mps2);
    const std::string bytes = saved.take();  // outlives the archive that reads it
    Archive read(bytes);
    other.serialize(read);
    EXPECT_FALSE(read.failed());
    const auto hash_of = [](const WaveField& field) {
        Hasher hasher;
        field.hash(hasher);
        return hasher.digest();
    };
    EXPECT_EQ(hash_of(waves), hash_of(other));
    waves.advance(0.3);
    EXPECT_NE(hash_of(waves), hash_of(other));
}

}  // namespace
}  // namespace plumbline::scene
