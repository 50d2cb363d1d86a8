// A thousand crates come down: nothing explodes, nothing sinks, all is quiet in the end.

#include "engine/physics/totals.h"
#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

using test::SceneRun;

TEST(Pile, ComesDownWithoutGainingEnergy) {
    SceneRun run("pile.toml");
    ASSERT_TRUE(run.simulation);
    const physics::PhysicsWorld& world = run.simulation->physics;
    EXPECT_EQ(run.simulation->moving_bodies().size(), 1000U);
    const auto energy_J = [&] { return physics::energy(world).total_J(); };
    const double start_J = energy_J();
    for (int second = 0; second < 3; ++second) {
        run.step(60);
        EXPECT_LT(energy_J(), start_J) << "in second " << second;
    }
    EXPECT_EQ(world.report().isolated.size(), 0U);
    EXPECT_EQ(run.simulation->tally().removed, 0U);
    EXPECT_LT(max_penetration_m(world), 0.01);
}

TEST(Pile, GoesToSleep) {
    SceneRun run("pile.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 10);
    EXPECT_EQ(physics::energy(run.simulation->physics).kinetic_J, 0.0);
    for (const scene::MovingBody& body : run.simulation->moving_bodies()) {
        const physics::BodyState state = run.simulation->physics.state(body.body);
        ASSERT_FALSE(state.awake);
        // Ten layers of 1 m, none sunk and none thrown off.
        ASSERT_GT(state.world_from_body.position.y, 0.45_r);
        ASSERT_LT(state.world_from_body.position.y, Real{10});
    }
}

}  // namespace
}  // namespace plumbline
