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

/// Two cubes of 0.2 m, 0.6 m apart along z, as one body.
CompoundShape two_cubes() {
    const BoxShape cube{.size_m = {0.2_r, 0.2_r, 0.2_r}};
    return {.children = {{.shape = cube, .body_from_child = {.position = {0, 0, -0.3_r}}},
                         {.shape = cube, .body_from_child = {.position = {0, 0, 0.3_r}}}}};
}

TEST(PartTraits, ASledOfOneSmoothAndOneRoughRunnerSlowsDownByHalfItsWeight) {
    TestWorld test(in_small_steps());
    test.ground();
    const Material smooth{};
    const Material rough{.friction = 0.2_r, .friction_rule = CombineRule::Maximum};
    const BodyId sled = test.add(two_cubes(),
                                 {0, 0.1_r, 0},
                                 {.kind = BodyKind::Dynamic,
                                  .velocity_mps = {2, 0, 0},
                                  .friction = 9,
                                  .parts = {{.material = smooth}, {.material = rough}}});
    test.run(0.1);
    EXPECT_LT(test.world.state(sled).angular_velocity_radps.y, -0.1_r)
        << "it turns to the rough side";
    EXPECT_NEAR(test.velocity(sled).x, 2 - 0.5 * 0.5 * 9.81 * 0.1, 0.01)
        << "the rough one: the larger coefficient, which is the ground's 0.5";
}

TEST(PartTraits, APartTouchesWhatItsFilterSaysHoweverFast) {
    constexpr std::uint32_t kWall = 2;
    const PartTraits through{.filter = {.group = 4, .collides_with = ~kWall}};
    const PartTraits stops{.filter = {.group = 4}};
    for (const bool any : {false, true}) {
        TestWorld test(in_small_steps());
        test.add(BoxShape{.size_m = {0.05_r, 9, 9}},
                 {2, 0, 0},
                 {.kind = BodyKind::Static, .filter = {.group = kWall}});
        const BodyId body = test.add(two_cubes(),
                                     {0, 0, 0},
                                     {.kind = BodyKind::Dynamic,
                                      .velocity_mps = {200, 0, 0},
                                      .filter = {.group = 4},
                                      .parts = {through, any ? stops : through}});
        test.run(0.1);
        EXPECT_EQ(test.at(body).x > 2.1, !any);
    }
}

}  // namespace
}  // namespace plumbline::physics
