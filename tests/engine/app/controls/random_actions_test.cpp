// Input that nobody thought of, the same for the same seed.
#include "engine/app/controls/action_tape.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>

namespace plumbline::app {
namespace {

TEST(RandomActions, TheSameSeedGivesTheSameInputAndAnotherSeedAnother) {
    RandomActions a(5);
    RandomActions b(5);
    RandomActions other(6);
    bool differs = false;
    for (int i = 0; i < 100; ++i) {
        const Actions now = a.next();
        const Actions same = b.next();
        EXPECT_EQ(now.held, same.held);
        EXPECT_EQ(now.pressed, same.pressed);
        EXPECT_EQ(now.amount, same.amount);
        EXPECT_EQ(now.look_yaw_rad, same.look_yaw_rad);
        EXPECT_EQ(now.look_pitch_rad, same.look_pitch_rad);
        differs = differs || now.held != other.next().held;
    }
    EXPECT_TRUE(differs);
}

TEST(RandomActions, APressIsAnActionThatGoesDownAndTwoChangeAtMostAStep) {
    RandomActions random(9);
    std::bitset<kActionCount> before;
    std::bitset<kActionCount> ever;
    int looks = 0;
    for (int step = 0; step < 2'000; ++step) {
        const Actions now = random.next();
        EXPECT_LE((now.held ^ before).count(), 2U);
        for (std::size_t i = 0; i < kActionCount; ++i) {
            const bool went_down = now.held[i] && !before[i];
            // One that went down and up again in the step was pressed as well.
            EXPECT_TRUE(!went_down || now.pressed[i] == 1);
            EXPECT_EQ(now.amount[i], now.held[i] ? 1.0F : 0.0F);
        }
        EXPECT_LE(std::abs(now.look_yaw_rad), 0.2F);
        EXPECT_LE(std::abs(now.look_pitch_rad), 0.1F);
        looks += now.look_yaw_rad != 0.0F ? 1 : 0;
        ever |= now.held;
        before = now.held;
    }
    EXPECT_TRUE(ever.all()) << "no action is left out";
    EXPECT_NEAR(looks, 500, 80) << "one step in four, four deviations of 19";
}

}  // namespace
}  // namespace plumbline::app
