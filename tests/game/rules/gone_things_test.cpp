// What the rules keep over a step and what may leave the world meanwhile: in the hand, underfoot, lifted,
// dropped, lit, wanted by a goal. Every key goes on without it.
#include "engine/scene/simulation/simulation_archive.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

/// A box of 5 kg level with the eye, 2 m ahead, on a table.
scene::SceneDescription with_a_box() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("table", {1, 1.4_r, 1}, {0, 0.7_r, -2}));
    scene.entities.push_back(
        block("box", {0.4_r, 0.4_r, 0.4_r}, {0, 1.6_r, -2}, physics::BodyKind::Dynamic, 5));
    return scene;
}

/// As kill_below_m and triggers take things away: at the end of a step.
void take_away(Playground& play, const std::string& name) {
    play.simulation->registry.mark_for_destruction(play.simulation->find(name));
    play.simulation->destroy_marked();
}

Actions with_presses(Actions actions, std::initializer_list<Action> pressed) {
    for (const Action action : pressed) actions.pressed[index_of(action)] = 1;
    return actions;
}

TEST(GoneThings, EveryKeyOfTheHandIsPressedAsTheThingInItIsGone) {
    for (const Action key : {Action::Freeze,
                             Action::Remove,
                             Action::Throw,
                             Action::Push,
                             Action::RotateHeld,
                             Action::UndoDrop,
                             Action::MoveMode}) {
        Playground play(with_a_box());
        play.step(press({Action::Grab}));
        ASSERT_TRUE(play.game->holds());
        take_away(play, "box");
        Actions keys = with_presses(hold({Action::Grab, key}), {key});
        keys.look_yaw_rad = 0.01F;
        play.step(keys);
        EXPECT_FALSE(play.game->holds()) << action_name(key);
        play.run(0.2, hold({Action::Grab}));
        EXPECT_FALSE(play.game->holds()) << "nothing is taken without a press";
    }
}

TEST(GoneThings, WhatUndoTakesOutOfTheHandIsNotFrozenAfterwards) {
    Playground play;
    play.step(press({Action::Select2}));
    play.step(press({Action::Drop}));
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->holds());
    play.step(with_presses(hold({Action::Grab}), {Action::UndoDrop}));
    EXPECT_EQ(play.thing_count(), 0U);
    EXPECT_FALSE(play.game->holds());
    play.messages();
    play.step(with_presses(hold({Action::Grab}), {Action::Freeze, Action::Throw}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"nothing to freeze"});
}

TEST(GoneThings, WhatIsTakenOutOfTheHandByTheRemoveKeyLeavesTheHandEmpty) {
    Playground play(with_a_box());
    play.step(press({Action::Grab}));
    play.step(with_presses(hold({Action::Grab}), {Action::Remove, Action::Throw}));
    EXPECT_FALSE(play.simulation->registry.alive(play.simulation->find("box")));
    EXPECT_FALSE(play.game->holds());
    EXPECT_EQ(play.thing_count(), 1U) << "the empty hand throws the chosen thing";
}

// It was refused when it was read: "what is in the hand is not there".
TEST(GoneThings, AGameSavedAsTheThingInTheHandWentIsReadAgain) {
    Playground there(with_a_box());
    there.step(press({Action::Grab}));
    there.step(with_presses(hold({Action::Grab}), {Action::Drop}));
    take_away(there, "box");
    Archive written;
    there.game->serialize(written, *there.simulation);
    serialize_state(*there.simulation, written);
    ASSERT_FALSE(written.failed()) << written.fault();
    const std::string bytes = written.take();
    Playground here(with_a_box());
    Archive read(bytes);
    here.game->serialize(read, *here.simulation);
    serialize_state(*here.simulation, read);
    ASSERT_FALSE(read.failed()) << read.fault();
    EXPECT_FALSE(here.game->holds());
    here.run(0.2, hold({Action::Grab}));
    there.run(0.2, hold({Action::Grab}));
    EXPECT_EQ(here.simulation->state_hash(), there.simulation->state_hash());
}

