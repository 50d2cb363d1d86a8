#include "engine/audio/hearing.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumbline::audio {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SoundCue cue_at(float distance_m, float gain = 1.0F) {
    SoundCue cue;
    cue.sound = {1};
    cue.position_world = {distance_m, 0.0F, 0.0F};
    cue.gain = gain;
    return cue;
}

TEST(Attenuation, IsInverseNearAndNothingAtTheRadius) {
    EXPECT_EQ(attenuation(0.0F, 20.0F), 1.0F);
    EXPECT_NEAR(attenuation(2.0F, 20.0F), 0.5F * (1.0F - 0.01F), 1e-6F);
    EXPECT_NEAR(attenuation(10.0F, 20.0F), 0.1F * 0.75F, 1e-6F);
    EXPECT_EQ(attenuation(20.0F, 20.0F), 0.0F);
    EXPECT_EQ(attenuation(1e9F, 20.0F), 0.0F);
    EXPECT_NEAR(attenuation(19.99F, 20.0F), 0.0F, 1e-4F);  // no step at the edge
    EXPECT_NEAR(attenuation(0.2F, 0.4F), 0.5F * 0.75F, 1e-6F);
}

TEST(Attenuation, FallsAllTheWay) {
    float before = 2.0F;
    for (int i = 0; i <= 100; ++i) {
        const float now = attenuation(static_cast<float>(i) * 0.25F, 25.0F);
        EXPECT_LE(now, i > 4 ? before - 1e-6F : before) << i;
        before = now;
    }
}

TEST(Attenuation, NumbersThatAreNoneAreSilent) {
    EXPECT_EQ(attenuation(kNan, 20.0F), 0.0F);
    EXPECT_EQ(attenuation(1.0F, kNan), 0.0F);
    EXPECT_EQ(attenuation(1.0F, -1.0F), 0.0F);
}

TEST(PlaceInMono, IsAheadAndComesAsFast) {
    Listener listener;  // looks down -Z
    listener.position_world = {1, 2, 3};
    listener.velocity_mps = {0, 0, 5};
    const MonoPlace place = place_in_mono({5, 2, 3}, {-7, 4, 0}, listener);
    EXPECT_NEAR(glm::distance(place.position_world, Vec3f{1, 2, -1}), 0.0F, 1e-5F);
    // 7 m/s nearer along x are 7 m/s nearer from ahead; what goes past counts for nothing.
    EXPECT_NEAR(glm::distance(place.velocity_mps, Vec3f{0, 0, 5 + 7}), 0.0F, 1e-5F);
    const MonoPlace at_the_ear = place_in_mono({1, 2, 3}, {0, 0, 0}, listener);
    EXPECT_TRUE(is_finite(at_the_ear.position_world) && is_finite(at_the_ear.velocity_mps));
}

TEST(BoundedSpeed, KeepsItsDirectionAndIsNumbers) {
    EXPECT_EQ(with_bounded_speed({3, 0, 4}), (Vec3f{3, 0, 4}));
    EXPECT_NEAR(glm::distance(with_bounded_speed({300, 0, 400}), Vec3f{36, 0, 48}), 0.0F, 1e-3F);
    EXPECT_EQ(with_bounded_speed({kNan, 0, 4}), Vec3f{0.0F});
}

TEST(CueChoice, WhatMattersMoreComesFirst) {
    std::vector<SoundCue> cues{cue_at(1.0F), cue_at(2.0F), cue_at(100.0F, 0.3F)};
    cues[1].importance = 5.0F;
    cues[2].in_head = true;  // from no place: as loud as it is
    cues[2].importance = 100.0F;
    CueChoice choice;
    const auto chosen = choice.choose(cues, Vec3f{0.0F}, 0.0, 2);
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_TRUE(chosen[0].cue.in_head);
    EXPECT_EQ(chosen[0].loudness, 0.3F);
    EXPECT_EQ(chosen[1].cue.position_world.x, 2.0F);
}

