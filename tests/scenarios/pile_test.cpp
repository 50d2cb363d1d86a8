// A thousand crates come down: nothing explodes, nothing sinks, all is quiet in the end.

#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

using test::SceneRun;

TEST(Pile, ComesDownWithoutGainingEnergy) {
    SceneRun run("pile.toml");
    ASSERT_TRUE(run.simulation);
    EXPECT_EQ(run.simulation->moving_bodies().size(), 1000U);
    const auto energy_J = [&] {
        const physics::Energy energy = run.simulation->physics.energy();
        return energy.kinetic_J + energy.potential_J;
    };
    double before_J = energy_J();
    for (int second = 0; second < 3; ++second) {
        run.step(60);
        EXPECT_LE(energy_J(), before_J * 1.001) << "in second " << second;
        before_J = energy_J();
    }
    EXPECT_EQ(run.simulation->physics.quarantined().size(), 0U);
    EXPECT_EQ(run.simulation->removed_count(), 0U);
    for (const scene::MovingBody& body : run.simulation->moving_bodies()) {
        const Pose pose = run.simulation->physics.state(body.body).world_from_body;
        ASSERT_TRUE(is_finite(pose));
        ASSERT_GT(pose.position.y, Real{0}) << "a crate's centre is under the ground";
    }
}

}  // namespace
}  // namespace plumbline
