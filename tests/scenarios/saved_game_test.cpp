// Saved in the middle and put into a fresh world, a scene goes on to the same bits as the one that
// never stopped: every scene that ships, every solver, in both precisions.
#include "engine/effects/saved_game.h"

#include "engine/core/hash.h"
#include "engine/scene/paths/scene_list.h"
#include "tests/scenarios/scene_run.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace plumbline {
namespace {

using test::SceneRun;
using test::TemporaryFolder;

/// Files below assets/scenes.
std::vector<std::string> every_scene() {
    std::vector<std::string> names;
    for (const scene::ListedScene& scene :
         scene::list_scenes({.assets = test::repository() / "assets", .user_scenes = {}}))
        names.push_back(scene.name + scene.file.extension().string());
    return names;
}

class SavedScene : public testing::TestWithParam<std::string> {};

TEST_P(SavedScene, GoesOnToTheSameBitsWithEverySolver) {
    constexpr std::uint64_t kBefore = 30;
    constexpr std::uint64_t kAfter = 30;
    constexpr std::size_t kMostBodies = 40;
    const TemporaryFolder folder;
    for (const physics::Solver solver : physics::kSolvers) {
        SCOPED_TRACE(physics::solver_name(solver));
        SceneRun first(GetParam(), {.solver = solver});
        ASSERT_TRUE(first.simulation);
        // The others take minutes for hard cases and for piles.
        const bool is_quick =
            solver == physics::Solver::SmallStep || solver == physics::Solver::BulletSi;
        const bool is_hard = GetParam().starts_with("hard/") || GetParam().starts_with("bench/");
        if (!is_quick && (is_hard || first.simulation->moving_bodies().size() > kMostBodies))
            continue;
        first.step(kBefore);
        const Result<Done> saved =
            effects::save_game(folder / "one.save", first.running(), kBefore);
        ASSERT_TRUE(saved.ok()) << saved.error().message;

        SceneRun second(GetParam(), {.solver = solver});
        const Result<effects::SavedGame> read = effects::read_saved_game(folder / "one.save");
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_EQ(read->steps, kBefore);
        const Result<Done> there = effects::put_back(*read, folder / "one.save", second.running());
        ASSERT_TRUE(there.ok()) << there.error().message;
        EXPECT_EQ(second.simulation->steps(), kBefore);
        EXPECT_EQ(hex_of(second.simulation->state_hash()), hex_of(first.simulation->state_hash()));

        // Nothing of it was forgotten: saved again it is the same file.
        ASSERT_TRUE(effects::save_game(folder / "two.save", second.running(), kBefore).ok());
        EXPECT_TRUE(folder.read("two.save") == folder.read("one.save"));

        first.step(kAfter);
        second.step(kAfter);
        EXPECT_EQ(hex_of(second.simulation->state_hash()), hex_of(first.simulation->state_hash()));
    }
}

// The waves know what went in the latest step.
TEST(SavedWater, KnowsWhatWentInTheLatestStep) {
    const TemporaryFolder folder;
    SceneRun first("effects/water.toml");
    ASSERT_TRUE(first.simulation);
    first.step(60);
    first.simulation->registry.mark_for_destruction(first.simulation->find("float 2"));
    first.step(1);
    ASSERT_FALSE(first.simulation->registry.alive(first.simulation->find("float 2")));
    const auto file = folder / "one.save";
    ASSERT_TRUE(effects::save_game(file, first.running(), 61).ok());
    SceneRun second("effects/water.toml");
    const Result<effects::SavedGame> read = effects::read_saved_game(file);
    ASSERT_TRUE(read.ok());
    const Result<Done> there = effects::put_back(*read, file, second.running());
    ASSERT_TRUE(there.ok()) << there.error().message;
    first.step(60);
    second.step(60);
    EXPECT_EQ(hex_of(second.simulation->state_hash()), hex_of(first.simulation->state_hash()));
}

INSTANTIATE_TEST_SUITE_P(Shipped,
                         SavedScene,
                         testing::ValuesIn(every_scene()),
                         [](const testing::TestParamInfo<std::string>& scene) {
                             std::string name = scene.param;
                             std::ranges::replace(name, '/', '_');
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

}  // namespace
}  // namespace plumbline
