// What [wind], [grass], [[flock]] and [[fountain]] say is what the description holds; what they get wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, AFountainIsRead) {
    const Outcome outcome = load(R"([[fountain]]
position_m = [1, 2, 3]
direction = [0, 2, 0]
ring = { radius_m = 0.4, streams = 12 }
speed_mps = 4
spread_deg = 90e-1
flow_lps = 0.25
drop_mm = 5
drag = false
pools = [{ center_m = [1, 0.5, 3], radius_m = 1.5 }]
[effects.fountain]
fidelity = "draft"
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    EXPECT_EQ(outcome.scene->fountain_fidelity, Fidelity::Draft);
    ASSERT_EQ(outcome.scene->fountains.size(), 1U);
    const FountainDescription& fountain = outcome.scene->fountains.front();
    expect_near(fountain.position_m, {1, 2, 3});
    expect_near(fountain.direction, {0, 1, 0});
    ASSERT_TRUE(fountain.ring);
    EXPECT_EQ(fountain.ring->radius_m, 0.4_r);
    EXPECT_EQ(fountain.ring->streams, 12);
    EXPECT_EQ(fountain.speed_mps, Real{4});
    EXPECT_NEAR(fountain.spread_rad, kPi / 20, kSlack);
    EXPECT_EQ(fountain.flow_lps, 0.25_r);
    EXPECT_EQ(fountain.drop_mm, Real{5});
    EXPECT_FALSE(fountain.drag);
    ASSERT_EQ(fountain.pools.size(), 1U);
    expect_near(fountain.pools.front().center_m, {1, 0.5_r, 3});
    EXPECT_EQ(fountain.pools.front().radius_m, 1.5_r);
    EXPECT_EQ(to_string(fountain.location).substr(to_string(fountain.location).rfind('/') + 1),
              "scene.toml:1");
}

TEST_F(SceneFileTest, TheWindIsRead) {
    const Outcome outcome = load(
        "[wind]\ndirection = [3, 9, 4]\nspeed_mps = 5\ngusts = 0.25\n"
        "gust_size_m = 12\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_TRUE(outcome.scene->wind);
    expect_near(outcome.scene->wind->direction, {0.6_r, 0, 0.8_r});
    EXPECT_EQ(outcome.scene->wind->speed_mps, Real{5});
    EXPECT_EQ(outcome.scene->wind->gusts, 0.25_r);
    EXPECT_EQ(outcome.scene->wind->gust_size_m, Real{12});
    const Outcome upright = load("[wind]\ndirection = [0, 1, 0]\n");
    ASSERT_EQ(upright.faults.size(), 1U);
    EXPECT_EQ(upright.faults.front(),
              "scene.toml:2:13: error: wind.direction: is upright; expected a direction along the "
              "ground");
}

TEST_F(SceneFileTest, WhatIsHeardIsRead) {
    const Outcome outcome = load("[sound]\npaths = true\nreverb = true\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_TRUE(outcome.scene->acoustics);
    EXPECT_TRUE(outcome.scene->acoustics->paths);
    EXPECT_TRUE(outcome.scene->acoustics->reverb);
    EXPECT_FALSE(load("").scene->acoustics);
    const Outcome wrong = load("[sound]\npath = true\nreverb = 1\n");
    ASSERT_EQ(wrong.faults.size(), 2U);
    EXPECT_EQ(wrong.faults[0],
              "scene.toml:2:1: error: sound.path: unknown key; did you mean \"paths\"?");
    EXPECT_EQ(wrong.faults[1], "scene.toml:3:10: error: sound.reverb: 1; expected true or false");
}

TEST_F(SceneFileTest, GrassAndFlocksAreRead) {
    const std::string lawn =
        "[[entity]]\nname = \"lawn\"\nprimitive = { plane = [9, 9] }\nbody = { kind = \"static\" "
        "}\n"
        "[[entity]]\nname = \"sign\"\nprimitive = { box = [1, 1, 1] }\n";
    const Outcome outcome =
        load(lawn +
             "[grass]\non = [\"lawn\"]\nheight_m = 0.2\n[[flock]]\nkind = \"butterflies\"\n"
             "count = 3\ncenter_m = [1, 2, 3]\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_TRUE(outcome.scene->grass);
    EXPECT_EQ(outcome.scene->grass->on, std::vector<std::string>{"lawn"});
    EXPECT_EQ(outcome.scene->grass->height_m, 0.2_r);
    ASSERT_EQ(outcome.scene->flocks.size(), 1U);
    EXPECT_EQ(outcome.scene->flocks.front().kind, FlockKind::Butterflies);
    EXPECT_EQ(outcome.scene->flocks.front().count, 3);
    const auto fault = [&](const std::string& text) {
        const Outcome refused = load(lawn + text);
        return refused.faults.size() == 1 ? refused.faults.front() : std::string{};
    };
    EXPECT_EQ(fault("[grass]\non = [\"lawm\"]\n"),
              "scene.toml:9:6: error: grass.on: no entity is called \"lawm\"");
    EXPECT_EQ(fault("[grass]\non = [\"sign\"]\n"),
              "scene.toml:9:6: error: grass.on: \"sign\" has no body");
    EXPECT_EQ(fault("[[flock]]\nkind = \"bats\"\ncenter_m = [0, 0, 0]\n"),
              "scene.toml:9:8: error: flock[0].kind: \"bats\"; expected one of birds, butterflies");
}

TEST_F(SceneFileTest, FaultsOfAFountainAreNamed) {
    const auto fault = [&](const std::string& text) {
        const Outcome outcome = load(text);
        EXPECT_FALSE(outcome.scene.ok()) << text;
        return outcome.faults.size() == 1 ? outcome.faults.front()
                                          : fmt::format("{}", fmt::join(outcome.faults, "\n"));
    };
    const std::string start = "[[fountain]]\nposition_m = [0, 1, 0]\n";
    EXPECT_EQ(fault("[[fountain]]\n"),
              "scene.toml:1:1: error: fountain[0].position_m: missing; expected [x, y, z] in m");
    EXPECT_EQ(fault(start + "spead_mps = 3\n"),
              "scene.toml:3:1: error: fountain[0].spead_mps: unknown key; did you mean "
              "\"speed_mps\"?");
    EXPECT_EQ(fault(start + "flow_lps = -1\n"),
              "scene.toml:3:12: error: fountain[0].flow_lps: -1; expected litres a "
              "second from 0 to 10000");
    EXPECT_EQ(fault(start + "pools = [{ radius_m = 1 }]\n"),
              "scene.toml:3:10: error: fountain[0].pools[0].center_m: missing; expected [x, y, z] "
              "in m");
    EXPECT_EQ(
        fault("[effects.fountain]\nfidelity = \"exact\"\n"),
        "scene.toml:2:12: error: effects.fountain.fidelity: \"exact\"; expected one of draft, "
        "balanced, precise");
}

}  // namespace
}  // namespace plumbline::scene
