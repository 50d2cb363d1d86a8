// Wind, grass and flocks: what they add to a frame, where, and that nobody pays who does not call.
#include "engine/effects/nature/grass_tufts.h"
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

constexpr std::size_t kAllTufts = std::numeric_limits<std::size_t>::max();

TEST(NatureEffects, NobodyWhoDoesNotCallForThemPays) {
    Running run(test::scene_of({test::ground()}));
    EffectRuntime effects(*run, kImage);
    run.step(2, effects);
    const render::RenderFrame frame = draw(run, effects);
    EXPECT_FALSE(frame.wind);
    EXPECT_EQ(frame.items.size(), 1U) << "the ground";
    for (const char* name : {"wind", "grass", "flock"}) {
        const LedgerLine line = line_of(effects, name);
        EXPECT_EQ(line.constructions, 0U) << name;
        EXPECT_EQ(line.calls, 0U) << name;
        EXPECT_EQ(line.bytes_cpu, 0U) << name;
    }
}

TEST(NatureEffects, TheWindOfTheSceneIsTheWindOfTheFrame) {
    SceneDescription scene = test::scene_of({});
    scene.wind = scene::WindDescription{.direction = {0, 0, -1},
                                        .speed_mps = 6,
                                        .gusts = 0.5_r,
                                        .location = in_file("garden.toml", 30)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.wind);
    EXPECT_EQ(frame.wind->mean_mps, (Vec2f{0.0F, -6.0F}));
    EXPECT_NEAR(frame.wind->gusts[0].speed_mps + frame.wind->gusts[1].speed_mps, 3.0F, 1e-5F);
    EXPECT_EQ(line_of(effects, "wind").called_for_by, Callers{"[wind] (garden.toml:30)"});
    run->switches.turn("wind", false);
    EXPECT_FALSE(draw(run, effects).wind);
}

TEST(GrassField, TheSamePlaceGrowsTheSameWhicheverWayOneComes) {
    const LawnAt flat = [](float, float) { return 0.25F; };
    const scene::GrassDescription grass{.density_perm2 = 4};
    GrassField here(grass);
    here.follow({0.0F, 1.7F, 0.0F}, 8.0F, kAllTufts, flat);
    GrassField walked(grass);
    for (float x = 40.0F; x >= 0.0F; x -= 0.5F)
        walked.follow({x, 1.7F, 0.0F}, 8.0F, kAllTufts, flat);
    ASSERT_FALSE(here.cells().empty());
    std::size_t tufts = 0;
    for (const auto& [cell, grown] : here.cells()) {
        const auto& other = walked.cells().at(cell);
        ASSERT_EQ(grown.size(), other.size());
        for (std::size_t i = 0; i < grown.size(); ++i) {
            EXPECT_EQ(grown[i].root_world, other[i].root_world);
            EXPECT_EQ(grown[i].root_world.y, 0.25F);
        }
        tufts += grown.size();
    }
    const double area_m2 = 4.0 * static_cast<double>(here.cells().size());
    EXPECT_NEAR(static_cast<double>(tufts), 4.0 * area_m2, 0.05 * 4.0 * area_m2);
    // What is left behind is forgotten: twice the area would be too much.
    EXPECT_LT(walked.cells().size(), 2 * here.cells().size());
}

TEST(GrassField, GrowsSoManyCellsAFrameNearestFirst) {
    const LawnAt flat = [](float, float) { return 0.0F; };
    GrassField field(scene::GrassDescription{});
    field.follow({1.0F, 1.7F, 1.0F}, 8.0F, 1, flat);
    ASSERT_EQ(field.cells().size(), 1U);
    EXPECT_EQ(field.cells().begin()->first, (std::pair{0, 0}));
    field.follow({1.0F, 1.7F, 1.0F}, 8.0F, 4, flat);
    EXPECT_EQ(field.cells().size(), 5U);
}

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

TEST(Flock, StaysWhereItIsToldAndFliesOn) {
    SceneDescription scene = test::scene_of({});
    scene.flocks = {{.kind = scene::FlockKind::Birds,
                     .count = 7,
                     .center_m = {1, 10, 2},
                     .radius_m = 20,
                     .height_m = 4,
                     .location = in_file("garden.toml", 50)}};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame first = draw(run, effects);
    ASSERT_EQ(first.items.size(), 7U * 3U) << "two wings and a body";
    EXPECT_EQ(line_of(effects, "flock").called_for_by, Callers{"[[flock]] (garden.toml:50)"});
    for (int second = 0; second < 30; ++second) {
        run.step(60, effects);
        for (const render::DrawItem& item : draw(run, effects).items) {
            const Vec3f off = Vec3f{item.world_from_body[3]} - Vec3f{1.0F, 10.0F, 2.0F};
            EXPECT_LE(std::hypot(off.x, off.z), 20.0F + 1e-3F);
            EXPECT_LE(std::abs(off.y), 2.0F + 1e-3F);
        }
    }
    run.step(1, effects);
    const auto before = draw(run, effects).items;
    run.step(1, effects);
    const auto after = draw(run, effects).items;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const float path_m =
            glm::distance(Vec3f{before[i].world_from_body[3]}, Vec3f{after[i].world_from_body[3]});
        EXPECT_LT(path_m, 0.5F) << "no jumps";
        EXPECT_GT(path_m, 0.0F);
    }
}

}  // namespace
}  // namespace plumbline::effects
