// What is wrong is said, with its place, its key and what was expected.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// tests/malformed/scenes: NAME.toml beside NAME.txt, all that is to be said about it.
TEST(MalformedScenes, SayWhatIsWrittenBesideThem) {
    const fs::path folder = fs::path(PL_SOURCE_DIR) / "tests/malformed/scenes";
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        ++files;
        Diagnostics faults;
        const auto scene =
            read_description(entry.path(), fs::path(PL_SOURCE_DIR) / "assets", faults);
        std::string said;
        for (const Diagnostic& fault : faults.list()) {
            std::string line = to_string(fault);
            const std::string prefix = folder.string() + "/";
            if (line.rfind(prefix, 0) == 0) line.erase(0, prefix.size());
            said += line + "\n";
        }
        fs::path expected = entry.path();
        expected.replace_extension(".txt");
        EXPECT_EQ(said, text_of(expected)) << entry.path();
        EXPECT_EQ(scene.ok(), !faults.has_errors()) << entry.path();
        if (!scene) {
            EXPECT_EQ(scene.error().exit_code, ExitCode::Refused) << entry.path();
        }
    }
    EXPECT_GE(files, 85U);
}

struct Case {
    const char* text;
    const char* fault;  ///< how the first fault begins
};

using SceneFileFaults = SceneFileTest;

TEST_F(SceneFileFaults, EveryTableRefusesUnknownKeysAndNamesTheNearest) {
    const Case cases[] = {
        {"[scene]\ntitel = \"\"",
         "scene.toml:2:1: error: scene.titel: unknown key; did you mean \"title\"?"},
        {"[accuracy]\nstephz = 60",
         "scene.toml:2:1: error: accuracy.stephz: unknown key; did you mean \"step_hz\"?"},
        {"[player]\nyaw = 1\n[[entity]]\nprimitive={plane=[1,1]}\nbody={kind=\"static\"}",
         "scene.toml:2:1: error: player.yaw: unknown key; did you mean \"yaw_deg\"?"},
        {"[camera]\nfovdeg = 1",
         "scene.toml:2:1: error: camera.fovdeg: unknown key; did you mean \"fov_deg\"?"},
        {"[sun]\ncolour = [1,1,1]",
         "scene.toml:2:1: error: sun.colour: unknown key; did you mean \"color\"?"},
        {"[sun]\nshadow = { sizepx = 1 }",
         "scene.toml:2:12: error: sun.shadow.sizepx: unknown key; did you mean \"size_px\"?"},
        {"[ambient]\ncolr = [1,1,1]",
         "scene.toml:2:1: error: ambient.colr: unknown key; did you mean \"color\"?"},
        {"[fog]\ndensity = 1", "scene.toml:2:1: error: fog.density: unknown key"},
        {"[flashlight]\nradius = 1",
         "scene.toml:2:1: error: flashlight.radius: unknown key; did you mean \"radius_m\"?"},
        {"[post]\nblom = 1",
         "scene.toml:2:1: error: post.blom: unknown key; did you mean \"bloom\"?"},
        {"[[material]]\nname = \"m\"\nrougness = 1",
         "scene.toml:3:1: error: material[0].rougness: unknown key; did you mean \"roughness\"?"},
        {"[[material]]\nname = \"pane\"\nior = 0.5",
         "scene.toml:3:7: error: material[0].ior: 0.5; expected an index of refraction from 1 to "
         "4"},
        {"[sun]\nshadow = { angular_size_deg = 12 }",
         "scene.toml:2:31: error: sun.shadow.angular_size_deg: 12; expected degrees from 0 to 10"},
        {"[[entity]]\nlight = { knd = \"spot\" }",
         "scene.toml:2:11: error: entity[0].light.knd: unknown key; did you mean \"kind\"?"},
        {"[[entity]]\nprimitive = { bx = [1,1,1] }",
         "scene.toml:2:15: error: entity[0].primitive.bx: unknown key; did you mean \"box\"?"},
        {"[[array]]\ncuont = [1,1,1]", "scene.toml:1:1: error: array[0].prefab: missing"},
        {"[[view]]\nposition_m=[1,1,1]\ntarget_m=[0,0,0]\nwait = 1",
         "scene.toml:4:1: error: view[0].wait: unknown key; did you mean \"wait_s\"?"},
        {"[effects.fog]\nx = 1",
         "scene.toml:2:1: error: effects.fog.x: unknown key; none is known here"},
        {"\"odd key\" = 1", "scene.toml:1:1: error: \"odd key\": unknown key"},
    };
    for (const Case& c : cases) expect_first(c.text, c.fault);
}

TEST_F(SceneFileFaults, PlacesCountCharactersNotBytes) {
    expect_first("[scene]\ntitle = \"äöü\"\n[world]\n  kill_below_m = \"tief\"",
                 "scene.toml:4:18: error: world.kill_below_m: \"tief\"; expected metres");
}

TEST_F(SceneFileFaults, LimitsOneBelowAndOneAbove) {
    const auto loads = [&](const std::string& text) { return load(text).scene.ok(); };
    EXPECT_TRUE(loads("[accuracy]\nstep_hz = 30"));
    EXPECT_FALSE(loads("[accuracy]\nstep_hz = 29"));
    EXPECT_TRUE(loads("[accuracy]\nstep_hz = 1000"));
    EXPECT_FALSE(loads("[accuracy]\nstep_hz = 1001"));
    EXPECT_TRUE(loads("[[entity]]\nprimitive = { sphere = 0.001 }"));
    EXPECT_FALSE(loads("[[entity]]\nprimitive = { sphere = 0.00099 }"));
    EXPECT_TRUE(loads("[[entity]]\nprimitive = { sphere = 10000 }"));
    EXPECT_FALSE(loads("[[entity]]\nprimitive = { sphere = 10001 }"));
    EXPECT_TRUE(loads("[[entity]]\nposition_m = [100000, 0, 0]"));
    EXPECT_FALSE(loads("[[entity]]\nposition_m = [100001, 0, 0]"));
    const std::string body = "[[entity]]\nprimitive = { sphere = 1 }\n[entity.body]\n";
    EXPECT_TRUE(loads(body + "mass_kg = 0.001"));
    EXPECT_FALSE(loads(body + "mass_kg = 0.00099"));
    EXPECT_TRUE(loads(body + "mass_kg = 1e7"));
    EXPECT_FALSE(loads(body + "mass_kg = 1.0001e7"));
    EXPECT_TRUE(loads(body + "velocity_mps = [0, 1000, 0]"));
    EXPECT_FALSE(loads(body + "velocity_mps = [0, 1001, 0]"));
    EXPECT_TRUE(loads(body + "restitution = 1"));
    EXPECT_FALSE(loads(body + "restitution = 1.01"));
    const std::string pile =
        "[[prefab]]\nname = \"p\"\nprimitive = { sphere = 1 }\nbody = {}\n"
        "[[array]]\nname = \"n\"\nprefab = \"p\"\n";
    EXPECT_TRUE(loads(pile + "count = [50, 100, 10]"));
    EXPECT_FALSE(loads(pile + "count = [50, 100, 10]\n[[entity]]\n"));
    EXPECT_FALSE(loads(pile + "count = [50000, 50000, 50000]"));
}

}  // namespace
}  // namespace plumbline::scene
