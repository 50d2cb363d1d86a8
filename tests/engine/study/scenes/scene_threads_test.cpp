#include "engine/study/scenes/scene_threads.h"

#include "tests/engine/study/scenes/scene_run_fixture.h"

#include <fmt/format.h>

namespace plumbline::study {
namespace {

/// Enough bodies for helpers to be woken: ten towers of eight.
std::string towers() {
    std::string text;
    for (int tower = 0; tower < 10; ++tower) {
        for (int box = 0; box < 8; ++box)
            text += fmt::format(
                "[[entity]]\nname = \"box_{0}_{1}\"\nposition_m = [{2}, {3}, "
                "0]\n[entity.body]\nkind = "
                "\"dynamic\"\nshape = {{ box = [0.5, 0.5, 0.5] }}\nmass_kg = 1\n",
                tower,
                box,
                3 * tower,
                1.02 * box + 0.6);
    }
    return text +
           "[[entity]]\nname = \"ground\"\n[entity.body]\nkind = \"static\"\nshape = { plane = "
           "[100, 100] }\n";
}

class SceneThreadsTest : public SceneRunTest {};

TEST_F(SceneThreadsTest, ARunWithHelpersIsTheSameRun) {
    SceneRun run = run_of(towers());
    const Result<SceneAnswer> alone = SceneRunner().run(run);
    ASSERT_TRUE(alone) << alone.error().message;
    run.threads = 3;
    const Result<SceneAnswer> helped = SceneRunner().run(run);
    ASSERT_TRUE(helped);
    for (std::size_t i = 0; i < alone->traces[0].moments.size(); ++i) {
        const Moment& a = alone->traces[0].moments[i];
        const Moment& b = helped->traces[0].moments[i];
        ASSERT_EQ(a.bodies.size(), 80U);
        for (std::size_t k = 0; k < a.bodies.size(); ++k) {
            EXPECT_EQ(a.bodies[k].position_m, b.bodies[k].position_m);
            EXPECT_EQ(a.bodies[k].orientation, b.bodies[k].orientation);
        }
    }
    EXPECT_GT(alone->cost.clock_ms_per_s, 0);
    EXPECT_GT(helped->cost.clock_ms_per_s, 0);
}

// The programs are not beside the tests (tests/e2e/study.py runs them): refused before anything ran.
TEST_F(SceneThreadsTest, NoNumbersNoPointsAndNoProgramNoStudy) {
    ScenePlan plan(10, {.count = 1}, {});
    SceneProbe probe;
    probe.scene = run_of(kFalling).scene;
    probe.moments = {15, 30};
    const auto none = measure_threads(plan, probe, {});
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->empty());
    const auto refused = measure_threads(plan, probe, std::vector{1, 2});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("need the program"), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
