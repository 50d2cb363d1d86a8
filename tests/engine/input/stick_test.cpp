#include "engine/input/stick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline::input {
namespace {

constexpr Tuning kTuning{};  // 0.15 inside, 0.02 outside, square

float length_of(const std::array<float, 2>& stick) {
    return std::hypot(stick[0], stick[1]);
}

TEST(Stick, SwallowsDriftAllRound) {
    for (int i = 0; i < 16; ++i) {
        const float angle = static_cast<float>(i) * 0.39270F;
        const auto stick = shape_stick(0.149F * std::cos(angle), 0.149F * std::sin(angle), kTuning);
        EXPECT_EQ(length_of(stick), 0.0F) << i;
    }
}

TEST(Stick, TravelIsRescaledAndSquaredBetweenTheZones) {
    // Halfway between 0.15 and 0.98 is 0.565; its square root of travel is a half.
    EXPECT_NEAR(shape_stick(0.565F, 0.0F, kTuning)[0], 0.25F, 1e-5F);
    EXPECT_NEAR(shape_stick(0.98F, 0.0F, kTuning)[0], 1.0F, 1e-5F);
    EXPECT_NEAR(shape_stick(1.0F, 0.0F, kTuning)[0], 1.0F, 1e-5F);
}

TEST(Stick, KeepsTheDirectionAndNeverPassesOne) {
    const auto stick = shape_stick(-0.9F, 0.9F, kTuning);  // 1.27 long on a square gate
    EXPECT_NEAR(stick[0], -std::sqrt(0.5F), 1e-5F);
    EXPECT_NEAR(stick[1], std::sqrt(0.5F), 1e-5F);
}

TEST(Stick, NumbersThatAreNoneAreRest) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(length_of(shape_stick(nan, nan, kTuning)), 0.0F);
    EXPECT_NEAR(shape_stick(nan, 1.0F, kTuning)[1], 1.0F, 1e-5F);
    EXPECT_EQ(trigger_travel(nan), 0.0F);
}

TEST(Stick, TriggersRestAtMinusOne) {
    EXPECT_EQ(trigger_travel(-1.0F), 0.0F);
    EXPECT_EQ(trigger_travel(0.0F), 0.5F);
    EXPECT_EQ(trigger_travel(1.0F), 1.0F);
}

}  // namespace
}  // namespace plumbline::input