TEST(CueChoice, TheLoudestOfAStormWin) {  // B8
    std::vector<SoundCue> storm;
    for (int i = 0; i < 1'000; ++i) storm.push_back(cue_at(1.0F + static_cast<float>(i % 23)));
    CueChoice choice;
    const auto chosen = choice.choose(storm, Vec3f{0.0F}, 0.0, 8);
    ASSERT_EQ(chosen.size(), 8U);
    for (const ChosenCue& cue : chosen) EXPECT_EQ(cue.cue.position_world.x, 1.0F);
}

TEST(CueChoice, WhatCannotBeHeardGetsNoVoice) {
    CueChoice choice;
    const std::vector<SoundCue> cues{cue_at(30.0F), cue_at(1.0F, 0.0F), cue_at(24.999F)};
    EXPECT_TRUE(choice.choose(cues, Vec3f{0.0F}, 0.0, 8).empty());
    EXPECT_EQ(choice.choose(cues, Vec3f{30.0F, 0.0F, 0.0F}, 0.0, 8).size(), 2U);
}

TEST(CueChoice, NumbersThatAreNoneAreDropped) {  // B9
    std::vector<SoundCue> cues(8, cue_at(1.0F));
    cues[0].position_world.y = kNan;
    cues[1].gain = kNan;
    cues[2].pitch = std::numeric_limits<float>::infinity();
    cues[3].radius_m = kNan;
    cues[4].low_pass = kNan;
    cues[5].sound = {};
    cues[6].position_world.z = 1e30F;
    CueChoice choice;
    EXPECT_EQ(choice.choose(cues, Vec3f{0.0F}, 0.0, 8).size(), 1U);
    EXPECT_FALSE(is_playable(LoopCue{.key = 0, .sound = {1}}));
    EXPECT_FALSE(is_playable(LoopCue{.key = 1, .sound = {1}, .gain = kNan}));
    EXPECT_TRUE(is_playable(LoopCue{.key = 1, .sound = {1}}));
}

TEST(CueChoice, CuesAreBroughtIntoRange) {
    SoundCue wild = cue_at(0.5F, 7.0F);
    wild.pitch = 100.0F;
    wild.low_pass = -3.0F;
    CueChoice choice;
    const auto chosen = choice.choose({&wild, 1}, Vec3f{0.0F}, 0.0, 8);
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen[0].cue.gain, 1.0F);
    EXPECT_EQ(chosen[0].cue.pitch, 2.0F);
    EXPECT_EQ(chosen[0].cue.low_pass, 0.0F);
}

TEST(CueChoice, OneKeyIsOneSoundIn50Milliseconds) {
    SoundCue quiet = cue_at(1.0F, 0.3F);
    quiet.merge_key = 7;
    SoundCue loud = cue_at(1.0F, 0.9F);
    loud.merge_key = 7;
    CueChoice choice;
    const std::vector<SoundCue> both{quiet, loud, quiet};
    const auto first = choice.choose(both, Vec3f{0.0F}, 0.0, 8);
    ASSERT_EQ(first.size(), 1U);
    EXPECT_EQ(first[0].cue.gain, 0.9F);
    EXPECT_TRUE(choice.choose({&quiet, 1}, Vec3f{0.0F}, 0.049, 8).empty());
    EXPECT_EQ(choice.choose({&quiet, 1}, Vec3f{0.0F}, 0.051, 8).size(), 1U);
    EXPECT_EQ(choice.choose({&loud, 1}, Vec3f{0.0F}, 0.06, 8).size(), 1U);  // louder: takes over
    const std::vector<SoundCue> keyless(3, cue_at(1.0F));
    EXPECT_EQ(choice.choose(keyless, Vec3f{0.0F}, 0.06, 8).size(), 3U);
}

}  // namespace
}  // namespace plumbline::audio
