// Who falls asleep under small_step, who must not, and what wakes them.
#include "tests/engine/physics/world/asleep.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(Sleep, WhatSleepsStandsStillToTheLastBitAndCostsNoWork) {
    Asleep asleep;
    const std::uint64_t before = asleep.test.hash(asleep.tower);
    for (int i = 0; i < 300; ++i) {
        asleep.test.world.step();
        EXPECT_EQ(asleep.test.world.report().cost.pairs, 0U);
        EXPECT_EQ(asleep.test.world.report().cost.row_solves, 0U);
        EXPECT_TRUE(asleep.test.world.report().islands.empty());
    }
    EXPECT_EQ(asleep.test.hash(asleep.tower), before);
    for (const BodyId id : asleep.tower) {
        EXPECT_FALSE(asleep.test.world.state(id).awake);
        EXPECT_EQ(asleep.test.velocity(id), (Vec3d{0, 0, 0}));
    }
}

TEST(SlowMotion, ASliderKeepsItsTenthOfAMetrePerSecond) {
    for (const Real size_m : {0.1_r, 1.0_r, 8.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground(0);
        const BodyId slider =
            test.add(BoxShape{.size_m = {size_m, size_m, size_m}},
                     {0, 0.5_r * size_m, 0},
                     {.kind = BodyKind::Dynamic, .velocity_mps = {0.1_r, 0, 0}, .friction = 0});
        test.run(10.0);
        EXPECT_NEAR(test.at(slider).x, 1.0, 1e-3);
    }
}

TEST(SlowMotion, ASpinnerKeepsItsHalfRadianPerSecond) {
    for (const Real size_m : {0.05_r, 1.0_r}) {
        SCOPED_TRACE(size_m);
        TestWorld test(in_small_steps());
        test.ground(0);
        const BodyId spinner = test.add(
            BoxShape{.size_m = {size_m, size_m, size_m}},
            {0, 0.5_r * size_m, 0},
            {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 0.5_r, 0}, .friction = 0});
        test.run(10.0);
        EXPECT_NEAR(test.spin(spinner).y, 0.5, 1e-3);
    }
}

TEST(SlowMotion, ABallNearTheTopOfAnotherRollsOff) {
    TestWorld test(in_small_steps());
    test.add(SphereShape{}, {0, 0, 0}, {.kind = BodyKind::Static, .friction = 0});
    // 0.2 mm off the top: its speed doubles every sixth of a second, from next to nothing.
    const BodyId ball =
        test.add(SphereShape{}, {0.0002_r, 1, 0}, {.kind = BodyKind::Dynamic, .friction = 0});
    test.run(5.0);
    EXPECT_LT(test.at(ball).y, -1.0);
}

TEST(SlowMotion, AnInvertedPendulumFallsOver) {
    TestWorld test(in_small_steps());
    const double tilt_rad = 0.001;
    const BodyId bob =
        test.add(SphereShape{.radius_m = 0.05_r},
                 {static_cast<Real>(std::sin(tilt_rad)), static_cast<Real>(std::cos(tilt_rad)), 0});
    const auto pivot = test.world.create_joint({.kind = JointKind::BallAndSocket, .a = bob});
    ASSERT_TRUE(pivot.ok());
    double lowest = 1;
    for (int i = 0; i < 300; ++i) {
        test.world.step();
        lowest = std::min(lowest, test.at(bob).y);
    }
    EXPECT_LT(lowest, -0.9);
}

TEST(SlowMotion, ASlowCarrierKeepsItsLoad) {
    TestWorld test(in_small_steps());
    const BodyId platform =
        test.add(BoxShape{.size_m = {2, 0.2_r, 2}},
                 {0, -0.1_r, 0},
                 {.kind = BodyKind::Kinematic, .velocity_mps = {0.005_r, 0, 0}});
    const BodyId load = test.add(BoxShape{}, {0, 0.5_r, 0});
    test.run(10.0);
    EXPECT_NEAR(test.at(load).x, test.at(platform).x, 1e-3);
    EXPECT_TRUE(test.world.state(load).awake);
    test.world.set_velocity(platform, {0, 0, 0}, {0, 0, 0});
    test.run(2.0);
    EXPECT_FALSE(test.world.state(load).awake);
}

}  // namespace
}  // namespace plumbline::physics
