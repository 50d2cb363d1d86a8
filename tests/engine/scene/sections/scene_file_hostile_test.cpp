// Files that nobody means well with: never a crash, never a hang, never a way out of the folder.
#include "engine/core/limits.h"
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <sys/stat.h>

#include <algorithm>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

class SceneFileHostile : public SceneFileTest {
protected:
    void expect_only(const Outcome& outcome, const std::string& fault) {
        ASSERT_EQ(outcome.faults.size(), 1U);
        EXPECT_EQ(outcome.faults[0], fault);
        ASSERT_FALSE(outcome.scene.ok());
        EXPECT_EQ(outcome.scene.error().exit_code, ExitCode::Refused);
    }
};

std::string repeated(std::string_view what, std::size_t times) {
    std::string text;
    text.reserve(what.size() * times);
    for (std::size_t i = 0; i < times; ++i) text += what;
    return text;
}

TEST_F(SceneFileHostile, MissingFolderAndFifo) {
    const Outcome missing = load_file("none.toml");
    ASSERT_EQ(missing.faults.size(), 1U);
    EXPECT_NE(missing.faults[0].find("none.toml: No such file"), std::string::npos);

    fs::create_directories(folder() / "folder.toml");
    EXPECT_NE(load_file("folder.toml").faults.at(0).find("is not a regular file"),
              std::string::npos);

    ASSERT_EQ(mkfifo((folder() / "pipe.toml").c_str(), 0600), 0);
    EXPECT_NE(load_file("pipe.toml").faults.at(0).find("is not a regular file"), std::string::npos);
}

TEST_F(SceneFileHostile, OtherKindsOfFile) {
    for (const char* name : {"a.blend", "a.js", "a", "a.toml.exe"}) {
        write(name, "");
        const Outcome outcome = load_file(name);
        ASSERT_EQ(outcome.faults.size(), 1U) << name;
        EXPECT_NE(outcome.faults[0].find(
                      "expected .toml, .json or a model: .glb .gltf .obj .ply .stl .dae .fbx"),
                  std::string::npos);
    }
    EXPECT_FALSE(load_file("none.glb").scene.ok());
}

