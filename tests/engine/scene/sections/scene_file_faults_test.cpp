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

constexpr const char* kMovable = "[[entity]]\nname=\"a\"\nprimitive={sphere=1}\nbody={}\n";

class SceneFileFaults : public SceneFileTest {
protected:
    void expect_first(const std::string& text, const std::string& start) {
        const Outcome outcome = load(text);
        ASSERT_FALSE(outcome.faults.empty()) << text;
        EXPECT_EQ(outcome.faults[0].substr(0, start.size()), start) << text;
    }
};

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

TEST_F(SceneFileFaults, JointFaults) {
    const std::string base = std::string(kMovable) + "[[joint]]\n";
    expect_first(
        base + "a=\"a\"\nb=\"world\"\nanchor_m=[0,0,0]",
        "scene.toml:5:1: error: joint[0].kind: missing; expected one of ball_and_socket, hinge");
    expect_first(base + "kind=\"ball_and_socket\"\na=\"world\"\nb=\"a\"\nanchor_m=[0,0,0]",
                 "scene.toml:7:3: error: joint[0].a: \"world\" can only be b");
    expect_first(base + "kind=\"spring\"\na=\"a\"\nb=\"world\"\nanchor_b_m=[0,1,0]",
                 "scene.toml:5:1: error: joint[0].stiffness_Npm: missing; expected N per m");
    const Outcome unused = load(
        base + "kind=\"ball_and_socket\"\na=\"a\"\nb=\"world\"\nanchor_m=[0,0,0]\nlimits=[0,1]");
    ASSERT_EQ(unused.faults.size(), 1U);
    EXPECT_EQ(unused.faults[0],
              "scene.toml:10:8: warning: joint[0].limits: a joint of kind ball_and_socket does not "
              "use it; ignored");
    EXPECT_TRUE(unused.scene.ok());
}

TEST_F(SceneFileFaults, EdgesOfLightCubes) {
    for (const std::string table : {"sun", "flashlight"}) {
        EXPECT_TRUE(load("[" + table + "]\ncube_m = 100").scene.ok());
        for (const std::string edge : {"-1", "101"}) {
            expect_first("[" + table + "]\ncube_m = " + edge,
                         "scene.toml:2:10: error: " + table + ".cube_m: " + edge +
                             "; expected a length from 0 to 100 m");
        }
    }
    expect_first("[sun]\ncube = 1",
                 "scene.toml:2:1: error: sun.cube: unknown key; did you mean \"cube_m\"?");
}

TEST_F(SceneFileFaults, APrefabsFaultIsToldOnce) {
    std::string text = "[[prefab]]\nname = \"p\"\nprimitive = { sphere = -1 }\n";
    for (int i = 0; i < 50; ++i) text += "[[entity]]\nprefab = \"p\"\n";
    EXPECT_EQ(load(text).faults.size(), 1U);
}

TEST_F(SceneFileFaults, AHostileFileCannotFloodTheList) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += fmt::format("key_{} = 1\n", i);
    const Outcome outcome = load(text);
    EXPECT_EQ(outcome.faults.size(), 201U);
    EXPECT_NE(outcome.faults.back().find("further faults are not listed"), std::string::npos);
    EXPECT_FALSE(outcome.scene.ok());
}

TEST_F(SceneFileFaults, FaultsComeInTheOrderOfTheFile) {
    const Outcome outcome = load("[fog]\ndensity_per_m = -1\n[world]\nx = 1\n[[entity]]\ny = 2\n");
    ASSERT_EQ(outcome.diagnostics.size(), 3U);
    EXPECT_EQ(outcome.diagnostics[0].line, 2);
    EXPECT_EQ(outcome.diagnostics[1].line, 4);
    EXPECT_EQ(outcome.diagnostics[2].line, 6);
    // The error that the program ends with is the first of them.
    EXPECT_NE(outcome.scene.error().message.find("scene.toml:2:17: error: fog.density_per_m: -1"),
              std::string::npos);
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

TEST_F(SceneFileFaults, BodiesAreWarnedOfBeforeTheyAreRefused) {
    const std::string pile =
        "[[prefab]]\nname = \"p\"\nprimitive = { sphere = 1 }\nbody = {}\n"
        "[[array]]\nname = \"n\"\nprefab = \"p\"\n";
    EXPECT_TRUE(load(pile + "count = [50, 100, 1]").faults.empty());
    EXPECT_EQ(load(pile + "count = [50, 100, 1]\n[[entity]]\n").faults.size(), 1U);
}

TEST_F(SceneFileFaults, AtMostThirtyTwoGroups) {
    std::string text;
    for (int i = 0; i < 31; ++i)
        text += fmt::format("[[entity]]\nprimitive={{sphere=1}}\nbody={{group=\"g{}\"}}\n", i);
    EXPECT_TRUE(load(text).scene.ok());
    text += "[[entity]]\nprimitive={sphere=1}\nbody={group=\"one_more\"}\n";
    EXPECT_FALSE(load(text).scene.ok());
}

TEST_F(SceneFileFaults, StrongGravityIsClamped) {
    const Outcome outcome = load("[world]\ngravity_mps2 = [3e6, 4e6, 0]");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_NEAR(outcome.scene->gravity_mps2.x, Real{600}, 0.01_r);
    EXPECT_NEAR(outcome.scene->gravity_mps2.y, Real{800}, 0.01_r);
}

TEST_F(SceneFileFaults, MassZeroMakesStatic) {
    const Outcome outcome =
        load("[[entity]]\nprimitive={sphere=1}\nbody={mass_kg=0, velocity_mps=[1,0,0]}");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.scene->entities[0].body->kind, physics::BodyKind::Static);
    EXPECT_EQ(glm::length(outcome.scene->entities[0].body->velocity_mps), Real{0});
}

TEST_F(SceneFileFaults, ImpossibleInertiaIsLeftToTheShape) {
    const Outcome outcome =
        load("[[entity]]\nprimitive={sphere=1}\nbody={inertia_kgm2=[1, 2, 3.1]}");
    ASSERT_TRUE(outcome.scene.ok());
    EXPECT_EQ(outcome.faults.size(), 1U);
    EXPECT_FALSE(outcome.scene->entities[0].body->inertia_kgm2);
    // A thin plate has exactly the sum.
    EXPECT_TRUE(
        load("[[entity]]\nprimitive={sphere=1}\nbody={inertia_kgm2=[1, 2, 3]}").faults.empty());
}

}  // namespace
}  // namespace plumbline::scene
