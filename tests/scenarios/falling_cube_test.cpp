// The cube of the book's chapter: it must fall as Galileo says, and pay for what its file names.

#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

using test::SceneRun;

class FallingCube : public testing::TestWithParam<int> {};

TEST_P(FallingCube, FollowsTheClosedFormUntilItLands) {
    SceneRun run("falling_cube.toml", {.step_hz = GetParam()});
    ASSERT_TRUE(run.simulation);
    const double start_m = static_cast<double>(run.state("cube").world_from_body.position.y);
    const double gravity_mps2 = -static_cast<double>(run.simulation->description().gravity_mps2.y);
    for (int tenth = 1; tenth <= 10; ++tenth) {
        run.step(static_cast<std::uint64_t>(GetParam()) / 10);
        const double time_s = tenth * 0.1;
        const double expected_m = start_m - 0.5 * gravity_mps2 * time_s * time_s;
        EXPECT_NEAR(
            static_cast<double>(run.state("cube").world_from_body.position.y), expected_m, 1e-5)
            << "after " << time_s << " s";
    }
}

INSTANTIATE_TEST_SUITE_P(AtEveryRate, FallingCube, testing::Values(30, 60, 240));

TEST(FallingCubeScene, LandsAndRests) {
    SceneRun run("falling_cube.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 5);
    const physics::BodyState state = run.state("cube");
    EXPECT_FALSE(state.awake);
    EXPECT_LT(static_cast<double>(glm::length(state.velocity_mps)), 1e-3);
}

TEST(FallingCubeScene, ASimulationOfItPaysForNoEffect) {
    SceneRun run("falling_cube.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 3);
    for (const effects::LedgerLine& line : run.effects->ledger()) {
        EXPECT_EQ(line.constructions, 0U) << line.name;
        EXPECT_EQ(line.calls, 0U) << line.name;
        EXPECT_EQ(line.cpu_ms, 0.0) << line.name;
        EXPECT_EQ(line.gpu_ms, 0.0) << line.name;
        EXPECT_EQ(line.bytes_cpu + line.bytes_gpu, 0U) << line.name;
    }
}

TEST(FallingCubeScene, PlayingItPaysForWhatTheFileNames) {
    SceneRun run("falling_cube.toml", {}, {.frame = true, .sound = true});
    ASSERT_TRUE(run.simulation);
    const scene::SceneDescription& scene = run.simulation->description();
    run.step(120);
    for (const effects::LedgerLine& line : run.effects->ledger()) {
        const bool named = (line.name == "sun_shadow" && scene.sun && scene.sun->shadow) ||
                           (line.name == "fog" && scene.fog) ||
                           (line.name == "skybox" && scene.sky) ||
                           (line.name == "post" && scene.post) ||
                           (line.name == "flashlight" && scene.flashlight && scene.flashlight->on);
        EXPECT_EQ(line.constructions, named ? 1U : 0U) << line.name;
    }
}

}  // namespace
}  // namespace plumbline
