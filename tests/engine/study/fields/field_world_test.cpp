// The small scenes of references step as any scene does.
#include "engine/study/fields/field_world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::study {
namespace {

TEST(FieldWorld, FallsAsGravitySaysAndCountsItsTime) {
    scene::SceneDescription scene;
    scene.gravity_mps2 = {0, -10, 0};
    scene.entities.push_back(ball_of("ball", {0, 0, 0}, 0.1, 2));
    FieldWorld world(scene);
    const double start_J = world.energy_J();
    world.run_to(1);
    EXPECT_NEAR(world.time_s(), 1, 1e-9);
    EXPECT_NEAR(world.velocity_mps("ball").y, -10, 1e-4);
    EXPECT_NEAR(world.position_m("ball").y, -5, 1e-4);
    EXPECT_NEAR(world.energy_J(), start_J, 1e-3);
    EXPECT_GT(world.cpu_ms_per_s(), 0);
}

TEST(FieldWorld, PeriodsAreFoundBetweenSteps) {
    scene::SceneDescription scene;
    scene.entities.push_back(ball_of("ball", {0, 0, 0}, 0.1, 2));
    FieldWorld world(scene);
    const double found_s = period_s(
        world, 5, [&world] { return std::cos(2 * 3.14159265358979 * world.time_s() / 0.7); });
    EXPECT_NEAR(found_s, 0.7, 1e-3);
    EXPECT_EQ(period_s(world, 6, [] { return 1.0; }), 0) << "never crosses";
}

}  // namespace
}  // namespace plumbline::study
