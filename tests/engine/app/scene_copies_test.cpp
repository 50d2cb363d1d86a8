// Where scenes that play writes go, and levels among them.
#include "engine/app/scene_copies.h"

#include "engine/core/io/files.h"
#include "engine/scene/scene_file.h"
#include "tests/engine/app/session_fixture.h"
#include "tests/support/scene_in_code.h"

namespace plumbline::app {
namespace {

class SceneCopies : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name) {
        return folder_.write(name, cube_text("cube", "0, 5, 0"));
    }
    scene::SceneFolders folders() const {
        return {.assets = folder_ / "assets", .user_scenes = folder_ / "user"};
    }
    test::TemporaryFolder folder_;
};

TEST_F(SceneCopies, GoBesideTheUsersSceneAndOverwriteNothing) {
    const auto scene = write("mine.toml");
    const auto first = place_of_copy(scene, "level", folders());
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(first->file, folder_ / "mine-level.toml");
    EXPECT_EQ(first->base, "mine.toml");
    EXPECT_FALSE(first->base_is_shipped);
    write("mine-level.toml");
    EXPECT_EQ(place_of_copy(scene, "level", folders())->file, folder_ / "mine-level-2.toml");
}

TEST_F(SceneCopies, OfTheProgramsScenesGoAmongTheUsers) {
    const auto place = place_of_copy(write("assets/scenes/hard/H05.toml"), "level", folders());
    ASSERT_TRUE(place.ok());
    EXPECT_EQ(place->file, folder_ / "user" / "H05-level.toml");
    EXPECT_EQ(place->base, "scenes/hard/H05.toml");
    EXPECT_TRUE(place->base_is_shipped);
    scene::SceneFolders homeless = folders();
    homeless.user_scenes.clear();
    EXPECT_FALSE(place_of_copy(folder_ / "assets/scenes/hard/H05.toml", "level", homeless).ok());
    EXPECT_FALSE(place_of_copy("model.glb", "level", folders()).ok());
}

TEST_F(SceneCopies, AreLevelsThatLoadAsTheSceneIsNow) {
    Diagnostics faults;
    const auto description =
        scene::read_description(write("assets/scenes/mine.toml"), folder_ / "assets", faults);
    ASSERT_TRUE(description.ok());
    test::Running run(*description);
    run.step(30);
    const physics::BodyId cube = run->moving_bodies()[0].body;
    run->physics.set_frozen(cube, true);
    const auto level = write_level(*run, folders());
    ASSERT_TRUE(level.ok()) << level.error().message;
    EXPECT_EQ(level->file, folder_ / "user" / "mine-level.toml");
    EXPECT_TRUE(level->notes.empty()) << "one file is all that another person needs";
    const auto read = scene::read_description(level->file, folder_ / "assets", faults);
    ASSERT_TRUE(read.ok());
    ASSERT_EQ(read->changes.size(), 1U);
    EXPECT_EQ(read->changes[0].world_from_body->position,
              run->physics.state(cube).world_from_body.position);
    EXPECT_EQ(read->changes[0].frozen, true);
}

TEST_F(SceneCopies, OfTheUsersSceneSayWhatTheyNeed) {
    Diagnostics faults;
    const auto description =
        scene::read_description(write("mine.toml"), folder_ / "assets", faults);
    ASSERT_TRUE(description.ok());
    test::Running run(*description);
    const auto level = write_level(*run, folders());
    ASSERT_TRUE(level.ok()) << level.error().message;
    EXPECT_EQ(level->notes, std::vector<std::string>{"it needs mine.toml beside it"});
}

}  // namespace
}  // namespace plumbline::app