TEST(GoneThings, UndoGoesOnWithTheThingBeforeTheOneThatIsGone) {
    Playground play;
    play.step(press({Action::Select2}));
    for (int i = 0; i < 3; ++i) play.step(press({Action::Drop}));
    take_away(play, "ball#3");
    play.step(press({Action::UndoDrop}));
    EXPECT_FALSE(play.simulation->registry.alive(play.simulation->find("ball#2")));
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("ball#1")));
}

TEST(GoneThings, WhoStoodOnItFallsAndWhoHeldItsGroundLetsGo) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("box", {1.2_r, 1, 1.2_r}, {0, 0.5_r, 0}, physics::BodyKind::Dynamic, 20));
    scene.player->feet_position_m = {0, 1.01_r, 0};
    Playground play(scene);
    play.step(look(0.0F, -1.4F));
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->holds());
    ASSERT_EQ(play.game->player()->state().ground_body, play.body("box"));
    take_away(play, "box");
    play.step(hold({Action::Grab, Action::Forward}));
    EXPECT_FALSE(play.game->holds());
    play.run(1);
    EXPECT_NEAR(play.feet().y, 0, 0.01);
}

TEST(GoneThings, TheLiftKeyLiftsNothingInItsPlace) {
    scene::SceneDescription scene = with_a_box();
    scene.entities.back().body->mass_kg = 1;
    Playground play(scene);
    play.step(press({Action::Lift}));
    take_away(play, "box");
    play.step(hold({Action::Lift}));
    // Its place in the world's list goes to the next body that is made.
    play.step(with_presses(hold({Action::Lift}), {Action::Select2, Action::Drop}));
    const Real before_mps = play.state("ball#1").velocity_mps.y;
    play.run(0.1, hold({Action::Lift}));
    EXPECT_LT(play.state("ball#1").velocity_mps.y, before_mps) << "it falls; 20 N would lift it";
}

TEST(GoneThings, ASpotlightThatIsGoneIsNotAimed) {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription spot = block("spot", {0.2_r, 0.2_r, 0.2_r}, {1, 3, -1});
    spot.light.emplace();
    spot.light->is_spot = true;
    scene.entities.push_back(spot);
    Playground play(scene);
    play.step(press({Action::AimSpot}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"spotlight aimed"});
    take_away(play, "spot");
    play.step(with_presses(hold({Action::AimSpot}), {Action::AimSpot}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"this scene has no spotlight"});
}

TEST(GoneThings, AGoalCountsThemUnlessItWantsThemInside) {
    for (const bool inside : {false, true}) {
        scene::SceneDescription scene = with_a_box();
        // The table, in the one and not in the other, keeps the goal from being reached.
        const scene::Region box{.min_m = {-1, 1, -3}, .max_m = {1, 3, -1}};
        const scene::Region both{.min_m = {-1, 0, -3}, .max_m = {1, 3, -1}};
        scene.goal.emplace();
        scene.goal->things = {"box", "table"};
        (inside ? scene.goal->inside : scene.goal->outside) = inside ? box : both;
        Playground play(scene);
        EXPECT_EQ(play.game->goal()->state(*play.simulation).counted, inside ? 1 : 0);
        play.step(press({Action::Grab}));
        take_away(play, "box");
        play.step(with_presses(hold({Action::Grab}), {Action::Freeze}));
        EXPECT_EQ(play.game->goal()->state(*play.simulation).counted, inside ? 0 : 1);
    }
}

// A saved game's checksum is no secret.
TEST(GoneThings, ASavedGameThatChoosesNoThingIsRefused) {
    std::size_t chosen = kThingCount;
    std::uint64_t serial = 0;
    bool told = false;
    std::vector<ecs::Entity> dropped;
    Archive written;
    written(chosen, serial, told, dropped);
    const std::string bytes = written.take();
    Playground play;
    Things things(*play.simulation, "no such folder");
    Archive read(bytes);
    things.serialize(read);
    EXPECT_TRUE(read.failed());
}

}  // namespace
}  // namespace plumbline::game
