#include "engine/app/menu_sounds.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

std::vector<audio::SoundCue> heard(MenuSounds& sounds, const ui::MenuUse& use, float gain = 0.6F) {
    std::vector<audio::SoundCue> cues;
    sounds.add(use, gain, cues);
    return cues;
}

TEST(MenuSounds, TickAsTheMarkMovesAndRingAsSomethingIsChosen) {
    assets::AssetLibrary library;
    MenuSounds sounds(std::filesystem::path(PL_SOURCE_DIR) / "assets/sounds", library);
    EXPECT_TRUE(heard(sounds, {}).empty());
    const auto tick = heard(sounds, {.moves = 2});
    ASSERT_EQ(tick.size(), 1U);
    EXPECT_TRUE(tick[0].in_head);
    EXPECT_EQ(tick[0].gain, 0.6F);
    EXPECT_TRUE(heard(sounds, {.moves = 2}).empty()) << "once";
    const auto ring = heard(sounds, {.moves = 3, .choices = 1});
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_NE(ring[0].sound, tick[0].sound);
    EXPECT_TRUE(heard(sounds, {.moves = 4, .choices = 1}, 0.0F).empty());
}

TEST(MenuSounds, WithoutTheirFilesAreSilent) {
    assets::AssetLibrary library;
    MenuSounds sounds("no/such/folder", library);
    EXPECT_TRUE(heard(sounds, {.moves = 1}).empty());
    EXPECT_TRUE(heard(sounds, {.moves = 2, .choices = 1}).empty());
}

}  // namespace
}  // namespace plumbline::app
