// Where the cubes are drawn that show the lights. SOURCES B4, B15.
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

#include <algorithm>
#include <cmath>

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;

/// Light from straight above, and a flashlight in the hand.
SceneDescription sunny() {
    SceneDescription scene = test::scene_of({});
    scene.sun = scene::SunDescription{.direction = {0, -1, 0},
                                      .color = {1.0F, 0.5F, 0.25F},
                                      .intensity = 2.0F,
                                      .location = in_file("garden.toml", 21)};
    scene.flashlight = scene::FlashlightDescription{.color = {1.0F, 0.9F, 0.8F}};
    return scene;
}

TEST(LightCubes, NoneIsDrawnThatTheSceneDoesNotCallFor) {
    Running run(sunny());
    EffectRuntime effects(*run, kImage);
    run->switches.turn("flashlight", true);
    EXPECT_TRUE(draw(run, effects).items.empty());
    const LedgerLine line = line_of(effects, "light_cubes");
    EXPECT_EQ(line.constructions, 0U);
    EXPECT_EQ(line.calls, 0U);
    EXPECT_EQ(line.bytes_cpu, 0U);
}

TEST(LightCubes, TheSunsStandsWhereTheLightComesFromAndShinesAsIt) {
    SceneDescription scene = sunny();
    scene.sun->cube_m = 0.5F;
    scene.sun->cube_distance_m = 12.0F;
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_EQ(frame.items.size(), 1U);
    const render::DrawItem& cube = frame.items.front();
    EXPECT_TRUE(test::near(Vec3f{cube.world_from_body[3]}, Vec3f{0.0F, 12.0F, 0.0F}, 1e-5));
    EXPECT_TRUE(test::near(cube.tint, Vec3f{2.0F, 1.0F, 0.5F}, 1e-6));
    EXPECT_FALSE(cube.casts_shadow);
    const Aabb box = transformed(run.library.mesh(cube.mesh).bounds, cube.world_from_body);
    EXPECT_TRUE(test::near(box.max - box.min, Vec3f{0.5F}, 1e-5));
    EXPECT_EQ(line_of(effects, "light_cubes").called_for_by,
              Callers{"[sun] cube_m (garden.toml:21)"});

    // The person dims the light and turns it: a quarter of the way round from the east.
    run->switches.light_scale = 0.25F;
    run->switches.sun_direction = {-1.0F, 0.0F, 0.0F};
    run->switches.sun_rotation_radps = glm::half_pi<float>();
    run.step(run->description().accuracy.step_hz);
    const render::RenderFrame later = draw(run, effects);
    ASSERT_EQ(later.items.size(), 1U);
    EXPECT_TRUE(
        test::near(Vec3f{later.items.front().world_from_body[3]}, Vec3f{0.0F, 0.0F, -12.0F}, 1e-3));
    EXPECT_TRUE(test::near(later.items.front().tint, Vec3f{0.5F, 0.25F, 0.125F}, 1e-6));
}

TEST(LightCubes, TheFlashlightsIsInTheBeamWhileItIsOnAndNotInTheFace) {
    SceneDescription scene = sunny();
    scene.flashlight->cube_m = 0.04F;
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    EXPECT_TRUE(draw(run, effects).items.empty());
    run->switches.turn("flashlight", true);
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_EQ(frame.items.size(), 1U);
    const render::DrawItem& cube = frame.items.front();
    EXPECT_TRUE(test::near(cube.tint, Vec3f{1.0F, 0.9F, 0.8F}, 1e-6));
    EXPECT_FALSE(cube.casts_shadow) << "it would darken its own beam";
    // On the axis of the beam, and in the image away from its middle.
    ASSERT_TRUE(frame.flashlight);
    const Vec3f middle{cube.world_from_body[3]};
    const Vec3f way = middle - frame.flashlight->position_world;
    EXPECT_NEAR(glm::length(way), 0.8F, 1e-5F);
    EXPECT_LT(glm::length(glm::cross(way, frame.flashlight->direction_world)), 1e-5F);
    const Vec3f seen =
        glm::inverse(frame.camera.orientation) * (middle - frame.camera.position_world);
    const float share = std::max(std::abs(seen.x), std::abs(seen.y)) /
                        (-seen.z * std::tan(frame.camera.fov_y_rad * 0.5F));
    EXPECT_GT(share, 0.3F);
    EXPECT_LT(share, 0.9F);

    run->switches.turn("flashlight", false);
    EXPECT_TRUE(draw(run, effects).items.empty());
    EXPECT_FALSE(line_of(effects, "light_cubes").exists);
}

}  // namespace
}  // namespace plumbline::effects
