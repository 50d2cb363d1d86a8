// Animations play with the steps.
#include "tests/engine/effects/model_scene.h"

#include <algorithm>
#include <vector>

namespace plumbline::effects {
namespace {

std::vector<float> places_x(const render::RenderFrame& frame) {
    std::vector<float> places;
    for (const render::DrawItem& item : frame.items) places.push_back(item.world_from_body[3].x);
    std::sort(places.begin(), places.end());
    return places;
}

TEST(ModelAnimation, MovesItsPartsWithTheStepsAndRepeats) {
    const TempFolder folder;
    test::Running run(model_scene(folder, sliding_model()));
    EffectRuntime effects(*run, {.frame = true});
    const float ground_x =
        run->registry.get<scene::Transform>(run->find("ground")).world_from_body.position.x;
    run.step(15, effects);  // a quarter of the second
    render::RenderFrame frame = draw(run, effects);
    ASSERT_EQ(frame.items.size(), 3U) << "ground, what stands, what slides; not the model at rest";
    std::vector<float> expected{0.0F, 0.5F, ground_x};
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    run.step(60, effects);  // once round
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);

    for (auto [entity, playing] : run->registry.view<scene::PlayingModel>()) playing.paused = true;
    run.step(7, effects);
    frame = draw(run, effects);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(places_x(frame)[i], expected[i], 1e-4);
}

TEST(ModelAnimation, StandsBetweenTwoStepsAsTheFrameDoes) {
    const TempFolder folder;
    test::Running run(model_scene(folder, sliding_model()));
    EffectRuntime effects(*run, {.frame = true});
    const auto sled_x = [&](Real blend) {
        return draw(run, effects, blend).items.back().world_from_body[3].x;
    };
    EXPECT_NEAR(sled_x(0.5_r), 0.0, 1e-4) << "before the first step";
    run.step(15, effects);  // 2 m a second, 60 steps a second
    EXPECT_NEAR(sled_x(1), 2.0 * 15 / 60, 1e-4);
    EXPECT_NEAR(sled_x(0.5_r), 2.0 * 14.5 / 60, 1e-4);
    EXPECT_NEAR(sled_x(0), 2.0 * 14 / 60, 1e-4);
    run.step(45, effects);  // at its start again
    EXPECT_NEAR(sled_x(0.25_r), 2.0 * 59.25 / 60, 1e-4) << "the rest of the round before";
    for (auto [entity, playing] : run->registry.view<scene::PlayingModel>()) playing.paused = true;
    run.step(1, effects);
    EXPECT_NEAR(sled_x(0.25_r), sled_x(1), 1e-6);
}

}  // namespace
}  // namespace plumbline::effects
