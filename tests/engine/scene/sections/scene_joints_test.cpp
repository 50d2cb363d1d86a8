// [[joint]].
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

TEST_F(SceneFileTest, JointsOfEveryKind) {
    const Outcome outcome = load(R"([[prefab]]
name = "link"
primitive = { box = [1, 1, 1] }
body = {}
[[array]]
name = "chain"
prefab = "link"
origin_m = [0, 10, 0]
count = [1, 1, 3]
spacing_m = [1, 1, 2]
[[joint]]
name = "hang"
kind = "ball_and_socket"
a = "chain.0.0.0"
b = "world"
anchor_m = [0, 11, 0]
collide = true
break_N = 500
[[joint]]
kind = "hinge"
a = "chain.0.0.1"
b = "chain.0.0.0"
anchor_m = [0, 10, 1]
axis = [0, 2, 0]
limits = [-90, 180]
motor = { target = 3.0, max = 20, stiffness = 40, damping = 5, position = 0.5 }
[[joint]]
kind = "slider"
a = "chain.0.0.1"
b = "world"
axis = [1, 0, 0]
limits = [-1, 2]
[[joint]]
kind = "fixed"
a = "chain.0.0.2"
b = "world"
[[joint]]
kind = "cone"
a = "chain.0.0.2"
b = "world"
anchor_m = [0, 0, 0]
axis = [0, 0, 1]
limits = [0, 45]
twist = [-10, 30]
[[joint]]
kind = "distance"
a = "chain.0.0.1"
b = "chain.0.0.2"
[[joint]]
kind = "spring"
a = "chain.0.0.1"
b = "world"
anchor_a_m = [0, 10, 2]
anchor_b_m = [0, 20, 2]
stiffness_Npm = 100
damping_Nspm = 2
rest_length_m = 1.5
)");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const auto& joints = outcome.scene->joints;
    ASSERT_EQ(joints.size(), 7U);
    EXPECT_EQ(joints[0].name, "hang");
    EXPECT_EQ(joints[0].b, "world");
    EXPECT_TRUE(joints[0].collide);
    EXPECT_EQ(joints[0].break_N, Real{500});
    expect_near(joints[0].anchor_b_m, {0, 11, 0});
    EXPECT_EQ(joints[1].kind, JointKind::Hinge);
    expect_near(joints[1].axis, {0, 1, 0});
    EXPECT_NEAR((*joints[1].limits)[0], -kPi / 2, kSlack);
    EXPECT_NEAR((*joints[1].limits)[1], kPi, kSlack);
    EXPECT_EQ(joints[1].motor->target, Real{3});
    EXPECT_EQ(joints[1].motor->max, Real{20});
    EXPECT_EQ(joints[1].motor->stiffness, Real{40});
    EXPECT_EQ(joints[1].motor->damping, Real{5});
    EXPECT_EQ(joints[1].motor->position, 0.5_r);
    EXPECT_EQ((*joints[2].limits)[1], Real{2});  // metres stay metres
    EXPECT_EQ(joints[4].kind, JointKind::Cone);
    EXPECT_NEAR((*joints[4].limits)[1], kPi / 4, kSlack);
    EXPECT_NEAR((*joints[4].twist)[0], -kPi / 18, kSlack);
    EXPECT_NEAR((*joints[4].twist)[1], kPi / 6, kSlack);
    expect_near(joints[5].anchor_a_m, {0, 10, 2});  // where the copies start
    expect_near(joints[5].anchor_b_m, {0, 10, 4});
    EXPECT_EQ(joints[6].stiffness_Npm, Real{100});
    EXPECT_EQ(joints[6].damping_Nspm, Real{2});
    EXPECT_EQ(joints[6].rest_length_m, 1.5_r);
    EXPECT_TRUE(outcome.faults.empty());
}

