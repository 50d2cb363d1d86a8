// [[rope]]: what it says is what the description holds, what it gets wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

namespace plumbline::scene {
namespace {

const std::string kLoad =
    "[[entity]]\nname = \"load\"\nprimitive = { sphere = 0.1 }\nposition_m = [0, 3, 0]\n"
    "[entity.body]\nmass_kg = 2\n";
const std::string kRope = "[[rope]]\na = \"world\"\nanchor_a_m = [0, 5, 0]\n";

TEST_F(SceneFileTest, KeysOfARopeAreRead) {
    const Outcome outcome =
        load(kLoad + kRope +
             "name = \"line\"\nb = \"load\"\nanchor_b_m = [0, 3.1, 0]\n"
             "length_m = 2.5\ndamping_s = 0.1\nradius_m = 0.02\nmass_kg = 0.3\n"
             "stiffness_N = 1000\nbend_Nm2 = 0.5\nfriction = 0.7\nbreak_N = 90\n"
             "pieces = 12\n[effects.rope]\nfidelity = \"precise\"\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_TRUE(outcome.faults.empty());
    ASSERT_EQ(outcome.scene->forces.ropes.size(), 1U);
    const RopeDescription& rope = outcome.scene->forces.ropes.front();
    EXPECT_EQ(rope.name, "line");
    EXPECT_EQ(rope.a, "world");
    EXPECT_EQ(rope.b, "load");
    expect_near(rope.anchor_a_m, {0, 5, 0});
    expect_near(rope.anchor_b_m, {0, 3.1_r, 0});
    EXPECT_NEAR(rope.length_m, 2.5, 1e-6);
    EXPECT_NEAR(rope.damping_s, 0.1, 1e-6);
    EXPECT_NEAR(rope.radius_m, 0.02, 1e-6);
    EXPECT_NEAR(rope.mass_kg, 0.3, 1e-6);
    EXPECT_NEAR(rope.stiffness_N, 1000, 1e-6);
    EXPECT_NEAR(rope.bend_Nm2, 0.5, 1e-6);
    EXPECT_NEAR(rope.friction, 0.7, 1e-6);
    EXPECT_NEAR(rope.break_N, 90, 1e-6);
    EXPECT_EQ(rope.pieces, 12);
    EXPECT_EQ(outcome.scene->forces.fidelity.rope, Fidelity::Precise);
}

// As long as it is from anchor to anchor, or along its path; a free end hangs.
TEST_F(SceneFileTest, ARopeIsAsLongAsItsWay) {
    const Outcome outcome =
        load(kLoad + kRope + "b = \"load\"\n" + kRope +
             "path_m = [[0, 5, 0], [1, 5, 0], [1, 4, 0]]\n" + kRope + "length_m = 1.5\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const std::vector<RopeDescription>& ropes = outcome.scene->forces.ropes;
    EXPECT_NEAR(ropes[0].length_m, 2, 1e-6);
    EXPECT_EQ(ropes[0].name, "rope#1");
    EXPECT_NEAR(ropes[1].length_m, 2, 1e-6);
    expect_near(ropes[1].anchor_b_m, {1, 4, 0});
    expect_near(ropes[2].anchor_b_m, {0, 3.5_r, 0});
}

TEST_F(SceneFileTest, FaultsOfRopesAreNamed) {
    const Outcome outcome =
        load(kLoad + "[[rope]]\nlength_m = 1\n" + "[[rope]]\na = \"lod\"\nlength_m = 1\n" +
             "[[rope]]\na = \"world\"\nlength_m = 1\n" + kRope + "b = \"load\"\nlength_m = 1.5\n" +
             kRope + "path_m = [[0, 5, 0], [1, 5, 0]]\nlength_m = 3\n" + kRope +
             "path_m = [[0, 5, 0]]\n" + kRope + "\n" + kRope +
             "length_m = 1\nmass_kg = -1\nfriction = \"high\"\n" +
             "[[rope]]\nname = \"load\"\na = \"load\"\nb = \"load\"\nlength_m = 1\n");
    std::string all;
    for (const std::string& fault : outcome.faults) all += fault + "\n";
    for (const char* part : {"rope[0].a: missing",
                             "rope[1].a: no entity is called \"lod\"",
                             "rope[2].anchor_a_m: missing",
                             "rope[3].length_m: 1.5 m do not reach over 2 m",
                             "rope[4].length_m: 3 m, but its path_m is 1 m long",
                             "rope[5].path_m: expected 2 to 256 points",
                             "rope[6].length_m: missing",
                             "rope[7].mass_kg",
                             "rope[7].friction",
                             "rope[8].b: \"load\" is at the other end already",
                             "rope[8].name: \"load\" is the name of another rope or entity"})
        EXPECT_NE(all.find(part), std::string::npos) << part << "\nin\n" << all;
    EXPECT_FALSE(outcome.scene.ok());
}

}  // namespace
}  // namespace plumbline::scene
