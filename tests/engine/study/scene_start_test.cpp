#include "engine/study/scene_start.h"

#include "engine/scene/build/entity_builder.h"
#include "engine/scene/level/shipped_things.h"
#include "tests/scenarios/scene_run.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace plumbline::study {
namespace {

class SceneStartTest : public testing::Test {
protected:
    /// As a worker has it, after what was written was read.
    PlayedScene played_from(const SceneStart& start, const Setting& setting) {
        const Result<scene::OpenedScene> opened = open_for_study(
            test::repository() / "assets/scenes/bench/peers/heavy10.toml", overrides(setting));
        EXPECT_TRUE(opened);
        Result<PlayedScene> scene = PlayedScene::create(*opened, library_);
        EXPECT_TRUE(scene);
        EXPECT_TRUE(write_start(file_, start));
        const Result<SceneStart> read = read_start(file_);
        EXPECT_TRUE(read);
        EXPECT_TRUE(take_up(*read, *scene));
        scene->start();
        return std::move(*scene);
    }

    assets::AssetLibrary library_;
    test::TemporaryFolder folder_;
    std::filesystem::path file_{folder_ / "start"};
    test::ScopedVariable data_{"PLUMBLINE_DATA", PL_SOURCE_DIR};
};

TEST_F(SceneStartTest, GoesOnToTheSameBits) {
    test::SceneRun run("bench/peers/heavy10.toml");
    run.step(30);
    PlayedScene scene = played_from(scene_start_of(*run.simulation), {});
    EXPECT_DOUBLE_EQ(scene.simulation().time_s(), 0.5);
    run.step(30);
    for (int i = 0; i < 30; ++i) scene.step();
    for (std::size_t i = 0; i < run.simulation->moving_bodies().size(); ++i) {
        const auto pose_in = [i](const scene::Simulation& simulation) {
            return simulation.physics.state(simulation.moving_bodies()[i].body).world_from_body;
        };
        EXPECT_EQ(pose_in(scene.simulation()).position, pose_in(*run.simulation).position);
        EXPECT_EQ(pose_in(scene.simulation()).orientation, pose_in(*run.simulation).orientation);
    }
}

TEST_F(SceneStartTest, TheAccuracyIsTheRunsOwn) {
    test::SceneRun run("bench/peers/heavy10.toml");
    run.step(30);
    const PlayedScene scene = played_from(scene_start_of(*run.simulation), {.step_hz = 240});
    EXPECT_NEAR(scene.simulation().step_s(), 1.0 / 240, 1e-9);
}

TEST_F(SceneStartTest, HasTheThingsThatPlayPutThere) {
    test::SceneRun run("bench/peers/heavy10.toml");
    run.step(30);
    const scene::SceneDescription shipped = scene::shipped_things(test::repository() / "assets");
    const auto put = [&](const char* prefab, const Vec3& position) {
        run.simulation->builder().lend_materials(shipped.materials);
        const ecs::Entity entity =
            run.simulation->spawn(scene::thing_of(shipped.prefabs.at(prefab), prefab));
        run.simulation->registry.add<scene::Dropped>(entity, scene::Dropped{});
        const physics::BodyId body = run.simulation->registry.get<scene::BodyRef>(entity).body;
        run.simulation->physics.set_pose(body, {.position = position});
        return body;
    };
    const physics::BodyId flying = put("ball", {3, 9, 1});
    run.simulation->physics.set_velocity(flying, {1, 2, 3}, {4, 5, 6});
    const physics::BodyId frozen = put("crate", {-3, 9, 1});
    run.simulation->physics.set_frozen(frozen, true);

    PlayedScene scene = played_from(scene_start_of(*run.simulation), {});
    const auto body_in = [&](const char* name) {
        const ecs::Entity entity = scene.simulation().find(name);
        return scene.simulation().registry.get<scene::BodyRef>(entity).body;
    };
    run.step(30);
    for (int i = 0; i < 30; ++i) scene.step();
    const physics::BodyState here = run.simulation->physics.state(flying);
    const physics::BodyState there = scene.simulation().physics.state(body_in("ball#1"));
    EXPECT_EQ(here.world_from_body.position, there.world_from_body.position);
    EXPECT_EQ(here.angular_velocity_radps, there.angular_velocity_radps);
    EXPECT_EQ(here.mass.mass_kg, there.mass.mass_kg);
    EXPECT_EQ(scene.simulation().physics.state(body_in("crate#1")).world_from_body.position,
              Vec3(-3, 9, 1))
        << "it is frozen";
}

TEST_F(SceneStartTest, RefusesWhatIsNone) {
    EXPECT_FALSE(read_start("/nowhere/at/all"));
    std::ofstream(file_) << "no state";
    const Result<SceneStart> start = read_start(file_);
    ASSERT_FALSE(start);
    EXPECT_NE(start.error().message.find(file_.string()), std::string::npos);
}

}  // namespace
}  // namespace plumbline::study
