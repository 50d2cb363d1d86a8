// The scene that "adopt" writes: the one that runs, with the setting over it.
#include "engine/app/accuracy/accuracy_copy.h"

#include "engine/core/io/files.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/app/session_fixture.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

const std::string kScene = R"(# a comment
[scene]
title = "t"

[accuracy]
preset = "draft"
step_hz = 30

)" + cube_text("cube", "0, 5, 0");

class AdoptedCopy : public testing::Test {
protected:
    scene::Accuracy accuracy_of(const std::filesystem::path& file) {
        Diagnostics faults;
        const auto description = scene::read_description(file, folder_.path(), faults);
        EXPECT_TRUE(description.ok());
        EXPECT_EQ(faults.list().size(), 0U);
        return description ? description->accuracy : scene::Accuracy{};
    }
    std::filesystem::path write(const std::string& text) {
        const std::filesystem::path file = folder_.path() / "mine.toml";
        EXPECT_TRUE(write_file_atomically(file, text).ok());
        return file;
    }

    Result<std::filesystem::path> adopt(const std::filesystem::path& scene,
                                        const study::Setting& setting) {
        return write_adopted_copy(
            scene,
            setting,
            {.assets = folder_.path() / "assets", .user_scenes = folder_.path() / "user"});
    }

    test::TemporaryFolder folder_;
};

TEST_F(AdoptedCopy, HoldsTheSettingAndEverythingElse) {
    const auto copy = adopt(write(kScene), {.step_hz = 120, .substeps = 8});
    ASSERT_TRUE(copy.ok());
    EXPECT_EQ(copy->filename(), "mine-adopted.toml");
    const scene::Accuracy accuracy = accuracy_of(*copy);
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_EQ(accuracy.substeps, 8);
    EXPECT_EQ(accuracy.preset, "balanced") << "nothing of the scene's own preset";
    EXPECT_EQ(*read_file(*copy, 10000),
              "# \"mine.toml\", at an accuracy that was chosen in play.\n"
              "[scene]\nbase = \"mine.toml\"\nwithout = [\"accuracy\"]\n\n"
              "[accuracy]\nsolver = \"small_step\"\nstep_hz = 120\nsubsteps = 8\n"
              "iterations = 1\n");
}

TEST_F(AdoptedCopy, GetsTheTableThatTheSceneLacks) {
    std::string text = kScene;
    text.erase(text.find("[accuracy]"), text.find("[[entity]]") - text.find("[accuracy]"));
    const auto copy = adopt(
        write(text),
        {.solver = physics::Solver::BulletSi, .step_hz = 240, .substeps = 1, .iterations = 20});
    ASSERT_TRUE(copy.ok());
    const scene::Accuracy accuracy = accuracy_of(*copy);
    EXPECT_EQ(accuracy.solver, physics::Solver::BulletSi);
    EXPECT_EQ(accuracy.iterations, 20);
}

constexpr study::Setting kChosen{.step_hz = 120, .substeps = 8};

void expect_chosen(const scene::Accuracy& accuracy) {
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_EQ(accuracy.substeps, 8);
    EXPECT_EQ(accuracy.substeps_max.value_or(8), 8);
    EXPECT_EQ(accuracy.solver, physics::Solver::SmallStep);
}

// Each of these headers is the same table to the parser.
TEST_F(AdoptedCopy, FindsTheTableHoweverItIsWritten) {
    const std::string rest = R"(
[[entity]]
name = "cube"
primitive = { box = [1, 1, 1] }
)";
    for (const std::string& head :
         {std::string("[accuracy]\nstep_hz = 30\nsubsteps = 2\nsubsteps_max = 4\n"),
          std::string("\t[ accuracy ]  # here\r\nstep_hz = 30\r\n"),
          std::string("[\"accuracy\"]\n'step_hz' = 30\n"),
          std::string("accuracy = { step_hz = 30, preset = \"draft\" }\n"),
          std::string("accuracy = {}\n"),
          std::string("accuracy.step_hz = 30\naccuracy.preset = \"auto\"\n"),
          std::string("\xEF\xBB\xBF[accuracy]\nstep_hz = 30\n"),
          std::string("[scene]\ntitle = \"\"\"\n[accuracy]\nstep_hz = 30\n\"\"\"\n"),
          std::string("[scene]\ntitle = \"\u00e9t\u00e9\"\n[accuracy] # \u00e9\npreset = \"draft\" "
                      "# \u00e9\n"),
          std::string()}) {
        const auto copy = adopt(write(head + rest), kChosen);
        ASSERT_TRUE(copy.ok()) << head << copy.error().message;
        expect_chosen(accuracy_of(*copy));
    }
}

