// Nothing fast is ever seen on the other side.
#include "engine/physics/dynamics/body_sweep.h"

#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

WorldDef at_rate(double hz, const Vec3& gravity_mps2 = {0, 0, 0}) {
    WorldDef def = in_small_steps(2);
    def.substeps_max = 16;
    def.step_s = 1 / hz;
    def.gravity_mps2 = gravity_mps2;
    return def;
}

TEST(BodySweep, PlatesAt300MpsStopAtAWallOfTwoCentimetres) {
    for (const double hz : {30.0, 60.0, 240.0}) {
        TestWorld test(at_rate(hz));
        test.add(BoxShape{{0.02_r, 20, 60}}, {0, 0, 0}, {.kind = BodyKind::Static});
        std::vector<BodyId> plates;
        for (int i = 0; i < 25; ++i) {
            const auto k = static_cast<Real>(i);
            plates.push_back(test.add(BoxShape{{0.02_r, 0.4_r, 0.4_r}},
                                      {-6 - k * 0.21_r, 0, -24 + 2 * k},
                                      {.kind = BodyKind::Dynamic,
                                       .velocity_mps = {300, 0, 0},
                                       .angular_velocity_radps = {0, 10 + k, 5}}));
        }
        test.run(0.3);
        for (const BodyId plate : plates) EXPECT_LT(test.at(plate).x, 0) << hz;
    }
}

TEST(BodySweep, ARodWhoseTipHasAHundredMpsIsHeldByAPost) {
    for (const double hz : {60.0, 240.0}) {
        for (int i = 0; i < 6; ++i) {
            TestWorld test(at_rate(hz));
            const double angle = 0.3 + 0.1 * i;
            const Vec3 place{static_cast<Real>(1.5 * std::cos(angle)),
                             0,
                             static_cast<Real>(-1.5 * std::sin(angle))};
            test.add(BoxShape{{0.1_r, 4, 0.1_r}}, place, {.kind = BodyKind::Static});
            const BodyId rod =
                test.add(BoxShape{{4, 0.04_r, 0.04_r}},
                         {0, 0, 0},
                         {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 50, 0}});
            test.run(0.1);
            EXPECT_LT(test.spin(rod).y, 45) << hz << " Hz, post " << i;
        }
    }
}

TEST(BodySweep, ABallBetweenClosingPlatesStaysBetweenThem) {
    TestWorld test(at_rate(60));
    const BodyId ball = test.add(SphereShape{0.1_r}, {0, 0, 0});
    const BodyId low =
        test.add(BoxShape{{2, 0.05_r, 2}},
                 {0, -2, 0},
                 {.kind = BodyKind::Dynamic, .mass_kg = 5, .velocity_mps = {0, 40, 0}});
    const BodyId high =
        test.add(BoxShape{{2, 0.05_r, 2}},
                 {0, 2, 0},
                 {.kind = BodyKind::Dynamic, .mass_kg = 5, .velocity_mps = {0, -40, 0}});
    for (int i = 0; i < 60; ++i) {
        test.world.step();
        EXPECT_LT(test.at(low).y, test.at(ball).y);
        EXPECT_GT(test.at(high).y, test.at(ball).y);
    }
}

TEST(BodySweep, WhatSlidesFastOverAFloorKeepsItsSpeed) {
    TestWorld test(at_rate(60, {0, -9.81_r, 0}));
    test.add(BoxShape{{400, 1, 400}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static, .friction = 0});
    const BodyId plate = test.add(
        BoxShape{{0.4_r, 0.02_r, 0.4_r}},
        {-100, 0.01_r, 0},
        {.kind = BodyKind::Dynamic, .velocity_mps = {50, 0, 0}, .friction = 0, .can_sleep = false});
    test.run(2);
    EXPECT_NEAR(test.at(plate).x, 0, 0.1);
    EXPECT_NEAR(test.velocity(plate).x, 50, 1e-3);
}

TEST(BodySweep, ABounceAfterASweepHasItsWholeSpeed) {
    TestWorld test(at_rate(60));
    test.add(BoxShape{{0.1_r, 10, 10}}, {0, 0, 0}, {.kind = BodyKind::Static, .restitution = 1});
    const BodyId box =
        test.add(BoxShape{{0.2_r, 0.2_r, 0.2_r}},
                 {-5, 0, 0},
                 {.kind = BodyKind::Dynamic, .velocity_mps = {100, 0, 0}, .restitution = 1});
    test.run(0.2);
    EXPECT_NEAR(test.velocity(box).x, -100, 1);
}

}  // namespace
}  // namespace plumbline::physics
