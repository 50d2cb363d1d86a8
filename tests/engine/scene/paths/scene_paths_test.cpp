#include "engine/scene/paths/scene_paths.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace plumbline::scene {
namespace {

namespace fs = std::filesystem;

class ScenePaths : public testing::Test {
protected:
    ScenePaths() {
        for (const char* file : {"assets/scenes/a.toml",
                                 "assets/scenes/own.png",
                                 "assets/textures/t.png",
                                 "assets/both.png",
                                 "assets/scenes/both.png",
                                 "mine/m.toml",
                                 "mine/own.png",
                                 "outside.png"}) {
            fs::create_directories((folder_.path() / file).parent_path());
            std::ofstream(folder_.path() / file) << "x";
        }
    }
    /// The file found, relative to the test's folder; "-" where it does not exist; "!" refused.
    std::string found_from(const std::string& naming_file, const std::string& name) const {
        const Result<Reference> reference =
            find_reference(folder_.path() / naming_file, folder_.path() / "assets", name);
        if (!reference) return "!";
        return (reference->exists ? "" : "-") +
               fs::relative(reference->file, fs::canonical(folder_.path())).string();
    }

private:
    test::TemporaryFolder folder_;
};

TEST_F(ScenePaths, BesideTheFileComesBeforeTheAssets) {
    EXPECT_EQ(found_from("mine/m.toml", "own.png"), "mine/own.png");
    EXPECT_EQ(found_from("mine/m.toml", "textures/t.png"), "assets/textures/t.png");
    EXPECT_EQ(found_from("assets/scenes/a.toml", "own.png"), "assets/scenes/own.png");
    EXPECT_EQ(found_from("assets/scenes/a.toml", "both.png"), "assets/scenes/both.png");
    EXPECT_EQ(found_from("mine/m.toml", "both.png"), "assets/both.png");
    EXPECT_EQ(found_from("mine/m.toml", "none.png"), "-mine/none.png");
}

TEST_F(ScenePaths, OnlyShippedScenesGoUpAndOnlyWithinTheAssets) {
    EXPECT_EQ(found_from("assets/scenes/a.toml", "../textures/t.png"), "assets/textures/t.png");
    EXPECT_EQ(found_from("assets/scenes/a.toml", "../../outside.png"), "!");
    EXPECT_EQ(found_from("mine/m.toml", "../outside.png"), "!");
    EXPECT_EQ(found_from("mine/m.toml", "../assets/both.png"), "!");
}

TEST_F(ScenePaths, NamesThatAreNoneAreRefusedAsTheyStand) {
    for (const char* name : {"", "/etc/passwd", "\\own.png"})
        EXPECT_EQ(found_from("mine/m.toml", name), "!") << name;
}

}  // namespace
}  // namespace plumbline::scene
