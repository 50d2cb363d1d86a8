// Where the slots of scenes are. That a saved game goes on to the same bits: tests/scenarios/saved_game_test.cpp.
#include "engine/effects/saved_game.h"

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

}  // namespace
}  // namespace plumbline::effects
