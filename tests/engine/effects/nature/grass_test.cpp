// Grass round the eye.
#include "tests/engine/effects/drawn.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

SceneDescription lawn_with_a_slab() {
    SceneDescription scene = test::scene_of(
        {test::ground(),
         test::box("slab", {0, 0.05_r, 0}, {4, 0.1_r, 4}, physics::BodyKind::Static)});
    scene.grass = scene::GrassDescription{.on = {"ground"}, .density_perm2 = 5, .distance_m = 12};
    scene.camera.position_m = {0, 1.7_r, 6};
    return scene;
}

/// The items that are no entity's.
std::vector<render::DrawItem> grown(const render::RenderFrame& frame) {
    return {frame.items.begin() + 2, frame.items.end()};
}

TEST(Grass, GrowsOnWhatItIsToldAndNowhereElse) {
    Running run(lawn_with_a_slab());
    run.game = scene::NoGame{run->description().camera};
    EffectRuntime effects(*run, kImage);
    const auto tufts = grown(draw(run, effects));
    EXPECT_GT(tufts.size(), 200U);
    for (const render::DrawItem& tuft : tufts) {
        const Vec3f root{tuft.world_from_body[3]};
        EXPECT_NEAR(root.y, 0.0F, 1e-3F);
        EXPECT_GT(std::max(std::abs(root.x), std::abs(root.z)), 2.0F - 1e-3F) << "on the slab";
        EXPECT_LT(glm::distance(root, Vec3f{0.0F, 1.7F, 6.0F}), 12.0F);
        EXPECT_FALSE(tuft.casts_shadow);
    }
}

TEST(Grass, LessIsDrawnWhereTheImageMayCostLess) {
    Running run(lawn_with_a_slab());
    run.game = scene::NoGame{run->description().camera};
    EffectRuntime effects(*run, kImage);
    const auto count_with = [&](float cover) {
        effects.refresh(*run);
        const scene::ViewPoint view = run.game.view(*run, Real{1}, 0.0F, 0.0F);
        render::RenderFrame frame = scene::extract(*run, view, 64, 64);
        frame.quality.ground_cover = cover;
        effects.extract(*run, view, frame);
        return grown(frame).size();
    };
    const std::size_t all = count_with(1.0F);
    const std::size_t half = count_with(0.5F);
    EXPECT_LT(half, all / 4) << "half as far, and half of it";
    EXPECT_GT(half, 0U);
    EXPECT_EQ(count_with(0.0F), 0U);
}

}  // namespace
}  // namespace plumbline::effects
