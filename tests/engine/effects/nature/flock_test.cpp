// Birds and butterflies.
#include "tests/engine/effects/drawn.h"

#include <cmath>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

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

// Each flock has numbers of its own, the same in every run.
TEST(Flock, KindsAndFlocksDiffer) {
    SceneDescription scene = test::scene_of({});
    scene.flocks = {{.kind = scene::FlockKind::Butterflies, .count = 40, .radius_m = 5},
                    {.kind = scene::FlockKind::Butterflies, .count = 40, .radius_m = 5}};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const auto items = draw(run, effects).items;
    ASSERT_EQ(items.size(), 2U * 40U * 3U);
    EXPECT_NE(items[0].world_from_body[3], items[120].world_from_body[3]) << "another seed";
    Running again(scene);
    EffectRuntime same(*again, kImage);
    EXPECT_EQ(draw(again, same).items[7].world_from_body, items[7].world_from_body);
    // A wing and its mirror image, and a body in the middle of both.
    for (std::size_t i = 0; i < items.size(); i += 3) {
        const Mat3f left{items[i].world_from_body};
        const Mat3f right{items[i + 1].world_from_body};
        EXPECT_GT(glm::determinant(left) * -glm::determinant(right), 0.0F);
        EXPECT_NEAR(glm::length(left[0]), 0.045F, 1e-5F) << "half the span of a butterfly";
        EXPECT_EQ(items[i].world_from_body[3], items[i + 2].world_from_body[3]);
        EXPECT_FALSE(items[i].casts_shadow);
    }
    run->switches.turn("flock", false);
    EXPECT_TRUE(draw(run, effects).items.empty());
}

}  // namespace
}  // namespace plumbline::effects
