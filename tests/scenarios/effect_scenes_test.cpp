// Each effect that bodies feel has a scene of its name, whose marks stand where its formula puts things.
#include "tests/scenarios/scene_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline {
namespace {

using test::SceneRun;

class EffectScene : public testing::TestWithParam<std::string_view> {};

// Those of the image and the fountain's drops come after the first twelve.
INSTANTIATE_TEST_SUITE_P(All,
                         EffectScene,
                         testing::ValuesIn(scene::effects_with_fidelity().first(12)),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(EffectScene, CallsForItsEffect) {
    SceneRun run("effects/" + std::string(GetParam()) + ".toml");
    ASSERT_TRUE(run.simulation);
    EXPECT_TRUE(run.simulation->warnings.empty()) << run.simulation->warnings.front();
    run.step(180);
    bool made = false;
    for (const effects::LedgerLine& line : run.effects->ledger())
        made |= line.name == GetParam() && line.constructions > 0;
    // Wind by itself is what bends leaves; a zone is felt by what drag is told of.
    EXPECT_TRUE(made || GetParam() == "wind");
    EXPECT_TRUE(run.simulation->warnings.empty()) << run.simulation->warnings.front();
}

double height_m(SceneRun& run, const char* name) {
    return static_cast<double>(run.state(name).world_from_body.position.y);
}

double mark_m(const SceneRun& run, const std::string& name) {
    const ecs::Entity mark = run.simulation->find(name);
    return static_cast<double>(
        run.simulation->registry.get<scene::Transform>(mark).world_from_body.position.y);
}

TEST(EffectScenes, BallsInTheWindHangAtTheirMarks) {
    SceneRun run("effects/wind.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 30);
    for (const char* name : {"light", "middle", "heavy"})
        EXPECT_NEAR(height_m(run, name), mark_m(run, std::string("mark ") + name), 0.01) << name;
}

TEST(EffectScenes, BlocksGoUnderByTheirDensity) {
    SceneRun run("effects/buoyancy.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 30);
    for (const int density : {250, 500, 750}) {
        const std::string name = "block " + std::to_string(density);
        EXPECT_NEAR(height_m(run, name.c_str()), 1.2 + 0.2 - 0.4 * density / 1000, 0.002) << name;
    }
    EXPECT_NEAR(height_m(run, "block 1200"), 0.2, 0.001) << "on the ground";
}

TEST(EffectScenes, TheRopeHangsAsACatenary) {
    SceneRun run("effects/rope.toml");
    ASSERT_TRUE(run.simulation);
    run.step(60 * 10);
    double lowest_m = 9;
    for (const Vec3d& at : run.simulation->points_of(run.simulation->ropes().front()))
        lowest_m = std::min(lowest_m, at.y);
    EXPECT_NEAR(lowest_m, mark_m(run, "mark 4"), 0.005);
}

}  // namespace
}  // namespace plumbline
