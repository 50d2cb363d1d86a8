// Scenes where a saved game left them.
#include "game/commands/export/restored_scene.h"

#include "engine/effects/saved_game.h"
#include "game/commands/simulate_command.h"
#include "game/commands/study/saved_start.h"
#include "game/rules/rules.h"
#include "tests/game/commands/command_run.h"

#include <fstream>

namespace plumbline::game {
namespace {

namespace fs = std::filesystem;

using test::ScopedVariable;

class SavedStart : public test::CommandTest {
protected:
    static fs::path scene() { return fs::path(PL_SOURCE_DIR) / "assets/scenes/falling_cube.toml"; }
    fs::path simulated(double seconds) {
        const fs::path file = folder_ / "simulated.save";
        const test::CommandRun run = test::ran([&] {
            return run_simulate({.scene = scene().string(), .seconds = seconds, .save_file = file});
        });
        EXPECT_EQ(run.code, ExitCode::Good) << run.said;
        return file;
    }
    fs::path played() {
        const fs::path file = folder_ / "played.save";
        Result<scene::OpenedScene> opened = study::open_for_study(scene());
        EXPECT_TRUE(opened);
        assets::AssetLibrary library(fs::path(PL_SOURCE_DIR) / "assets");
        auto simulation = opened->build(library);
        EXPECT_TRUE(simulation);
        PlaygroundGame game(**simulation, fs::path(PL_SOURCE_DIR) / "assets");
        effects::EffectRuntime effects(**simulation, {});
        EXPECT_TRUE(effects::save_game(
            file,
            {.opened = *opened, .simulation = **simulation, .effects = effects, .game = game},
            0));
        return file;
    }

    ScopedVariable real_data_{"PLUMBLINE_DATA", PL_SOURCE_DIR};
};

TEST_F(SavedStart, IsTheStateOfAGameOfEitherKind) {
    const Result<study::SceneStart> simulated_start = saved_start(simulated(0.5), scene());
    ASSERT_TRUE(simulated_start) << simulated_start.error().message;
    EXPECT_NEAR(simulated_start->time_s, 0.5, 1e-9);
    EXPECT_FALSE(simulated_start->state.empty());
    const Result<study::SceneStart> played_start = saved_start(played(), scene());
    ASSERT_TRUE(played_start) << played_start.error().message;
    EXPECT_EQ(played_start->time_s, 0);
    EXPECT_NE(played_start->state, simulated_start->state);
}

TEST_F(SavedStart, RefusesAnotherScenesGameAndWhatIsNone) {
    const Result<study::SceneStart> other =
        saved_start(simulated(0.1), scene().parent_path() / "cans.toml");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().exit_code, ExitCode::Refused);
    EXPECT_NE(other.error().message.find("not of cans.toml"), std::string::npos)
        << other.error().message;
    EXPECT_FALSE(saved_start(scene(), scene())) << "no saved game";
}

}  // namespace
}  // namespace plumbline::game
