// What slides over level seams, flies past edges or lands on layers meets only what is there.
#include "tests/engine/physics/test_world.h"

#include <algorithm>
#include <cmath>

namespace plumbline::physics {
namespace {

constexpr Quat kAlongZ{0.70710678_r, 0.70710678_r, 0, 0};  ///< an upright axis laid down

struct Slider {
    const char* name;
    ShapeDef shape;
    Real height_m;  ///< of its centre
    Quat turn{kNoRotation};
};

HullShape tapered() {
    HullShape hull;
    for (const Real x : {Real{-1}, Real{1}}) {
        for (const Real z : {Real{-1}, Real{1}}) {
            hull.points_m.push_back({0.5_r * x, -0.3_r, 0.4_r * z});
            hull.points_m.push_back({0.4_r * x, 0.3_r, 0.3_r * z});
        }
    }
    return hull;
}

std::vector<Slider> sliders() {
    return {{"cube", BoxShape{{1, 1, 1}}, 0.5_r},
            {"plate", BoxShape{{1, 0.2_r, 0.6_r}}, 0.1_r},
            {"ball", SphereShape{.radius_m = 0.4_r}, 0.4_r},
            {"lying capsule", CapsuleShape{.radius_m = 0.3_r, .height_m = 0.4_r}, 0.3_r, kAlongZ},
            {"standing cylinder", CylinderShape{.radius_m = 0.4_r, .height_m = 0.8_r}, 0.4_r},
            {"lying cylinder", CylinderShape{.radius_m = 0.4_r, .height_m = 0.8_r}, 0.4_r, kAlongZ},
            {"hull", tapered(), 0.3_r}};
}

BodyDef smooth(Real speed_mps, const Slider& slider) {
    BodyDef body{.kind = BodyKind::Dynamic,
                 .velocity_mps = {speed_mps, 0, 0},
                 .friction = 0,
                 .can_sleep = false};
    body.world_from_body.orientation = slider.turn;
    return body;
}

/// Twelve tiles in a row of two, whose tops are level; `step_m`: how much higher than the one before the seventh and all
/// after it lie.
void add_tiles(TestWorld& test, Real step_m) {
    for (int x = 0; x < 12; ++x) {
        for (const Real z : {-0.5_r, 0.5_r}) {
            test.add(BoxShape{{1, 0.5_r, 1}},
                     {static_cast<Real>(x) + 0.5_r, -0.25_r + (x < 6 ? 0 : step_m), z},
                     {.kind = BodyKind::Static, .friction = 0});
        }
    }
}

WorldDef at_rate(int hz) {
    WorldDef def = in_small_steps();
    def.step_s = 1.0 / hz;
    return def;
}

TEST(GhostContacts, WhatSlidesOverLevelTilesKeepsItsSpeedAndHeight) {
    for (const int hz : {30, 60, 240}) {
        for (const Slider& slider : sliders()) {
            for (const Real start_m : {0.93_r, 1.21_r, 1.5_r, 1.77_r}) {
                SCOPED_TRACE(::testing::Message()
                             << slider.name << " from " << start_m << " at " << hz << " Hz");
                TestWorld test(at_rate(hz));
                add_tiles(test, 0);
                const BodyId body =
                    test.add(slider.shape, {start_m, slider.height_m, 0.13_r}, smooth(7, slider));
                Real up_mps = 0;
                for (int step = 0; step < hz; ++step) {
                    test.world.step();
                    up_mps = std::max(up_mps, test.world.state(body).velocity_mps.y);
                }
                EXPECT_NEAR(test.velocity(body).x, 7, 0.01);
                EXPECT_LT(up_mps, 0.05_r);
                EXPECT_NEAR(test.at(body).y, static_cast<double>(slider.height_m), 0.003);
            }
        }
    }
}

TEST(GhostContacts, AStepOfATwentiethOfACubeStopsIt) {
    TestWorld test(in_small_steps());
    add_tiles(test, 0.05_r);
    const Slider cube = sliders().front();
    const BodyId body = test.add(cube.shape, {4.3_r, 0.5_r, 0.13_r}, smooth(2, cube));
    test.run(1);
    EXPECT_LT(test.at(body).x, 5.6) << "its front is at the step";
    EXPECT_LT(test.velocity(body).x, 0.5);
}

TEST(GhostContacts, ACrateThatIsPushedAcrossASeamFromRestMoves) {
    TestWorld test(in_small_steps());
    add_tiles(test, 0);
    const Slider cube = sliders().front();
    // Its front stands just at the edge of the next tile. It is 1 kg.
    const BodyId body = test.add(cube.shape, {2.5_r, 0.5_r, 0}, smooth(0, cube));
    test.run(0.5);
    for (int step = 0; step < 60; ++step) {
        test.world.apply_force(body, {0.5_r, 0, 0});
        test.world.step();
    }
    EXPECT_NEAR(test.velocity(body).x, 0.5, 0.005);
    EXPECT_NEAR(test.at(body).x, 2.5 + 0.25, 0.005);
}

TEST(GhostContacts, WhatFliesPastAnEdgeIsNotStopped) {
    for (const Slider& slider : sliders()) {
        SCOPED_TRACE(slider.name);
        WorldDef def = in_small_steps();
        def.gravity_mps2 = {0, 0, 0};
        TestWorld test(def);
        test.add(BoxShape{{2, 2, 2}}, {0, -1, 0}, {.kind = BodyKind::Static});
        // Its lowest point passes the edge at x = -1 by 1.5 cm.
        const BodyId body =
            test.add(slider.shape, {-3.07_r, slider.height_m + 0.015_r, 0}, smooth(9, slider));
        test.run(0.5);
        EXPECT_NEAR(test.velocity(body).x, 9, 1e-4);
        EXPECT_NEAR(test.at(body).x, -3.07 + 4.5, 1e-3);
    }
}

TEST(GhostContacts, ABallBouncesOffTheUpperOfTwoLayers) {
    for (const Real speed_mps : {Real{10}, Real{22}, Real{27}, Real{29}}) {
        SCOPED_TRACE(speed_mps);
        WorldDef def = in_small_steps(2);
        def.gravity_mps2 = {0, 0, 0};
        TestWorld test(def);
        test.add(BoxShape{{20, 2, 20}}, {0, -1, 0}, {.kind = BodyKind::Static, .restitution = 1});
        // The ground, 10 cm below the floor's top.
        test.add(
            BoxShape{{20, 2, 20}}, {0, -1.1_r, 0}, {.kind = BodyKind::Static, .restitution = 0});
        const BodyId ball = test.add(SphereShape{.radius_m = 0.5_r},
                                     {0, 1.072_r, 0},
                                     {.kind = BodyKind::Dynamic,
                                      .velocity_mps = {0, -speed_mps, 0},
                                      .friction = 0,
                                      .restitution = 1});
        test.run(0.1);
        const double down_s = 0.572 / static_cast<double>(speed_mps);
        EXPECT_NEAR(test.velocity(ball).y, static_cast<double>(speed_mps), 1e-4);
        EXPECT_NEAR(test.at(ball).y, 0.5 + static_cast<double>(speed_mps) * (0.1 - down_s), 1e-3);
    }
}

TEST(GhostContacts, ACapsuleHalfOverAnEdgeIsHeldUpToIt) {
    TestWorld test(in_small_steps());
    test.add(BoxShape{{4, 1, 4}}, {0, -0.5_r, 0}, {.kind = BodyKind::Static});
    const Slider capsule{"capsule", CapsuleShape{.radius_m = 0.1_r, .height_m = 1}, 0.1_r, kAlongZ};
    // Its centre is 5 cm within the edge at z = 2.
    const BodyId body = test.add(capsule.shape, {0, 0.1_r, 1.95_r}, smooth(0, capsule));
    test.run(3);
    EXPECT_NEAR(test.at(body).y, 0.1, 0.002);
    EXPECT_NEAR(test.at(body).z, 1.95, 0.002);
}

}  // namespace
}  // namespace plumbline::physics
