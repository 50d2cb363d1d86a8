// Steps, by the ground walked on.
#include "tests/engine/effects/sound/wooden.h"

#include <span>
#include <vector>

namespace plumbline::effects {
namespace {

class Walker final : public scene::Game {
public:
    scene::ViewPoint view(const scene::Simulation&, Real, float, float) const override {
        return {};
    }
    std::span<const scene::FootstepEvent> footsteps() const override { return steps; }
    std::vector<scene::FootstepEvent> steps;
};

TEST(Footsteps, SoundByTheGroundWalkedOn) {
    SceneDescription scene = scene_of({ground()});
    scene.player = scene::PlayerDescription{.location = in_file("garden.toml", 5)};
    Running run(scene, loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    EXPECT_EQ(line_of(effects, "footsteps").called_for_by, Callers{"[player] (garden.toml:5)"});
    Walker walker;
    walker.steps = {{.position_m = {1, 0, 2}, .surface = 0, .speed_mps = 3}};
    advance(*run, effects, walker, {});
    const SoundFrame sound = effects.sound(*run, {});
    ASSERT_EQ(sound.cues.size(), 1U);
    EXPECT_EQ(sound.cues[0].position_world, (Vec3f{1, 0, 2}));
    EXPECT_FLOAT_EQ(sound.cues[0].gain, 0.5F);
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty()) << "each step sounds once";
}

TEST(Footsteps, AreAsLoudAsTheyAreHardAndNeverMoreThanEightAtOnce) {
    SceneDescription scene = scene_of({ground()});
    scene.player = scene::PlayerDescription{};
    Running run(scene, loud_surfaces());
    EffectRuntime effects(*run, kWithSound);
    Walker walker;
    for (const Real speed_mps : {0.0_r, 6.0_r, 60.0_r})
        walker.steps.push_back({.surface = 0, .speed_mps = speed_mps});
    walker.steps.push_back({.surface = 1, .speed_mps = 3});
    advance(*run, effects, walker, {});
    const auto cues = effects.sound(*run, {}).cues;
    ASSERT_EQ(cues.size(), 3U) << "wood has no steps";
    EXPECT_FLOAT_EQ(cues[0].gain, 0.1F);
    EXPECT_FLOAT_EQ(cues[1].gain, 1.0F);
    EXPECT_FLOAT_EQ(cues[2].gain, 1.0F);
    walker.steps.assign(20, {.surface = 0, .speed_mps = 3});
    advance(*run, effects, walker, {});
    EXPECT_EQ(effects.sound(*run, {}).cues.size(), 8U);
}

TEST(Footsteps, AreNotMadeWhereNobodyWalksOrNothingSounds) {
    Running nobody(scene_of({ground()}), loud_surfaces());
    EXPECT_TRUE(line_of(EffectRuntime(*nobody, kWithSound), "footsteps").called_for_by.empty());
    SceneDescription scene = scene_of({ground()});
    scene.player = scene::PlayerDescription{};
    Running silent(scene);
    EXPECT_TRUE(line_of(EffectRuntime(*silent, kWithSound), "footsteps").called_for_by.empty());
}

}  // namespace
}  // namespace plumbline::effects
