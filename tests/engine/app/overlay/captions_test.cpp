#include "engine/app/overlay/captions.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline::app {
namespace {

using Lines = std::vector<std::string>;

audio::SoundCue event(const std::string& words, const Vec3f& position_world, float gain = 1.0F) {
    audio::SoundCue cue;
    cue.sound = {1};
    cue.position_world = position_world;
    cue.gain = gain;
    cue.caption = words;
    return cue;
}

effects::SoundFrame sound_of(std::vector<audio::SoundCue> cues) {
    effects::SoundFrame sound;
    sound.cues = std::move(cues);
    return sound;
}

TEST(CaptionLine, PointsToWhereItIs) {
    audio::Listener listener;  // looks down -Z
    EXPECT_EQ(caption_line("bell", {-4, 0, 0}, listener), "< bell");
    EXPECT_EQ(caption_line("bell", {4, 1, -1}, listener), "bell >");
    EXPECT_EQ(caption_line("bell", {0.5F, 3, -4}, listener), "^ bell");
    EXPECT_EQ(caption_line("bell", {0.5F, 0, 4}, listener), "bell v");
    EXPECT_EQ(caption_line("bell", {0, 5, 0.1F}, listener), "bell");
    listener.orientation = Quatf{0.70710678F, 0.0F, 0.70710678F, 0.0F};  // looks down -X
    EXPECT_EQ(caption_line("bell", {-4, 0, 0}, listener), "^ bell");
    EXPECT_EQ(caption_line("bell", {0, 0, -4}, listener), "bell >");
}

TEST(Captions, OfLoudEventsStayAWhile) {
    Captions captions;
    captions.add(
        sound_of({event("wood hits stone", {-2, 0, 0}), event("a leaf", {2, 0, 0}, 0.01F)}),
        {},
        10.0);
    EXPECT_EQ(captions.lines(10.1), Lines{"< wood hits stone"});
    EXPECT_EQ(captions.lines(12.4), Lines{"< wood hits stone"});
    EXPECT_TRUE(captions.lines(12.6).empty());
}

TEST(Captions, AreRenewedNotStacked) {
    Captions captions;
    captions.add(sound_of({event("bell", {-2, 0, 0})}), {}, 10.0);
    captions.add(sound_of({event("bell", {2, 0, 0})}), {}, 11.5);
    EXPECT_EQ(captions.lines(13.0), Lines{"bell >"});
}

TEST(Captions, OfAStormAreThoseOfTheLoudestFewASecond) {
    Captions captions;
    std::vector<audio::SoundCue> storm;
    for (int i = 0; i < 500; ++i)
        storm.push_back(
            event("hit " + std::to_string(i), {0, 0, -1.0F - 0.01F * static_cast<float>(i)}));
    for (int frame = 0; frame < 300; ++frame) {
        captions.add(sound_of(storm), {}, 10.0 + frame / 60.0);
        EXPECT_LE(captions.lines(10.0 + frame / 60.0).size(), Captions::kMostLines);
    }
    Captions fresh;
    fresh.add(sound_of(storm), {}, 10.0);
    EXPECT_EQ(fresh.lines(10.0), Lines{"^ hit 0"});
}

TEST(Captions, OfWhatIsFarComeWithTheSound) {
    Captions captions;
    audio::SoundCue late = event("bell", {0, 0, -3});
    late.delay_s = 0.5F;
    captions.add(sound_of({late}), {}, 10.0);
    EXPECT_TRUE(captions.lines(10.4).empty());
    EXPECT_EQ(captions.lines(10.6), Lines{"^ bell"});
}

TEST(Captions, OfWhatGoesOnStayUntilItEnds) {
    Captions captions;
    effects::SoundFrame sound;
    sound.loops.push_back({.key = 3,
                           .sound = {1},
                           .position_world = {3, 0, 0},
                           .gain = 0.8F,
                           .caption = "garden gate: creaking"});
    for (int frame = 0; frame <= 300; ++frame) captions.add(sound, {}, 10.0 + frame / 60.0);
    EXPECT_EQ(captions.lines(15.0), Lines{"garden gate: creaking >"});
    captions.add({}, {}, 18.0);
    EXPECT_TRUE(captions.lines(18.0).empty());
}

TEST(Captions, NumbersThatAreNoneGetNone) {
    Captions captions;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    captions.add(sound_of({event("bell", {nan, 0, 0}), event("gong", {1, 0, 0}, nan)}), {}, 10.0);
    EXPECT_TRUE(captions.lines(10.0).empty());
}

}  // namespace
}  // namespace plumbline::app