TEST_F(SceneFileTest, JointFaults) {
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

TEST_F(SceneFileTest, JointsHoldBodies) {
    const std::string two = std::string(kMovable) + "[[entity]]\nname = \"lamp\"\n[[joint]]\n";
    const std::string hinge = "kind = \"hinge\"\nanchor_m = [0, 0, 0]\n";
    expect_only(two + hinge + "a = \"lamp\"\nb = \"world\"\n",
                "10:5: error: joint[0].a: \"lamp\" (scene.toml:6) has no body to hold on to");
    expect_only(two + hinge + "a = \"lmp\"\nb = \"world\"\n",
                "10:5: error: joint[0].a: no entity is called \"lmp\"; did you mean \"lamp\" "
                "(scene.toml:6)?");
    expect_only(two + hinge + "a = \"a\"\n",
                "7:1: error: joint[0].b: missing; expected the name of an entity");
    expect_only(two + hinge + "a = \"a\"\nb = \"a\"\n",
                "11:5: error: joint[0].b: \"a\" cannot be joined to itself");
}

TEST_F(SceneFileTest, JointsNeedTheirAnchors) {
    const std::string to_world =
        std::string(kMovable) + "[[joint]]\na = \"a\"\nb = \"world\"\nkind = ";
    for (const char* kind : {"ball_and_socket", "hinge", "cone"}) {
        expect_only(to_world + "\"" + kind + "\"\n",
                    "5:1: error: joint[0].anchor_m: missing; expected the point to turn about, "
                    "[x, y, z] in world m");
    }
    EXPECT_TRUE(load(to_world + "\"fixed\"\n").faults.empty());
    EXPECT_TRUE(load(to_world + "\"slider\"\n").faults.empty());
    expect_only(to_world + "\"distance\"\nrest_length_m = 1\n",
                "5:1: error: joint[0].anchor_b_m: missing; the world needs a point to hold on to");
    expect_only(to_world + "\"slider\"\nlimits = [1]\n",
                "9:10: error: joint[0].limits: an array of 1; expected two numbers");
    expect_only(to_world + "\"slider\"\nlimits = [2, 1]\n",
                "9:10: error: joint[0].limits: 2 is above 1; expected [lower, upper]");
}

TEST_F(SceneFileTest, JointsHaveNamesOfTheirOwn) {
    const std::string joint =
        "[[joint]]\nname = \"j\"\na = \"a\"\nb = \"world\"\nkind = \"fixed\"\n";
    expect_only(std::string(kMovable) + joint + joint,
                "11:8: error: joint[1].name: \"j\" is the name of the joint at scene.toml:5 "
                "already");
    const SceneDescription scene =
        good(std::string(kMovable) + "[[joint]]\na = \"a\"\nb = \"world\"\nkind = \"fixed\"\n");
    EXPECT_EQ(scene.joints.at(0).name, "joint[0]");
}

TEST_F(SceneFileTest, KeysThatAKindOfJointDoesNotUse) {
    const auto unused = [&](const std::string& kind) {
        const Outcome outcome =
            load(std::string(kMovable) + "[[joint]]\nkind = \"" + kind +
                 "\"\na = \"a\"\nb = \"world\"\nanchor_m = [0, 0, 0]\nanchor_a_m = [0, 0, 0]\n"
                 "anchor_b_m = [0, 1, 0]\naxis = [0, 1, 0]\nlimits = [0, 1]\ntwist = [0, 1]\n"
                 "motor = { target = 0, max = 1 }\nstiffness_Npm = 1\ndamping_Nspm = 1\n"
                 "rest_length_m = 1\ncreak = 1\n");
        std::string keys;
        for (const Diagnostic& fault : outcome.diagnostics)
            keys += fault.key.substr(fault.key.find('.') + 1) + " ";
        return keys;
    };
    const std::string anchors = "anchor_a_m anchor_b_m ";
    const std::string spring = "stiffness_Npm damping_Nspm rest_length_m ";
    EXPECT_EQ(unused("ball_and_socket"), anchors + "axis limits twist motor " + spring);
    EXPECT_EQ(unused("hinge"), anchors + "twist " + spring);
    EXPECT_EQ(unused("slider"), anchors + "twist " + spring + "creak ");
    EXPECT_EQ(unused("fixed"), anchors + "axis limits twist motor " + spring + "creak ");
    EXPECT_EQ(unused("cone"), anchors + "motor " + spring);
    EXPECT_EQ(unused("distance"), "anchor_m axis twist motor stiffness_Npm damping_Nspm creak ");
    EXPECT_EQ(unused("spring"), "anchor_m axis limits twist motor creak ");
}

}  // namespace
}  // namespace plumbline::scene
