// Entities and copies by name.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

constexpr const char* kPileOfTwo =
    "[[prefab]]\nname = \"p\"\nprimitive = { sphere = 1 }\nbody = {}\n"
    "[[array]]\nname = \"pile\"\nprefab = \"p\"\ncount = [2, 1, 11]\n";

TEST_F(SceneFileTest, CopiesAreNamedByTheirIndices) {
    const auto is_there = [&](const std::string& name) {
        return load(std::string(kPileOfTwo) + "[[joint]]\nkind = \"fixed\"\nb = \"world\"\na = \"" +
                    name + "\"\n")
            .faults.empty();
    };
    for (const char* name : {"pile.0.0.0", "pile.1.0.10"}) EXPECT_TRUE(is_there(name)) << name;
    for (const char* name : {"pile",
                             "pile.0.0",
                             "pile.2.0.0",
                             "pile.0.1.0",
                             "pile.0.0.11",
                             "pile.0.0.01",
                             "pile.0.0.-1",
                             "pile.0.0.",
                             "pile.0.0.1x",
                             "pile.0.0.0.0",
                             "pie.0.0.0"})
        EXPECT_FALSE(is_there(name)) << name;
}

TEST_F(SceneFileTest, NoTwoThingsShareAName) {
    const std::string other = "[[entity]]\nname = ";
    const std::string at = "10:8: error: entity[0].name: ";
    expect_only(kPileOfTwo + other + "\"world\"\n",
                at + "\"world\" means the world itself; use another name");
    expect_only(kPileOfTwo + other + "\"pile.1.0.3\"\n",
                at + "\"pile.1.0.3\" is the name of a copy of the array at scene.toml:5");
    EXPECT_TRUE(load(kPileOfTwo + other + "\"pile.2.0.3\"\n").faults.empty());
    expect_only(kPileOfTwo + other + "\"x\"\n" + other + "\"x\"\n",
                "12:8: error: entity[1].name: \"x\" is the name of what stands at scene.toml:10 "
                "already");
    expect_only(kPileOfTwo + other + "\"pile\"\n",
                "5:1: error: array[0].name: \"pile\" is the name of what stands at scene.toml:10 "
                "already");
}

}  // namespace
}  // namespace plumbline::scene
