// Measured of sampled motions whose values are known.
#include "engine/scene/environment/plaque.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::scene {
namespace {

constexpr double kStep_s = 1.0 / 60;
constexpr double kTurn = 2 * 3.14159265358979323846;

PlaqueMeter after(double seconds, double period_s, PlaqueMeter meter = {}) {
    for (int i = 0; i < static_cast<int>(seconds / kStep_s); ++i)
        meter.note(PlaqueQuantity::Period, std::cos(kTurn * i * kStep_s / period_s - 1), kStep_s);
    return meter;
}

TEST(PlaqueMeter, APeriodIsFinerThanSteps) {
    const PlaqueMeter meter = after(10, 1.2345);
    ASSERT_TRUE(meter.measured());
    EXPECT_NEAR(*meter.measured(), 1.2345, 1e-4);
    EXPECT_EQ(meter.periods(), 7);
}

TEST(PlaqueMeter, NothingIsMeasuredBeforeAPeriodIsOver) {
    EXPECT_FALSE(after(1, 1.5).measured());
}

TEST(PlaqueMeter, AnotherPeriodStartsItsMeanAnew) {
    const PlaqueMeter meter = after(10, 2, after(10, 1));
    EXPECT_NEAR(*meter.measured(), 2, 1e-3);
    EXPECT_LE(meter.periods(), 4);
}

TEST(PlaqueMeter, AQuantityIsTheMeanOfTheLatestSecond) {
    PlaqueMeter meter;
    meter.note(PlaqueQuantity::Height, 3, kStep_s);
    EXPECT_EQ(*meter.measured(), 3);
    // A step of the input: 1 - 1/e of it after the time constant.
    for (int i = 0; i < 60; ++i) meter.note(PlaqueQuantity::Height, 4, kStep_s);
    EXPECT_NEAR(*meter.measured(), 4 - std::exp(-1), 0.01);
}

TEST(PlaqueMeter, GoesOnFromItsArchive) {
    PlaqueMeter meter = after(3.1, 0.9);
    Archive written;
    meter.serialize(written);
    PlaqueMeter other;
    Archive read(written.written());
    other.serialize(read);
    ASSERT_FALSE(read.failed());
    EXPECT_EQ(*after(4, 0.9, other).measured(), *after(4, 0.9, meter).measured());
}

}  // namespace
}  // namespace plumbline::scene
