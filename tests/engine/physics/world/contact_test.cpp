#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

TEST(Restitution, RollingFrictionStopsABallAndNoneLetsItRoll) {
    TestWorld test;
    test.ground(1);
    const auto roll = [&test](Real z, Real rolling_friction) {
        return test.add(SphereShape{.radius_m = 0.2_r},
                        {0, 0.2_r, z},
                        {.kind = BodyKind::Dynamic,
                         .velocity_mps = {2, 0, 0},
                         .angular_velocity_radps = {0, 0, -10},
                         .friction = 1,
                         .rolling_friction = rolling_friction});
    };
    const BodyId free = roll(0, 0);
    const BodyId held = roll(5, 0.02_r);
    test.run(4.0);
    EXPECT_NEAR(test.velocity(free).x, 2.0, 0.02);
    EXPECT_NEAR(test.velocity(held).x, 0.0, 0.01);
}

TEST(SmallThings, OneCentimetreCubeRestsOnTheGround) {
    TestWorld test(at_hz(120));
    test.ground();
    const BodyId die = test.add(BoxShape{.size_m = {0.01_r, 0.01_r, 0.01_r}},
                                {0, 0.02_r, 0},
                                {.kind = BodyKind::Dynamic, .mass_kg = 0.002_r});
    test.run(3.0);
    EXPECT_NEAR(test.at(die).y, 0.005, 0.0002) << "gap or overlap below 0.2 mm";
    EXPECT_LT(glm::length(test.velocity(die)), 0.002);
}

TEST(SmallThings, OneCentimetreHullRestsOnABox) {
    TestWorld test(at_hz(120));
    test.add(BoxShape{.size_m = {1, 0.1_r, 1}}, {0, -0.05_r, 0}, {.kind = BodyKind::Static});
    HullShape hull;
    for (const Real x : {-0.005_r, 0.005_r}) {
        for (const Real y : {-0.005_r, 0.005_r}) {
            for (const Real z : {-0.005_r, 0.005_r}) hull.points_m.push_back({x, y, z});
        }
    }
    const BodyId die =
        test.add(hull, {0, 0.02_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 0.002_r});
    test.run(3.0);
    EXPECT_NEAR(test.at(die).y, 0.005, 0.0002);
}

}  // namespace
}  // namespace plumbline::physics
