// The air that things feel: wind, zones and their switch.
#include "engine/effects/fields/air.h"

#include "tests/engine/effects/fields/in_fields.h"

namespace plumbline::effects {
namespace {

TEST(Air, ZonesBlowInsideTheirBox) {
    scene::SceneDescription scene = test::scene_of({});
    scene.forces.wind_zones = {{.min_m = {0, 0, 0}, .max_m = {1, 1, 1}, .velocity_mps = {0, 0, 5}}};
    test::Running run(scene);
    const Air air(*run);
    EXPECT_TRUE(air.blows());
    EXPECT_NEAR(air.at({0.5, 0.5, 0.5}, 0).z, 5, 1e-6);
    EXPECT_NEAR(air.at({1.5, 0.5, 0.5}, 0).z, 0, 1e-6);
    run->switches.turn("wind", false);
    EXPECT_FALSE(Air(*run).blows());
}

TEST(Air, AShareOfTheWindBlowsInAZone) {
    scene::SceneDescription scene = test::scene_of({});
    scene.wind = scene::WindDescription{.direction = {1, 0, 0}, .speed_mps = 8, .gusts = 0};
    scene.forces.wind_zones = {
        {.min_m = {0, 0, 0}, .max_m = {2, 1, 1}, .wind_share = 0.5_r},
        {.min_m = {1, 0, 0}, .max_m = {2, 1, 1}, .velocity_mps = {0, 0, 5}, .wind_share = 0}};
    test::Running run(scene);
    const Air air(*run);
    EXPECT_NEAR(air.at({-1, 0.5, 0.5}, 0).x, 8, 1e-5);
    EXPECT_NEAR(air.at({0.5, 0.5, 0.5}, 0).x, 4, 1e-5);
    EXPECT_EQ(air.at({1.5, 0.5, 0.5}, 0), (Vec3d{0, 0, 5}));
}

TEST(Air, StandsStillWhereNothingBlows) {
    test::Running run(test::scene_of({}));
    EXPECT_FALSE(Air(*run).blows());
    EXPECT_EQ(Air(*run).at({0, 0, 0}, 1), (Vec3d{0, 0, 0}));
}

TEST(Air, WindReachesAShareOfIt) {
    scene::SceneDescription scene = test::scene_of({});
    scene.wind = scene::WindDescription{.direction = {1, 0, 0}, .speed_mps = 8, .gusts = 0};
    test::Running run(scene);
    EXPECT_NEAR(Air(*run).at({0, 0, 0}, 0, 0.25).x, 2, 1e-5);
}

}  // namespace
}  // namespace plumbline::effects