TEST_F(AdoptedCopy, LosesNothingOfTheFile) {
    const std::filesystem::path file = write(R"(# on top
scene.title = "a tower"
world.gravity_mps2 = [0, -1.62, 0]
[accuracy]
preset = "auto"
tolerance = 0.5
joints = "iterative"
[[material]]
name = "red"
[[entity]]
name = "cube"
material = "red"
primitive = { box = [1, 1, 1] }
[entity.body]
kind = "dynamic"
)");
    const auto copy = adopt(file, kChosen);
    ASSERT_TRUE(copy.ok()) << copy.error().message;
    Diagnostics faults;
    const auto own = scene::read_description(file, folder_.path(), faults);
    const auto made = scene::read_description(*copy, folder_.path(), faults);
    ASSERT_TRUE(own.ok() && made.ok());
    EXPECT_TRUE(faults.list().empty());
    EXPECT_EQ(made->title, "a tower");
    EXPECT_EQ(made->gravity_mps2, own->gravity_mps2);
    EXPECT_EQ(made->materials.size(), 1U);
    ASSERT_EQ(made->entities.size(), 1U);
    EXPECT_EQ(made->entities[0].name, "cube");
    EXPECT_EQ(made->accuracy.joints, physics::JointMethod::Iterative);
    EXPECT_FALSE(made->accuracy.tolerance) << "a wish of the preset";
    expect_chosen(made->accuracy);
    // What is adopted can be adopted again.
    const auto again = adopt(*copy, {.step_hz = 240, .substeps = 2});
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(again->filename(), "mine-adopted-adopted.toml");
    EXPECT_EQ(accuracy_of(*again).step_hz, 240);
    EXPECT_EQ(accuracy_of(*again).joints, physics::JointMethod::Iterative);
}

TEST_F(AdoptedCopy, NamesItsSceneHoweverThatIsCalled) {
    for (const char* name : {"a \"b\".toml", "\xC3\xA9t\xC3\xA9.toml", "tab\there.toml"}) {
        const auto scene = folder_.write(name, kScene);
        const auto copy = adopt(scene, kChosen);
        ASSERT_TRUE(copy.ok()) << copy.error().message;
        expect_chosen(accuracy_of(*copy));
    }
}

TEST_F(AdoptedCopy, OverwritesNothing) {
    const std::filesystem::path scene = write(kScene);
    EXPECT_EQ(adopt(scene, kChosen)->filename(), "mine-adopted.toml");
    const std::string first = *read_file(folder_.path() / "mine-adopted.toml", 10000);
    EXPECT_EQ(adopt(scene, {.step_hz = 240})->filename(), "mine-adopted-2.toml");
    EXPECT_EQ(*read_file(folder_.path() / "mine-adopted.toml", 10000), first);
    EXPECT_EQ(*read_file(scene, 10000), kScene);
}

// The program's folders are not the user's to change, and may be read-only.
TEST_F(AdoptedCopy, OfTheProgramsScenesGoesToTheUsersAndFindsItsFiles) {
    folder_.write("assets/scenes/parts/wood.toml", "[[material]]\nname = \"oak\"\n");
    folder_.write("assets/models/chair.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto scene = folder_.write("assets/scenes/hall.toml", R"([scene]
include = ["parts/wood.toml"]
[[entity]]
name = "chair"
model = "../models/chair.obj"
material = "oak"
)");
    const auto copy = adopt(scene, kChosen);
    ASSERT_TRUE(copy.ok()) << copy.error().message;
    EXPECT_EQ(*copy, folder_.path() / "user" / "hall-adopted.toml");
    Diagnostics faults;
    const auto loaded = scene::read_description(*copy, folder_.path() / "assets", faults);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_TRUE(faults.list().empty());
    expect_chosen(loaded->accuracy);
    EXPECT_EQ(loaded->materials.count("oak"), 1U);
    const auto& model = std::get<scene::ModelVisual>(loaded->entities.at(0).visual);
    EXPECT_TRUE(
        std::filesystem::equivalent(model.file, folder_.path() / "assets/models/chair.obj"));
}

TEST_F(AdoptedCopy, RefusesModelsAndWhatIsNotThere) {
    EXPECT_EQ(adopt(folder_.path() / "crate.glb", {}).error().message,
              "crate.glb is no scene file that another one can start from");
    EXPECT_FALSE(adopt(folder_.path() / "none.toml", {}).ok());
    EXPECT_FALSE(adopt(write("[scene\n"), {}).ok());
    EXPECT_EQ(folder_.count(), 1U) << "no copy of it";
    const auto ours = folder_.write("assets/hall.toml", kScene);
    EXPECT_EQ(
        write_adopted_copy(ours, kChosen, {.assets = folder_.path() / "assets"}).error().message,
        "no folder for scenes: neither XDG_DATA_HOME nor HOME is set");
}

TEST_F(AdoptedCopy, SaysTheMostOnlyWhereIslandsAsk) {
    const auto scene =
        write("[accuracy]\nsubsteps = 4\nsubsteps_max = 4\n" + cube_text("cube", "0, 5, 0"));
    const auto copy = adopt(scene, {.step_hz = 60, .substeps = 0, .substeps_max = 32});
    ASSERT_TRUE(copy.ok()) << copy.error().message;
    EXPECT_EQ(accuracy_of(*copy).substeps, 2) << "the fewest that an island gets";
    EXPECT_EQ(accuracy_of(*copy).substeps_max, 32);
    const auto fixed = adopt(scene, {.step_hz = 60, .substeps = 2});
    ASSERT_TRUE(fixed.ok()) << fixed.error().message;
    EXPECT_EQ(accuracy_of(*fixed).substeps, 2);
    EXPECT_EQ(accuracy_of(*fixed).substeps_max, std::nullopt)
        << "the most of another choice is not left behind";
}

}  // namespace
}  // namespace plumbline::app
