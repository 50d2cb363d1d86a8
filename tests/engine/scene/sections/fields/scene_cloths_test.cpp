// [[cloth]]: what it says is what the description holds, what it gets wrong is named.
#include "tests/engine/scene/sections/scene_file_fixture.h"

#include <fmt/ranges.h>

namespace plumbline::scene {
namespace {

const std::string kCloth = "[[cloth]]\nsize_m = [1, 0.6]\n";

TEST_F(SceneFileTest, KeysOfAClothAreRead) {
    const Outcome outcome = load(
        "[[entity]]\nname = \"pole\"\nprimitive = { box = [1, 1, 1] }\n[entity.body]\n" + kCloth +
        "name = \"flag\"\nposition_m = [1, 2, 3]\nrotation_deg = [0, 90, 0]\ncells = [10, "
        "6]\nfolds = 5\ngather = 0.5\n"
        "density_kgpm2 = 0.3\nstretch_Npm = 900\nshear_Npm = 200\nbend_Nm = 0.01\n"
        "thickness_m = 0.01\nfriction = 0.7\ndamping_s = 0.1\ndrag = 2\ntear_Npm = 500\n"
        "pins = [{ at = [0, 0.5] }, { edge = \"right\", to = \"pole\" }]\n"
        "[effects.cloth]\nfidelity = \"draft\"\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    ASSERT_EQ(outcome.scene->forces.cloths.size(), 1U);
    const ClothDescription& cloth = outcome.scene->forces.cloths.front();
    EXPECT_EQ(cloth.name, "flag");
    EXPECT_NEAR(cloth.size_m[1], 0.6, 1e-6);
    EXPECT_EQ(cloth.cells, (std::array{10, 6}));
    EXPECT_EQ(cloth.folds, 5);
    EXPECT_NEAR(cloth.gather, 0.5, 1e-6);
    EXPECT_NEAR(cloth.density_kgpm2, 0.3, 1e-6);
    EXPECT_NEAR(cloth.stretch_Npm, 900, 1e-6);
    EXPECT_NEAR(cloth.shear_Npm.value_or(0), 200, 1e-6);
    EXPECT_NEAR(cloth.bend_Nm, 0.01, 1e-6);
    EXPECT_NEAR(cloth.thickness_m, 0.01, 1e-6);
    EXPECT_NEAR(cloth.friction, 0.7, 1e-6);
    EXPECT_NEAR(cloth.damping_s, 0.1, 1e-6);
    EXPECT_NEAR(cloth.drag, 2, 1e-6);
    EXPECT_NEAR(cloth.tear_Npm, 500, 1e-6);
    ASSERT_EQ(cloth.pins.size(), 2U);
    EXPECT_EQ(cloth.pins[0].along, (std::array{0.0, 0.5, 0.0, 0.5}));
    EXPECT_EQ(cloth.pins[1].along, (std::array{1.0, 0.0, 1.0, 1.0}));
    EXPECT_EQ(cloth.pins[1].to, "pole");
    EXPECT_EQ(outcome.scene->forces.fidelity.cloth, Fidelity::Draft);
}

TEST_F(SceneFileTest, ClothsHaveTheirUsualNumbers) {
    const Outcome outcome =
        load(kCloth + kCloth +
             "pins = [{ edge = \"top\", to = \"world\" }]\nself_collision = true\nasleep = true\n");
    ASSERT_TRUE(outcome.scene.ok()) << outcome.scene.error().message;
    EXPECT_EQ(outcome.scene->forces.cloths[0].name, "cloth#1");
    EXPECT_FALSE(outcome.scene->forces.cloths[0].shear_Npm);
    EXPECT_FALSE(outcome.scene->forces.cloths[0].cells);
    EXPECT_EQ(outcome.scene->forces.cloths[1].pins[0].to, "");
    EXPECT_FALSE(outcome.scene->forces.cloths[0].self_collision);
    EXPECT_TRUE(outcome.scene->forces.cloths[1].self_collision);
    EXPECT_FALSE(outcome.scene->forces.cloths[0].asleep);
    EXPECT_TRUE(outcome.scene->forces.cloths[1].asleep);
    EXPECT_TRUE(outcome.faults.empty());
}

TEST_F(SceneFileTest, FaultsOfClothsAreNamed) {
    const Outcome outcome = load(
        "[[cloth]]\n" + kCloth + "cells = [1000, 1000]\n" + kCloth + "cells = [2.5, 3]\n" + kCloth +
        "pins = [{ at = [0, 2] }, { edge = \"middle\" }, { to = \"pole\", at = [0, 0] }, { }]\n" +
        kCloth + "name = \"a\"\ndensity_kgpm2 = 0\n" + kCloth + "name = \"a\"\n" + kCloth +
        "folds = 3\n" + kCloth + "gather = 0.5\n" + kCloth +
        "cells = [5, 9]\nfolds = 3\ngather = 0.5\n");
    EXPECT_FALSE(outcome.scene.ok());
    const std::string faults = fmt::format("{}", fmt::join(outcome.faults, "\n"));
    for (const char* part : {"size_m",
                             "1000000 in all; at most 40000",
                             "two whole numbers",
                             "shares from 0 to 1",
                             "middle",
                             "pole",
                             "or an edge",
                             "kg/m2 from 0.001",
                             "the share of its width",
                             "a flat cloth has none",
                             "3 of them need at least 6 cells",
                             "is the name of another cloth"})
        EXPECT_NE(faults.find(part), std::string::npos) << part << "\n" << faults;
}

}  // namespace
}  // namespace plumbline::scene
