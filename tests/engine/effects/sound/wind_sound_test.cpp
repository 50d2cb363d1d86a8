// The wind in the ear.
#include "engine/scene/environment/wind_field.h"
#include "tests/engine/effects/sound/wooden.h"

#include <cmath>

namespace plumbline::effects {
namespace {

TEST(WindSound, FollowsTheGustsAtTheEarAndIsLessInTheLee) {
    scene::SceneDescription scene = scene_of({ground()});
    scene.wind = scene::WindDescription{.speed_mps = 4,
                                        .gusts = 0.6_r,
                                        .sound = sound_file("loop_wind.ogg"),
                                        .sound_gain = 0.2F,
                                        .location = in_file("garden.toml", 30)};
    scene::ViewPoint ear;
    ear.world_from_camera.position = {3, 1.7_r, 2};
    Running run(scene);
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "wind_sound").called_for_by,
              Callers{"[wind] sound (garden.toml:30)"});
    for (int i = 0; i < 5; ++i) {
        run.step(40, effects);
        const Real speed = glm::length(scene::wind_at(*scene.wind, {3, 1.7_r, 2}, run->time_s()));
        const audio::LoopCue wind = effects.sound(*run, ear).loops.at(0);
        EXPECT_NEAR(wind.gain, 0.2_r * speed * speed / 16, 1e-4F);
        EXPECT_LT(wind.position_world.x, 3.0F) << "from where it blows";
    }
    // A wall upwind, 2 m off.
    scene.entities.push_back(
        test::box("wall", {1, 5, 2}, {0.2_r, 30, 40}, physics::BodyKind::Static));
    Running sheltered(scene);
    EffectRuntime in_the_lee(*sheltered, kWithSound);
    const Real speed = glm::length(scene::wind_at(*scene.wind, {3, 1.7_r, 2}, 0));
    EXPECT_NEAR(in_the_lee.sound(*sheltered, ear).loops.at(0).gain,
                0.15_r * 0.2_r * speed * speed / 16,
                1e-4F);
}

TEST(WindSound, ShelterIsFoundWithinHalfASecondAndNotAtOnce) {
    scene::SceneDescription scene = scene_of({ground()});
    scene.wind = scene::WindDescription{
        .speed_mps = 4, .gusts = 0, .sound = sound_file("loop_wind.ogg"), .sound_gain = 0.2F};
    // A wall from x = 0.9 to 1.1, 2 m upwind of (3, ., 2) and far from (3, ., 300).
    scene.entities.push_back(
        test::box("wall", {1, 5, 2}, {0.2_r, 30, 40}, physics::BodyKind::Static));
    Running run(scene);
    EffectRuntime effects(*run, kWithSound);
    const auto gain_at = [&](Real z) {
        scene::ViewPoint ear;
        ear.world_from_camera.position = {3, 1.7_r, z};
        return effects.sound(*run, ear).loops.at(0).gain;
    };
    EXPECT_NEAR(gain_at(300), 0.2F, 1e-4F) << "in the open";
    run.step(30, effects);
    // exp(-1) of the way is left after the time constant, 0.5 s.
    const float wanted = 0.15F + 0.85F * std::exp(-1.0F);
    EXPECT_NEAR(gain_at(2), 0.2F * wanted, 0.002F);
    scene.wind->sound.clear();
    Running mute(scene);
    EXPECT_TRUE(line_of(EffectRuntime(*mute, kWithSound), "wind_sound").called_for_by.empty());
}

}  // namespace
}  // namespace plumbline::effects
