// The time of models that move.
#include "tests/engine/scene/build/moving_model.h"

namespace plumbline::scene {
namespace {

TEST(ModelBodies, AreNotPulledThroughWhatStandsBehindWhenTheyBeginAnew) {
    const TempFolder folder;
    EntityDescription behind = test::box("behind", {0.9_r, 0.2_r, 0}, {0.2_r, 0.4_r, 2});
    behind.world_from_body.position = {-0.2_r, 0.2_r, 0};
    test::Running run(test::scene_of({test::ground(), moving_model(folder, sled()), behind}));
    run.step(75);
    EXPECT_LT(glm::length(run.state("behind").velocity_mps), 0.05);
    EXPECT_NEAR(run.state("behind").world_from_body.position.x, -0.2, 0.02);
}

TEST(ModelBodies, StopWithTheAnimation) {
    const TempFolder folder;
    test::Running run(test::scene_of({moving_model(folder, sled())}));
    run.step(15);
    for (auto [entity, playing] : run->registry.view<PlayingModel>()) playing.paused = true;
    run.step(15);
    const physics::BodyState plate = run.state("model/plate");
    EXPECT_NEAR(plate.world_from_body.position.x, 0.5, 1e-4);
    EXPECT_NEAR(glm::length(plate.velocity_mps), 0, 1e-6);
}

TEST(SimulationModels, TimeGoesRoundWithinTheAnimation) {
    const TempFolder folder;
    EntityDescription shown = moving_model(folder, sled());
    shown.body.reset();
    test::Running run(test::scene_of({shown}));
    auto& playing = run->registry.get<PlayingModel>(run->find("model"));
    run->set_time(3.25);
    EXPECT_NEAR(playing.time_s, 0.25, 1e-12) << "it takes a second";
    EXPECT_DOUBLE_EQ(run->time_s(), 3.25);
    run.step(60);
    EXPECT_NEAR(playing.time_s, 0.25, 1e-9);
    EXPECT_NEAR(run->time_s(), 4.25, 1e-9);
    EXPECT_DOUBLE_EQ(playing.latest_step_s, run->step_s());
    playing.paused = true;
    run.step(30);
    EXPECT_NEAR(playing.time_s, 0.25, 1e-9);
    EXPECT_EQ(playing.latest_step_s, 0);
}

}  // namespace
}  // namespace plumbline::scene
