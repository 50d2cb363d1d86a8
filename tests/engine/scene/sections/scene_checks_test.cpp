// What only the whole scene can tell.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, BodiesAreWarnedOfBeforeTheyAreRefused) {
    const std::string pile =
        "[[prefab]]\nname = \"p\"\nprimitive = { sphere = 1 }\nbody = {}\n"
        "[[array]]\nname = \"n\"\nprefab = \"p\"\n";
    EXPECT_TRUE(load(pile + "count = [50, 100, 1]").faults.empty());
    EXPECT_EQ(load(pile + "count = [50, 100, 1]\n[[entity]]\n").faults.size(), 1U);
}

TEST_F(SceneFileTest, AtMostThirtyTwoGroups) {
    std::string text;
    for (int i = 0; i < 31; ++i)
        text += fmt::format("[[entity]]\nprimitive={{sphere=1}}\nbody={{group=\"g{}\"}}\n", i);
    EXPECT_TRUE(load(text).scene.ok());
    text += "[[entity]]\nprimitive={sphere=1}\nbody={group=\"one_more\"}\n";
    EXPECT_FALSE(load(text).scene.ok());
}

TEST_F(SceneFileTest, MassesOfTenThousandToOneAreWarnedOf) {
    const auto pair = [](const char* heavy_kg) {
        return fmt::format(
            "[[entity]]\nname = \"fly\"\nprimitive = {{ sphere = 1 }}\nbody = {{ mass_kg = 1 }}\n"
            "[[entity]]\nname = \"ox\"\nprimitive = {{ sphere = 1 }}\nbody = {{ mass_kg = {} }}\n"
            "[[entity]]\nprimitive = {{ sphere = 1 }}\n"
            "body = {{ kind = \"static\", mass_kg = 1e7 }}\n",
            heavy_kg);
    };
    EXPECT_TRUE(load(pair("10000")).faults.empty());
    expect_only(pair("10001"),
                "6:8: warning: \"ox\" weighs 1e+04 times as much as \"fly\" (scene.toml:2); if "
                "they touch, the lighter one may sink in");
}

TEST_F(SceneFileTest, GroupsThatNoBodyIsIn) {
    const std::string body =
        "[[entity]]\nname = \"a\"\nprimitive = { sphere = 1 }\n[entity.body]\n";
    EXPECT_TRUE(
        load(body + "group = \"cars\"\ncollides_with = [\"cars\", \"default\"]\n").faults.empty());
    expect_only(body + "group = \"cars\"\ncollides_with = [\"crs\"]\n",
                "2:8: warning: entity[0].body.collides_with: no body is in group \"crs\"; did you "
                "mean \"cars\"?");
}

TEST_F(SceneFileTest, PlayersNeedGround) {
    const std::string said =
        "scene.toml: warning: no static body: there is nothing for the player "
        "to stand on";
    EXPECT_EQ(load("[player]\n" + std::string(kMovable)).faults, std::vector<std::string>{said});
    EXPECT_TRUE(load("[player]\n[[entity]]\nprimitive = { plane = [9, 9] }\n"
                     "body = { kind = \"static\" }\n")
                    .faults.empty());
}

}  // namespace
}  // namespace plumbline::scene
