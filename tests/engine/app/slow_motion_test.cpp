#include "engine/app/slow_motion.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

TEST(SlowMotion, NothingLostIsNothingSaid) {
    SlowMotion slow;
    for (int frame = 0; frame < 1000; ++frame) EXPECT_FALSE(slow.look(0.1 * frame, 5.0));
}

TEST(SlowMotion, TheShareOfTheLastSecondsIsToldOnceAMinute) {
    SlowMotion slow;
    int told = 0;
    for (int frame = 0; frame <= 1000; ++frame) {
        const double now_s = 0.1 * frame;
        const std::optional<double> share = slow.look(now_s, 0.4 * now_s);
        if (!share) continue;
        ++told;
        EXPECT_NEAR(*share, 0.4, 1e-9);
    }
    EXPECT_EQ(told, 2) << "after 3 s, and a minute later";
}

TEST(SlowMotion, WhatIsNotFeltIsNotTold) {
    SlowMotion slow;
    for (int frame = 0; frame < 1000; ++frame) EXPECT_FALSE(slow.look(0.1 * frame, 0.008 * frame));
}

}  // namespace
}  // namespace plumbline::app
