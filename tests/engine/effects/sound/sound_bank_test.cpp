#include "engine/effects/sound/sound_bank.h"

#include "engine/core/random.h"
#include "tests/engine/effects/sound/wooden.h"

#include <cstdint>
#include <set>
#include <string>

namespace plumbline::effects {
namespace {

TEST(SoundBank, AMissingFileIsToldOnce) {
    scene::SurfaceTable surfaces = loud_surfaces();
    surfaces.surfaces[1].impact_sounds = {"no/such.ogg"};
    SceneDescription scene = wooden({ground()});
    for (int i = 0; i < 5; ++i) {
        scene.entities.push_back(wooden_cube("cube" + std::to_string(i), {Real(3 * i), 2, 0}));
    }
    Running run(scene, surfaces);
    EffectRuntime effects(*run, kWithSound);
    run.step(120, effects);
    EXPECT_TRUE(effects.sound(*run, {}).cues.empty());
    EXPECT_EQ(run->warnings.size(), 1U);
}

TEST(SoundBank, ReadsAFileOnceAndPicksAmongSeveral) {
    Running run(scene_of({}));
    SoundBank bank;
    const auto wood = bank.get(*run, sound_file("impact_wood_0.ogg"));
    EXPECT_NE(wood, assets::SoundId{});
    const std::uint64_t bytes = bank.bytes();
    EXPECT_EQ(bytes, run->library().sound(wood).samples.size() * 2);
    EXPECT_EQ(bank.get(*run, sound_file("impact_wood_0.ogg")), wood);
    EXPECT_EQ(bank.bytes(), bytes);
    Random random(1);
    EXPECT_EQ(bank.pick(*run, {}, random), assets::SoundId{});
    std::set<std::uint32_t> picked;
    for (int i = 0; i < 40; ++i) {
        picked.insert(bank.pick(*run,
                                {sound_file("impact_wood_0.ogg"), sound_file("impact_wood_1.ogg")},
                                random)
                          .value);
    }
    EXPECT_EQ(picked.size(), 2U);
    EXPECT_TRUE(run->warnings.empty());
}

}  // namespace
}  // namespace plumbline::effects