TEST_F(SceneFileHostile, DeepNesting) {
    expect_only(load("a = " + repeated("[", 200'000)),
                fmt::format("scene.toml:1:{}: error: nested deeper than {}",
                            limits::kTextNesting + 5,
                            limits::kTextNesting));
    expect_only(load("a = " + repeated("{a=", 5'000)),
                fmt::format("scene.toml:1:{}: error: nested deeper than {}",
                            3 * limits::kTextNesting + 5,
                            limits::kTextNesting));
    expect_only(load("a = [" + repeated("\n[", 200'000)),
                fmt::format("scene.toml:{}:1: error: nested deeper than {}",
                            limits::kTextNesting + 1,
                            limits::kTextNesting));
    // One less is the parser's and the reader's business.
    const Outcome deepest =
        load("a = " + repeated("[", limits::kTextNesting) + repeated("]", limits::kTextNesting));
    expect_only(
        deepest,
        "scene.toml:1:1: error: a: unknown key; known: accuracy, ambient, array, camera, "
        "change, cloth, effects, entity, explosion, flashlight, flock, fog, fountain, goal, grass, "
        "hard_case, "
        "joint, "
        "material, "
        "player, post, prefab, rope, scene, sky, soft, sound, sun, time, vehicle, view, water, "
        "wind, wind_zone, "
        "world");
}

TEST_F(SceneFileHostile, ManyDottedParts) {
    expect_only(load(repeated("a.", 100'000) + "a = 1"),
                "scene.toml:1:8: error: a dotted key of more than 4 parts");
    expect_only(load("[" + repeated("a . ", 3'000) + "a]"),
                "scene.toml:1:16: error: a dotted key of more than 4 parts");
    expect_only(load("[[" + repeated("\"a\".", 3'000) + "a]]"),
                "scene.toml:1:18: error: a dotted key of more than 4 parts");
}

TEST_F(SceneFileHostile, DotsInTextsAndCommentsAreNoKeys) {
    EXPECT_TRUE(load("# a.b.c.d.e.f [[[[ \n[scene]\ntitle = \"a.b.c.d.e.f [[[\"\n"
                     "description = '''a.b.c.d.e\n[[[[[[ ''''' # d.e.f.g.h.i\n")
                    .scene.ok());
}

// Each of these is undefined behaviour in toml++ 3.3, so the pre-scan must catch it.
TEST_F(SceneFileHostile, WhatTheParserWouldStumbleOver) {
    const std::string name = "expected a table's name after [";
    const std::string ascii = "a letter that is not ASCII; only texts and comments may hold them";
    const std::string slash = "a backslash before a letter that is not ASCII";
    expect_only(load("[*]"), "scene.toml:1:2: error: " + name);
    expect_only(load("  [\n"), "scene.toml:1:4: error: " + name);
    expect_only(load("a = 1\n[[ = "), "scene.toml:2:4: error: " + name);
    expect_only(load("[[["), "scene.toml:1:3: error: " + name);
    expect_only(load("\xEF\xBB\xBF[.]"), "scene.toml:1:5: error: " + name);
    expect_only(load("a = [}"), "scene.toml:1:6: error: } does not close [");
    expect_only(load("a = {]"), "scene.toml:1:6: error: ] does not close {");
    expect_only(load("\xC3\xA4 = 1"), "scene.toml:1:1: error: " + ascii);
    expect_only(load("a = 1\xC2\xA0"), "scene.toml:1:6: error: " + ascii);
    expect_only(load("a = 0'''\xC3\xA4'''"), "scene.toml:1:9: error: " + ascii);
    expect_only(load("a = \"\\\xC3\xA4\""), "scene.toml:1:6: error: " + slash);
    expect_only(load("a = \"\"\"\\ \n\n \xC3\xA4\"\"\""), "scene.toml:1:8: error: " + slash);
}

TEST_F(SceneFileHostile, LettersOfAllLanguagesInTextsAndComments) {
    const Outcome outcome = load(
        "# \xC3\xA4\n[scene]\ntitle = \"\xC3\xA4\" # \xC3\xA4\n"
        "description = \"\"\"\n\xC3\xA4\\\n  x\"\"\"\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->title, "\xC3\xA4");
    EXPECT_EQ(outcome.scene->description, "\xC3\xA4x");
}

TEST_F(SceneFileHostile, LongLines) {
    const std::string head = "[scene]\ntitle = \"";
    const std::size_t room = limits::kLineBytes - 10;
    EXPECT_TRUE(load(head + repeated("x", room) + "\"\n").scene.ok());
    expect_only(load(head + repeated("x", room + 1) + "\"\n"),
                fmt::format("scene.toml:2:{}: error: the line is longer than {} bytes; break it",
                            limits::kLineBytes + 1,
                            limits::kLineBytes));
}

TEST_F(SceneFileHostile, LargeFiles) {
    const std::string line = "# " + repeated("x", 1021) + "\n";
    const std::string full = repeated(line, limits::kSceneFileBytes / line.size());
    ASSERT_EQ(full.size(), limits::kSceneFileBytes);
    EXPECT_TRUE(load(full).scene.ok());
    const Outcome more = load(full + "\n");
    ASSERT_EQ(more.faults.size(), 1U);
    EXPECT_NE(more.faults[0].find("has 8388609 bytes; at most 8388608 are read"),
              std::string::npos);
}

TEST_F(SceneFileHostile, CutOffAnywhere) {
    const std::string whole = R"([scene]
title = "T"  # "quoted"
[world]
gravity_mps2 = [0, -9.81, 0]
[sun]
shadow = { cascades = 1, size_px = 1024 }
[[material]]
name = 'm'
[[prefab]]
name = "p"
primitive = { box = [1, 1, 1] }
material = "m"
[prefab.body]
shape = { compound = [{ sphere = 1, position_m = [0, 1, 0] }] }
[[entity]]
name = "e"
prefab = "p"
light = { kind = "spot" }
[[array]]
name = "a"
prefab = "p"
count = [1, 2, 3]
[[joint]]
kind = "hinge"
a = "e"
b = "a.0.1.2"
anchor_m = [0, 0, 0]
motor = { target = 1, max = 2 }
[effects.fracture]
fidelity = """
draft"""
)";
    ASSERT_TRUE(load(whole).scene.ok());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const Outcome outcome = load(whole.substr(0, size));
        for (const Diagnostic& fault : outcome.diagnostics) {
            // Whatever is said has a place in the text that is there.
            EXPECT_GE(fault.line, 1);
            EXPECT_LE(fault.line, 33) << size;
        }
        EXPECT_EQ(outcome.scene.ok(), std::ranges::none_of(outcome.diagnostics, [](const auto& f) {
                      return f.severity == Severity::Error;
                  }));
    }
}

TEST_F(SceneFileHostile, BytesChangedAtRandom) {
    const std::string whole =
        "[[prefab]]\nname = \"p\"\nprimitive = { box = [1, 1, 1] }\nbody = { mass_kg = 3 }\n"
        "[[array]]\nname = \"a\"\nprefab = \"p\"\ncount = [1, 2, 3]\n[sun]\ncolor = [1, 1, 1]\n";
    std::uint32_t state = 1;
    const auto next = [&] { return state = state * 1664525U + 1013904223U; };
    int refused = 0;
    for (int round = 0; round < 500; ++round) {
        std::string text = whole;
        for (int change = 0; change < 3; ++change)
            text[(next() >> 8U) % text.size()] = static_cast<char>(next() >> 24U);
        refused += load(text).scene.ok() ? 0 : 1;
    }
    EXPECT_GT(refused, 250);
}

TEST_F(SceneFileHostile, LinksOutOfTheFolder) {
    write("secret/m.glb", "x");
    fs::create_directories(folder() / "mine");
    fs::create_symlink(folder() / "secret", folder() / "mine/link");
    fs::create_symlink(folder() / "secret/m.glb", folder() / "mine/m.glb");
    write("mine/scene.toml", "[[entity]]\nmodel = \"link/m.glb\"\n[[entity]]\nmodel = \"m.glb\"\n");
    const Outcome outcome = load_file("mine/scene.toml");
    ASSERT_EQ(outcome.faults.size(), 2U);
    EXPECT_EQ(outcome.faults[0],
              "mine/scene.toml:2:9: error: entity[0].model: \"link/m.glb\" leads out of its folder "
              "through a link");
    EXPECT_EQ(outcome.faults[1],
              "mine/scene.toml:4:9: error: entity[1].model: \"m.glb\" leads out of its folder "
              "through a link");
}

TEST_F(SceneFileHostile, DevicesAndFifosAsModels) {
    ASSERT_EQ(mkfifo((folder() / "pipe.glb").c_str(), 0600), 0);
    EXPECT_EQ(load("[[entity]]\nmodel = \"pipe.glb\"").faults.at(0),
              "scene.toml:2:9: error: entity[0].model: \"pipe.glb\" is not a regular file");
}

TEST_F(SceneFileHostile, LongIncludeChainsAndManyPrefabs) {
    for (int i = 0; i < 40; ++i)
        write(fmt::format("p{}.toml", i),
              fmt::format("[scene]\ninclude = [\"p{}.toml\"]\n", i + 1));
    write("p40.toml", "");
    const Outcome outcome = load_file("p0.toml");
    ASSERT_EQ(outcome.faults.size(), 1U);
    EXPECT_NE(outcome.faults[0].find("too many files include one another"), std::string::npos);

    std::string text;
    for (int i = 0; i < 100; ++i)
        text += fmt::format("[[prefab]]\nname = \"p{}\"\nprefab = \"p{}\"\n", i, i + 1);
    text += "[[prefab]]\nname = \"p100\"\n[[entity]]\nprefab = \"p0\"\n";
    EXPECT_FALSE(load(text).scene.ok());
}

TEST_F(SceneFileHostile, IncludedFilesBringNothingElse) {
    write("part.toml", "[world]\ngravity_mps2 = [0, 0, 0]\n[[entity]]\nname = \"x\"\n");
    const Outcome outcome = load("[scene]\ninclude = [\"part.toml\"]\n");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_TRUE(outcome.scene->entities.empty());
    EXPECT_NEAR(outcome.scene->gravity_mps2.y, -9.81_r, 1e-6_r);
    ASSERT_EQ(outcome.faults.size(), 2U);
    EXPECT_EQ(
        outcome.faults[0],
        "part.toml:1:1: warning: world: only materials and prefabs are taken from an included "
        "file");
}

// Once each prefab was looked for among all others, again after hundreds of faults: minutes.
TEST_F(SceneFileHostile, APrefabChainOfManyThousands) {
    constexpr int kPrefabs = 60'000;
    std::string text = "[[prefab]]\nname=\"p0\"\n";
    for (int i = 1; i < kPrefabs; ++i)
        text += fmt::format("[[prefab]]\nname=\"p{}\"\nprefab=\"p{}\"\n", i, i - 1);
    const Outcome outcome = load(text);
    ASSERT_FALSE(outcome.scene.ok());
    ASSERT_EQ(outcome.faults.size(), 201U);
    EXPECT_NE(outcome.faults[0].find("more than 32 prefabs start from one another"),
              std::string::npos)
        << outcome.faults[0];
    EXPECT_NE(outcome.faults[200].find("further faults are not listed"), std::string::npos);
}

TEST_F(SceneFileHostile, Utf16IsNamed) {
    std::string text("\xFF\xFE", 2);
    for (const char letter : std::string_view("[scene]\n")) text += std::string{letter, '\0'};
    expect_only(load(text), "scene.toml:1:1: error: its text is UTF-16; save it as UTF-8");
    write("a.json", text);
    EXPECT_NE(load_file("a.json").faults.at(0).find("its text is UTF-16; save it as UTF-8"),
              std::string::npos);
}

}  // namespace
}  // namespace plumbline::scene
