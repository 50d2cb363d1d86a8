// The garden report's scene keeps its promises: its mill turns and pushes.
#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

using test::SceneRun;

// SOURCES B35: a turn in 8 s. What stands under the sails is struck by their ends, 1.86 m away from the
// axis at 2 pi / 8 rad/s: 1.5 m/s, which nothing leaves at more than twice.
TEST(Nature, TheMillPushesTheCratesAway) {
    SceneRun run("nature.toml");
    ASSERT_TRUE(run.simulation);
    EXPECT_TRUE(run.simulation->warnings.empty()) << run.simulation->warnings.front();
    const Vec3 first = run.state("mill_crate_1").world_from_body.position;
    const Vec3 second = run.state("mill_crate_2").world_from_body.position;
    const Quat start = run.state("mill/sail_1").world_from_body.orientation;
    Real fastest_mps = 0;
    for (int i = 0; i < 60 * 2; ++i) {
        run.step(1);
        for (const char* crate : {"mill_crate_1", "mill_crate_2"})
            fastest_mps = std::max(fastest_mps, glm::length(run.state(crate).velocity_mps));
    }
    const Quat turn = run.state("mill/sail_1").world_from_body.orientation * glm::conjugate(start);
    EXPECT_NEAR(2 * std::acos(std::abs(turn.w)), kPi / 2, 0.01) << "a quarter in 2 s";
    EXPECT_NEAR(glm::length(run.state("mill/sail_1").angular_velocity_radps), kPi / 4, 0.01);
    run.step(60 * 8);
    const Real moved_m = glm::distance(run.state("mill_crate_1").world_from_body.position, first) +
                         glm::distance(run.state("mill_crate_2").world_from_body.position, second);
    EXPECT_GT(moved_m, 0.3);
    EXPECT_GT(fastest_mps, 0.3);
    EXPECT_LT(fastest_mps, 3);
}

}  // namespace
}  // namespace plumbline
