#include "engine/app/accuracy_control.h"

#include "engine/core/files.h"
#include "engine/scene/scene_file.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

constexpr const char* kScene = R"(# a comment
[scene]
title = "t"

[accuracy]
preset = "draft"
step_hz = 30

[[entity]]
name = "cube"
position_m = [0, 5, 0]
primitive = { box = [1, 1, 1] }
[entity.body]
kind = "dynamic"
)";

class AdoptedCopy : public testing::Test {
protected:
    scene::Accuracy accuracy_of(const std::filesystem::path& file) {
        Diagnostics faults;
        const auto description = scene::load_scene(file, folder_.path(), faults);
        EXPECT_TRUE(description.ok());
        EXPECT_EQ(faults.list().size(), 0U);
        return description ? description->accuracy : scene::Accuracy{};
    }
    std::filesystem::path write(const std::string& text) {
        const std::filesystem::path file = folder_.path() / "mine.toml";
        EXPECT_TRUE(write_file_atomically(file, text).ok());
        return file;
    }

    test::TemporaryFolder folder_;
};

TEST_F(AdoptedCopy, HoldsTheSettingAndEverythingElse) {
    const auto copy = write_adopted_copy(write(kScene), {.step_hz = 120, .substeps = 8});
    ASSERT_TRUE(copy.ok());
    EXPECT_EQ(copy->filename(), "mine-adopted.toml");
    const scene::Accuracy accuracy = accuracy_of(*copy);
    EXPECT_EQ(accuracy.step_hz, 120);
    EXPECT_EQ(accuracy.substeps, 8);
    const auto text = read_file(*copy, 10000);
    ASSERT_TRUE(text.ok());
    EXPECT_NE(text->find("# a comment"), std::string::npos);
    EXPECT_NE(text->find("name = \"cube\""), std::string::npos);
    EXPECT_EQ(text->find("draft"), std::string::npos);
}

TEST_F(AdoptedCopy, GetsTheTableThatTheSceneLacks) {
    std::string text = kScene;
    text.erase(text.find("[accuracy]"), text.find("[[entity]]") - text.find("[accuracy]"));
    const auto copy = write_adopted_copy(
        write(text),
        {.solver = physics::Solver::BulletSi, .step_hz = 240, .substeps = 1, .iterations = 20});
    ASSERT_TRUE(copy.ok());
    const scene::Accuracy accuracy = accuracy_of(*copy);
    EXPECT_EQ(accuracy.solver, physics::Solver::BulletSi);
    EXPECT_EQ(accuracy.iterations, 20);
}

TEST_F(AdoptedCopy, RefusesModelsAndWhatIsNotThere) {
    EXPECT_FALSE(write_adopted_copy(folder_.path() / "crate.glb", {}).ok());
    EXPECT_FALSE(write_adopted_copy(folder_.path() / "none.toml", {}).ok());
}

}  // namespace
}  // namespace plumbline::app
