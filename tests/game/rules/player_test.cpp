// The person who walks: pace, strides and landings.
#include "engine/effects/advance.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

TEST(Player, WalksAtWalkingAndAtRunningPace) {
    Playground walk;
    walk.run(3, hold({Action::Forward}));
    EXPECT_NEAR(walk.feet().z, -1.8 * 3, 0.05);
    EXPECT_NEAR(walk.feet().x, 0, 1e-3);

    Playground run;
    run.run(3, hold({Action::Forward, Action::Sprint}));
    EXPECT_NEAR(run.feet().z, -4.5 * 3, 0.3);
}

TEST(Player, StepsAreHeardAStrideApart) {
    Playground play;
    play.run(5, hold({Action::Forward}));
    // 9 m in strides of 0.75 m.
    EXPECT_NEAR(static_cast<double>(play.footsteps.size()), 12, 1);
    for (const auto& step : play.footsteps) EXPECT_NEAR(step.position_m.y, 0, 1e-3);
}

TEST(Player, ABlockedStartIsMovedAndTold) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("house", {4, 2, 4}, {0, 1, 0}));
    assets::AssetLibrary library;
    scene::SurfaceTable surfaces;
    surfaces.surfaces.push_back({.name = "default"});
    auto built = scene::build_simulation(scene, {}, library, surfaces);
    ASSERT_TRUE(built.ok());
    PlaygroundGame game(**built, "no such folder");
    EXPECT_NEAR(game.player()->state().feet_position_m.y, 2, 0.2);
    EXPECT_EQ(game.hud(**built).messages,
              std::vector<std::string>{"spawn point blocked: moved to the nearest free spot"});
}

TEST(Player, AStartOnPavingIsNotBlocked) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("paving", {4, 0.1_r, 4}, {0, 0.05_r, 0}));
    scene.player = scene::PlayerDescription{.feet_position_m = {0, 0, 0}};
    Playground play(scene);
    EXPECT_NEAR(play.game->player()->state().feet_position_m.y, 0.1, 2e-3);
    EXPECT_TRUE(play.messages().empty());
}

TEST(Player, PaceChangesByAQuarterBetweenAQuarterAndThreeTimes) {
    Playground play;
    Player player(*play.simulation, {20, 0, 0});
    const auto usual = static_cast<double>(player.def().walk_speed_mps);
    EXPECT_NEAR(player.change_pace(1), usual * 1.25, 1e-5);
    EXPECT_NEAR(player.change_pace(-1), usual, 1e-5);
    EXPECT_NEAR(player.change_pace(99), usual * 3, 1e-5);
    EXPECT_NEAR(player.change_pace(-99), usual / 4, 1e-5);
    EXPECT_NEAR(player.change_pace(2), usual / 4 * 1.25 * 1.25, 1e-5);
}

TEST(Player, ALandingIsHeardOnceAsHardAsItIs) {
    Playground play;
    play.footsteps.clear();
    play.step(press({Action::Jump}));
    play.run(1.5);
    ASSERT_EQ(play.footsteps.size(), 1U);
    // Up at v and down at v again.
    const Real height_m = play.game->player()->def().jump_height_m;
    EXPECT_NEAR(play.footsteps[0].speed_mps, std::sqrt(2 * 9.81_r * height_m), 0.25);
    EXPECT_EQ(play.footsteps[0].surface, 0);
}

TEST(Player, WhoStandsIsNotHeardAndRunsInLongerStrides) {
    Playground still;
    still.footsteps.clear();
    still.run(2);
    EXPECT_TRUE(still.footsteps.empty());
    Playground run;
    run.footsteps.clear();
    const Real from = run.feet().z;
    run.run(4, hold({Action::Forward, Action::Sprint}));
    EXPECT_NEAR(static_cast<double>(run.footsteps.size()),
                static_cast<double>(from - run.feet().z) / 1.1,
                2);
}

/// A mattress of soft foam that starts in the air sinks below nobody: it bears the person, who walks on it and jumps from it.
TEST(Player, StandsOnASoftBodyAndJumpsFromIt) {
    scene::SceneDescription scene = meadow();
    scene::SoftDescription mattress;
    mattress.name = "mattress";
    mattress.size_m = {3, 0.5, 3};
    mattress.cell_m = 0.25;
    mattress.young_Pa = 1e5;
    mattress.density_kgpm3 = 100;
    mattress.damping_s = 0.01;
    mattress.pose.position = {0, 0.26_r, 0};
    scene.forces.softs = {mattress};
    scene.player->feet_position_m = {0, 1.8_r, 0};
    Playground play(scene);
    effects::EffectRuntime effects(*play.simulation, {});
    const auto go_on = [&](double seconds, const Actions& actions = {}) {
        for (int i = 0; i < static_cast<int>(seconds * 60 + 0.5); ++i)
            effects::advance(*play.simulation, effects, *play.game, actions);
    };
    go_on(6);  // it has bounced, as far as the damping says
    const Real standing_m = play.feet().y;
    EXPECT_GT(standing_m, 0.3_r);
    EXPECT_LT(standing_m, 0.5_r);
    go_on(1);
    EXPECT_NEAR(play.feet().y, standing_m, 0.01);
    go_on(0.5, hold({Action::Forward}));
    EXPECT_LT(play.feet().z, -0.3_r);
    EXPECT_NEAR(play.feet().y, standing_m, 0.1);
    go_on(0.5);
    effects::advance(*play.simulation, effects, *play.game, press({Action::Jump}));
    go_on(0.3);
    EXPECT_GT(play.feet().y, standing_m + 0.6_r);
}

}  // namespace
}  // namespace plumbline::game
