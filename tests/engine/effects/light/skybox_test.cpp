// The sky behind everything.
#include "tests/engine/effects/drawn.h"
#include "tests/support/near.h"

namespace plumbline::effects {
namespace {

using scene::SceneDescription;
using test::Running;
using test::scene_of;

TEST(Skybox, SixImagesAreDimmedWithTheLight) {
    SceneDescription scene = scene_of({});
    scene.sky = scene::SkyDescription{.folder = "skies/day", .location = in_file("a.toml", 9)};
    Running run(scene);
    EffectRuntime effects(*run, kImage);
    run->switches.light_scale = 0.25F;
    const render::RenderFrame frame = draw(run, effects);
    ASSERT_TRUE(frame.sky);
    EXPECT_EQ(frame.sky->folder, "skies/day");
    EXPECT_EQ(frame.sky->brightness, 0.25F);
    EXPECT_FALSE(frame.sky->model);
    EXPECT_EQ(line_of(effects, "skybox").called_for_by, Callers{"[sky] skybox (a.toml:9)"});
    Running none(scene_of({}));
    EffectRuntime no_effects(*none, kImage);
    EXPECT_FALSE(draw(none, no_effects).sky);
}

TEST(Skybox, AModelFollowsTheSunOrIsThatOfANight) {
    SceneDescription scene = scene_of({});
    scene.sky =
        scene::SkyDescription{.model = scene::SkyModelDescription{.haze = 3.0F, .clouds = 0.25F}};
    {
        Running night(scene);
        EffectRuntime effects(*night, kImage);
        const render::SkyModel model = *draw(night, effects).sky->model;
        EXPECT_EQ(model.to_sun_world, (Vec3f{0, -1, 0})) << "below the horizon";
        EXPECT_EQ(model.pole_world, render::SkyModel{}.pole_world);
        EXPECT_EQ(model.haze, 3.0F);
        EXPECT_EQ(model.clouds, 0.25F);
        EXPECT_EQ(line_of(effects, "skybox").called_for_by, Callers{"[sky] model"});
    }
    scene.sun = scene::SunDescription{.direction = {0, 0, -1}};
    scene.time = scene::TimeDescription{.latitude_rad = glm::half_pi<double>()};
    Running day(scene);
    EffectRuntime effects(*day, kImage);
    const render::RenderFrame frame = draw(day, effects);
    ASSERT_TRUE(frame.sun && frame.sky && frame.sky->model);
    EXPECT_TRUE(test::near(frame.sky->model->to_sun_world, -frame.sun->direction_world, 1e-6));
    EXPECT_TRUE(test::near(frame.sky->model->pole_world, Vec3f{0, 1, 0}, 1e-6))
        << "at the pole the stars turn about what is above";
}

}  // namespace
}  // namespace plumbline::effects
