// Where the slots of scenes are. That a saved game goes on to the same bits: tests/scenarios/saved_game_test.cpp.
#include "engine/effects/saved_game.h"

#include "engine/core/io/archive.h"
#include "engine/core/io/saved_file.h"
#include "engine/scene/paths/scene_list.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

namespace plumbline::effects {
namespace {
namespace fs = std::filesystem;

const fs::path kShipped = fs::path(PL_SOURCE_DIR) / "assets";
const fs::path kSaves = fs::path("data") / "saves";

TEST(SaveSlots, OfShippedScenesAreWhereTheyAlwaysWere) {
    EXPECT_EQ(save_slot("data", kShipped, kShipped / "scenes/garden.toml", 1),
              kSaves / "garden-1.save");
    EXPECT_EQ(save_slot("data", kShipped, kShipped / "scenes/hard/H05.toml", 9),
              kSaves / "H05-9.save");
}

TEST(SaveSlots, NoTwoShippedScenesShareOne) {
    std::map<fs::path, fs::path> scene_of;
    const std::vector<scene::ListedScene> scenes =
        scene::list_scenes({.assets = kShipped, .user_scenes = {}});
    ASSERT_GT(scenes.size(), 100U);
    for (const scene::ListedScene& scene : scenes) {
        const auto [other, is_new] =
            scene_of.emplace(save_slot("data", kShipped, scene.file, 1), scene.file);
        EXPECT_TRUE(is_new) << scene.file << " and " << other->second << ": " << other->first;
    }
}

TEST(SaveSlots, ScenesOfOneNameInTwoFoldersShareNone) {
    const test::TemporaryFolder folder;
    for (const char* name : {"one", "two"}) {
        fs::create_directories(folder.path() / name);
        std::ofstream(folder.path() / name / "house.toml") << "[scene]\n";
    }
    const fs::path one = save_slot("data", kShipped, folder.path() / "one/house.toml", 3);
    const fs::path two = save_slot("data", kShipped, folder.path() / "two/house.toml", 3);
    EXPECT_EQ(one.filename(), "house-3.save");
    EXPECT_EQ(two.filename(), "house-3.save");
    EXPECT_NE(one.parent_path(), two.parent_path());
    EXPECT_EQ(one.parent_path().parent_path(), kSaves);
    EXPECT_EQ(save_slot("data", kShipped, folder.path() / "two/../one/./house.toml", 3), one)
        << "however the path is written";
}

TEST(SaveSlots, OfAModelAndASceneOfOneStemAreTwo) {
    EXPECT_NE(save_slot("data", kShipped, kShipped / "scenes/viewer/triangle.toml", 1),
              save_slot("data", kShipped, kShipped / "scenes/viewer/triangle.obj", 1));
}

TEST(SavedGameHead, OfAnotherVersionOfTheProgramIsRefused) {
    std::string precision = kPrecisionName;
    std::string build = "9.9";
    std::string scene = "a.toml";
    std::string game = "no game";
    double time_s = 1;
    std::uint64_t steps = 60;
    std::vector<SavedGame::File> files;
    std::vector<scene::EffectFidelity> fidelity;
    Archive head;
    head(precision, build, scene, game, time_s, steps, files, fidelity);
    const Result<SavedGame> read = saved_game_from(shelled(head.written()), "a.save");
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().exit_code, ExitCode::Refused);
    EXPECT_EQ(
        read.error().message.find("a.save: saved by version 9.9 of the program; this is version "),
        0U)
        << read.error().message;
}

}  // namespace
}  // namespace plumbline::effects
