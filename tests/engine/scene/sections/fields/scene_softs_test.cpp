// [[soft]]: what it says is what the description holds, what it gets wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <fmt/ranges.h>

namespace plumbline::scene {
namespace {

const std::string kSoft = "[[soft]]\nprimitive = { box = [1, 2, 3] }\n";

TEST_F(SceneFileTest, KeysOfASoftBodyAreRead) {
    const Outcome outcome =
        load(kSoft +
             "name = \"jelly\"\nposition_m = [0, 2, 0]\ncell_m = 0.5\ndensity_kgpm3 = 500\n"
             "young_Pa = 2e5\npoisson = 0.3\ndamping_s = 0.1\nfriction = 0.9\n"
             "pins = [{ min_m = [-1, 0, -1], max_m = [1, 1, 1], to = \"world\" }]\n"
             "[[soft]]\nprimitive = { ellipsoid = [1, 0.5, 0.25] }\n[effects.soft]\nfidelity = "
             "\"precise\"\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    const std::vector<SoftDescription>& softs = outcome.scene->forces.softs;
    ASSERT_EQ(softs.size(), 2U);
    EXPECT_EQ(softs[0].name, "jelly");
    EXPECT_EQ(softs[0].form, SoftForm::Box);
    EXPECT_NEAR(softs[0].size_m.z, 3, 1e-6);
    EXPECT_NEAR(softs[0].cell_m.value_or(0), 0.5, 1e-6);
    EXPECT_NEAR(softs[0].density_kgpm3, 500, 1e-6);
    EXPECT_NEAR(softs[0].young_Pa, 2e5, 1e-3);
    EXPECT_NEAR(softs[0].poisson, 0.3, 1e-6);
    EXPECT_NEAR(softs[0].damping_s, 0.1, 1e-6);
    EXPECT_NEAR(softs[0].friction, 0.9, 1e-6);
    ASSERT_EQ(softs[0].pins.size(), 1U);
    expect_near(softs[0].pins[0].max_m, {1, 1, 1});
    EXPECT_EQ(softs[1].name, "soft#2");
    EXPECT_EQ(softs[1].form, SoftForm::Ellipsoid);
    EXPECT_EQ(outcome.scene->forces.fidelity.soft, Fidelity::Precise);
}

TEST_F(SceneFileTest, FaultsOfSoftBodiesAreNamed) {
    const Outcome outcome =
        load("[[soft]]\n[[soft]]\nprimitive = { sphere = 1 }\n" + kSoft + "cell_m = 0.01\n" +
             kSoft + "poisson = 0.5\n" + kSoft + "pins = [{ min_m = [0, 0, 0] }]\nname = \"a\"\n" +
             kSoft + "name = \"a\"\n" + "[[soft]]\nmodel = \"nothing.glb\"\n");
    EXPECT_FALSE(outcome.scene.ok());
    const std::string faults = fmt::format("{}", fmt::join(outcome.faults, "\n"));
    for (const char* part : {"expected { box = [x, y, z] }",
                             "expected box or ellipsoid",
                             "6000000 cells; at most 20000",
                             "a ratio from 0 to 0.499",
                             "max_m",
                             "is the name of another soft body",
                             "nothing.glb"})
        EXPECT_NE(faults.find(part), std::string::npos) << part << "\n" << faults;
}

}  // namespace
}  // namespace plumbline::scene
