// A scene that starts from another one: what it takes over, what it says itself, what it leaves out.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr std::string_view kBase = R"([scene]
title = "base"
description = "of both"
[world]
gravity_mps2 = [0, -1, 0]
kill_below_m = -5
[player]
[sun]
intensity = 2
shadow = { cascades = 2, size_px = 512 }
[fog]
[[material]]
name = "red"
[[prefab]]
name = "brick"
primitive = { box = [1, 1, 1] }
material = "red"
body = { kind = "static" }
[[entity]]
name = "a"
prefab = "brick"
[[view]]
name = "first"
position_m = [0, 1, 0]
target_m = [0, 0, 0]
)";

TEST_F(SceneFileTest, StartsFromItsBase) {
    write("base.toml", kBase);
    const Outcome outcome = load(R"([scene]
title = "mine"
base = "base.toml"
without = ["player", "fog"]
[world]
gravity_mps2 = [0, -3, 0]
[sun]
shadow = { size_px = 1024 }
[[entity]]
name = "b"
prefab = "brick"
[[view]]
name = "second"
position_m = [0, 2, 0]
target_m = [0, 0, 0]
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    const SceneDescription& scene = *outcome.scene;
    EXPECT_EQ(scene.title, "mine");
    EXPECT_EQ(scene.description, "of both");
    expect_near(scene.gravity_mps2, {0, -3, 0});
    EXPECT_EQ(scene.kill_below_m, Real{-5});
    EXPECT_FALSE(scene.player || scene.fog);
    EXPECT_EQ(scene.sun->intensity, 2.0F);
    EXPECT_EQ(scene.sun->shadow->cascades, 2);
    EXPECT_EQ(scene.sun->shadow->size_px, 1024);
    ASSERT_EQ(scene.entities.size(), 2U);
    EXPECT_EQ(scene.entities[0].name, "a");
    EXPECT_EQ(scene.entities[1].name, "b");
    EXPECT_EQ(to_string(scene.entities[0].location), "base.toml:19");
    EXPECT_EQ(to_string(scene.entities[1].location), "scene.toml:9");
    ASSERT_EQ(scene.views.size(), 2U);
    EXPECT_EQ(scene.views[1].name, "second");
    EXPECT_EQ(scene.source_files.size(), 2U) << "both are watched";
}

TEST_F(SceneFileTest, ABaseMayHaveABaseAndIncludes) {
    write("ground.toml", "[[prefab]]\nname = \"brick\"\nprimitive = { box = [1, 1, 1] }\n");
    write("first.toml",
          "[scene]\ninclude = [\"ground.toml\"]\n[[entity]]\nprefab = \"brick\"\nname = \"a\"\n");
    write("second.toml",
          "[scene]\nbase = \"first.toml\"\n[[entity]]\nprefab = \"brick\"\nname = \"b\"\n");
    const Outcome outcome = load(
        "[scene]\nbase = \"second.toml\"\ninclude = [\"ground.toml\"]\n"
        "[[entity]]\nprefab = \"brick\"\nname = \"c\"\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty()) << outcome.faults.front();
    ASSERT_EQ(outcome.scene->entities.size(), 3U);
    EXPECT_EQ(outcome.scene->entities[2].name, "c");
}

TEST_F(SceneFileTest, FaultsOfABaseAreNamed) {
    write("base.toml", kBase);
    const auto only = [&](std::string_view text) {
        const Outcome outcome = load(text);
        EXPECT_FALSE(outcome.scene.ok());
        return outcome.faults.empty() ? std::string() : outcome.faults.front();
    };
    EXPECT_EQ(only("[scene]\nbase = \"bse.toml\"\n"),
              "scene.toml:2:8: error: scene.base: \"bse.toml\" does not exist beside this file, in "
              "assets or in assets/scenes");
    EXPECT_EQ(only("[scene]\nbase = \"scene.toml\"\n"),
              "scene.toml:2:8: error: scene.base: includes itself: scene.toml -> scene.toml");
    EXPECT_EQ(only("[scene]\nbase = \"base.toml\"\nwithout = [\"plyer\"]\n"),
              "scene.toml:3:11: error: scene.without: no table is called \"plyer\"; did you mean "
              "\"player\"?");
    EXPECT_EQ(only("[scene]\nwithout = [\"player\"]\n"),
              "scene.toml:2:11: error: scene.without: is about the scene that base names; expected "
              "base as well");
    EXPECT_EQ(only("[scene]\nbase = \"base.toml\"\n[[entity]]\nname = \"a\"\n"),
              "scene.toml:4:8: error: entity[1].name: \"a\" is the name of what stands at "
              "base.toml:20 already");
    write("broken.toml", "[sun]\nintensity = \"much\"\n");
    EXPECT_EQ(only("[scene]\nbase = \"broken.toml\"\n"),
              "broken.toml:2:13: error: sun.intensity: \"much\"; expected a number from 0 to "
              "1000000");
}

}  // namespace
}  // namespace plumbline::scene
