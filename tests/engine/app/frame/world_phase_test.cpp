// What is asked for between the steps, without a window.
#include "engine/app/frame/world_phase.h"

#include "tests/engine/app/session_fixture.h"

namespace plumbline::app {
namespace {

class WorldPhaseTest : public SessionTest {
protected:
    /// Playing the scene of the folder, from its start.
    struct Playing {
        explicit Playing(std::unique_ptr<Session> opened, PlayDef with)
            : session(std::move(opened)),
              def(std::move(with)),
              state({.session = *session, .bindings = bindings, .config = config, .def = def}),
              world(state, std::move(*Stepper::create(*session, def.steps))) {}

        void run(int steps) {
            world.run_steps({.steps = steps, .blend = 1, .budget_s = 1e9}, latch);
        }
        std::vector<std::string> said() {
            std::vector<std::string> lines;
            for (const ui::HudLine& line : state.messages.lines(0, true))
                lines.push_back(line.text);
            return lines;
        }

        std::unique_ptr<Session> session;
        PlayDef def;
        LiveBindings bindings{BindingsDef{.safe = true}};
        LiveConfig config{{}, {}};
        FrameState state;
        WorldPhase world;
        input::ActionLatch latch{input::Bindings{}};
    };
    std::unique_ptr<Playing> play(const StepperDef& steps = {}) {
        PlayDef def;
        def.user_data_folder = folder_.path() / "data";
        def.steps = steps;
        return std::make_unique<Playing>(open(), std::move(def));
    }

    static constexpr study::Setting kOther{.step_hz = 120, .substeps = 8, .substeps_max = 8};
};

using Words = std::vector<std::string>;

TEST_F(WorldPhaseTest, TheClockFollowsTheLengthOfASteps) {
    const auto playing = play();
    playing->world.apply(SetAccuracy{kOther});
    EXPECT_EQ(playing->said(), Words{study::setting_text(kOther)});
    playing->run(1);
    EXPECT_EQ(playing->state.clock.step_s(), 1.0 / 120);
    EXPECT_EQ(playing->session->simulation->steps(), 1U);
    playing->world.apply(StartAgain{});
    EXPECT_EQ(playing->session->simulation->steps(), 0U);
    EXPECT_EQ(playing->session->accuracy(), kOther);
}

// The recording begins anew with the file, at the file's accuracy.
TEST_F(WorldPhaseTest, AReloadKeepsTheChosenAccuracyAndItsRecordingReplays) {
    const auto playing = play();
    playing->world.apply(SetAccuracy{kOther});
    playing->run(20);
    folder_.write("scene.toml", kTwoCubes + "# another\n");
    EXPECT_TRUE(playing->world.reload_scene());
    EXPECT_EQ(playing->session->accuracy(), kOther);
    playing->run(50);
    const auto tape = folder_.path() / "a.tape";
    ASSERT_TRUE(playing->world.stepper.save_recording(tape).ok());
    const std::uint64_t hash = playing->session->simulation->state_hash();

    const auto replay = play({.replay = tape});
    replay->world.apply(SetHour{3});
    EXPECT_FALSE(replay->world.reload_scene());
    replay->world.load_game(1);
    EXPECT_EQ(replay->said(), Words{"not available during a replay"});
    replay->run(1000);
    EXPECT_TRUE(replay->world.stepper.ended());
    EXPECT_EQ(replay->world.stepper.divergence(), "");
    EXPECT_EQ(replay->session->simulation->state_hash(), hash);
}

TEST_F(WorldPhaseTest, AFaultInASavedSceneStandsUntilItIsMended) {
    const auto playing = play();
    folder_.write("scene.toml", "[[entity]\n");
    EXPECT_FALSE(playing->world.reload_scene());
    EXPECT_NE(playing->world.scene_fault.find("scene.toml:1"), std::string::npos);
    folder_.write("scene.toml", kTwoCubes);
    EXPECT_TRUE(playing->world.reload_scene());
    EXPECT_EQ(playing->world.scene_fault, "");
}

TEST_F(WorldPhaseTest, GamesAreSavedToTheSlotUsedLastAndLoadedFromIt) {
    const auto playing = play();
    playing->world.load_game(3);
    EXPECT_EQ(playing->said(), Words{"slot 3 is empty"});
    playing->run(30);
    const std::uint64_t hash = playing->session->simulation->state_hash();
    playing->world.save_game(0);
    EXPECT_TRUE(playing->said().back().starts_with("saved to slot 3: "));
    EXPECT_FALSE(playing->world.saves.slots()[2].saved.empty());
    EXPECT_TRUE(playing->world.saves.slots()[2].is_latest);
    playing->run(30);
    EXPECT_NE(playing->session->simulation->state_hash(), hash);
    playing->world.load_game(0);
    EXPECT_EQ(playing->said().back(), "slot 3 loaded (0.5 s into the scene)");
    EXPECT_EQ(playing->session->simulation->state_hash(), hash);
    EXPECT_EQ(playing->world.stepper.steps(), 30U);
}

// FAULTS N28: at a hard case everything has fallen before one can ask for a ghost.
TEST_F(WorldPhaseTest, AGhostFromTheStartRestartsTheScene) {
    const auto playing = play();
    playing->run(30);
    playing->world.start_ghost({.setting = kOther, .from = GhostFrom::Here});
    EXPECT_EQ(playing->session->simulation->steps(), 30U);
    playing->world.start_ghost({.setting = kOther, .from = GhostFrom::Start});
    EXPECT_EQ(playing->session->simulation->steps(), 0U);
    const Words said = playing->said();
    EXPECT_NE(std::ranges::find(said, "scene reset"), said.end());
}

}  // namespace
}  // namespace plumbline::app
