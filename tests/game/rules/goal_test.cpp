// SOURCES B36: a goal is won and lost, the same way each time, and costs nothing where there is none.
#include "tests/game/rules/playground.h"

#include <fmt/format.h>

namespace plumbline::game {
namespace {

using scene::GoalEnd;

/// A shelf 1 m high at z = -4 with three light cans on it, to be knocked off with balls.
scene::SceneDescription shelf() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("shelf", {3, 1, 0.4_r}, {0, 0.5_r, -4}));
    for (int i = 0; i < 3; ++i) {
        scene.entities.push_back(block(fmt::format("can.{}", i),
                                       {0.3_r, 0.6_r, 0.3_r},
                                       {static_cast<Real>(i - 1), 1.3_r, -4},
                                       physics::BodyKind::Dynamic,
                                       0.3_r));
    }
    scene.goal = scene::GoalDescription{.text = "Knock them off",
                                        .things = {"can.*"},
                                        .below_m = 0.9_r,
                                        .within_s = 20,
                                        .throws = 4,
                                        .with = "ball",
                                        .hands_off = true};
    return scene;
}

scene::GoalState state(const Playground& play) {
    return play.game->goal()->state(*play.simulation);
}

/// Turns to a place and throws there as hard as it goes.
void throw_at(Playground& play, const Vec3& target_m) {
    play.step(play.turn_to(target_m));
    play.step(press({Action::Throw}));
    play.run(1.1, hold({Action::Throw}));
    play.step();
}

TEST(Goal, OfTriggersIsWonWhenTheyCountedEnough) {
    scene::SceneDescription scene = shelf();
    scene.goal = scene::GoalDescription{.text = "Ring it", .triggers = true, .count = 2};
    Playground play(scene);
    play.run(1);
    EXPECT_EQ(state(play).counted, 0);
    play.simulation->counted = 1;
    play.run(1);
    EXPECT_EQ(state(play).counted, 1);
    EXPECT_EQ(state(play).end, GoalEnd::Open);
    play.simulation->counted = 2;
    play.run(1);
    EXPECT_EQ(state(play).end, GoalEnd::Won);
}

TEST(Goal, WaitsForTheFirstThrow) {
    Playground play(shelf());
    play.run(30);
    EXPECT_EQ(state(play).end, GoalEnd::Open) << "the clock stands until something is done";
    EXPECT_EQ(state(play).left_s, 20.0);
    EXPECT_EQ(state(play).throws_left, 4);
    EXPECT_EQ(state(play).wanted, 3);
    EXPECT_EQ(state(play).text, "Knock them off");
}

TEST(Goal, IsWonByKnockingAllOff) {
    Playground play(shelf());
    for (int i = 0; i < 3; ++i) {
        throw_at(play, {static_cast<Real>(i - 1), 1.35_r, -4});
        play.run(4.5);  // they tumble far, higher than the shelf at times
        EXPECT_EQ(state(play).counted, i + 1);
    }
    play.run(1);
    EXPECT_EQ(state(play).end, GoalEnd::Won);
    EXPECT_EQ(state(play).throws_left, 1);
    const double won_s = state(play).passed_s;
    EXPECT_GT(won_s, 1);
    EXPECT_LT(won_s, 20);
    const auto said = play.messages();
    EXPECT_NE(std::ranges::find(said, fmt::format("won in {:.1f} s", won_s)), said.end());
    play.run(30);
    EXPECT_EQ(state(play).end, GoalEnd::Won) << "and stays so";
    EXPECT_EQ(state(play).passed_s, won_s);
}

TEST(Goal, IsLostWhenTheTimeIsUp) {
    Playground play(shelf());
    throw_at(play, {-1, 1.35_r, -4});
    play.run(18.5);
    EXPECT_EQ(state(play).end, GoalEnd::Open);
    play.run(2);
    EXPECT_EQ(state(play).end, GoalEnd::Lost);
    EXPECT_NEAR(state(play).passed_s, 20, 0.02);
    EXPECT_EQ(play.messages().back(), "lost: 1 of 3");
}

TEST(Goal, IsLostWhenNothingIsLeftToThrow) {
    Playground play(shelf());
    for (int i = 0; i < 4; ++i) throw_at(play, {6, 1, -2});
    play.step(press({Action::Drop}));
    EXPECT_EQ(play.messages().back(), "no throws left");
    EXPECT_EQ(play.thing_count(), 4U);
    play.run(5.5);
    EXPECT_EQ(state(play).end, GoalEnd::Open) << "the last one may still do its work";
    play.run(1);
    EXPECT_EQ(state(play).end, GoalEnd::Lost);
    EXPECT_EQ(play.messages().back(), "lost: 0 of 3");
}

TEST(Goal, HandsLeaveItsThingsAloneAndOnlyItsThingIsThrown) {
    scene::SceneDescription scene = shelf();
    scene.entities[2].world_from_body.position = {0, 1.65_r, -1.5_r};
    scene.entities[2].body->kind = physics::BodyKind::Dynamic;
    scene.gravity_mps2 = {0, 0, 0};
    Playground play(scene);
    play.step(press({Action::Grab}));
    EXPECT_FALSE(play.game->holds());
    EXPECT_EQ(play.messages().back(), "this object is a target: throw something at it");
    play.step(press({Action::Remove}));
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("can.1")));
    play.step(press({Action::Select3}));
    EXPECT_EQ(play.game->things().chosen_name(), "ball");
}

TEST(Goal, CountsWhatLiesInsideOnceItStays) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("box", {0.5_r, 0.5_r, 0.5_r}, {0, 3, -5}, physics::BodyKind::Dynamic, 5));
    scene.goal = scene::GoalDescription{.text = "Into the ring",
                                        .things = {"box"},
                                        .inside = scene::Region{{-1, 1, -6}, {1, 2, -4}}};
    Playground fly(scene);
    fly.run(3);
    EXPECT_EQ(state(fly).end, GoalEnd::Open) << "it only fell through";
    EXPECT_EQ(state(fly).counted, 0);
    scene.goal->inside = scene::Region{{-1, 0, -6}, {1, 1, -4}};
    Playground stay(scene);
    stay.run(3);
    EXPECT_EQ(state(stay).end, GoalEnd::Won);
    EXPECT_FALSE(state(stay).left_s || state(stay).throws_left);
}

/// A box on a shelf in front of the person, which counts there.
scene::SceneDescription box_in_reach(double holds_s) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("shelf", {0.6_r, 1.4_r, 0.6_r}, {0, 0.7_r, -1.6_r}));
    scene.entities.push_back(
        block("box", {0.3_r, 0.3_r, 0.3_r}, {0, 1.55_r, -1.6_r}, physics::BodyKind::Dynamic, 5));
    scene.goal = scene::GoalDescription{.text = "Up there",
                                        .things = {"box"},
                                        .inside = scene::Region{{-3, 1, -6}, {3, 4, 4}},
                                        .holds_s = holds_s,
                                        .within_s = 4};
    return scene;
}

TEST(Goal, MustHoldForItsTimeAlsoPastTheEnd) {
    Playground play(box_in_reach(6));
    play.run(2);
    EXPECT_EQ(state(play).counted, 1);
    ASSERT_TRUE(state(play).holds_for_s);
    EXPECT_NEAR(*state(play).holds_for_s, 3.5, 0.1);  // the person took half a second to land
    play.run(3.5);                                    // the time is up
    EXPECT_EQ(state(play).end, GoalEnd::Open);
    EXPECT_FALSE(play.game->won_in_s());
    play.run(1);
    EXPECT_EQ(state(play).end, GoalEnd::Won);
    ASSERT_TRUE(play.game->won_in_s());
    EXPECT_NEAR(*play.game->won_in_s(), 0, 0.05) << "it counted from the start";
}

TEST(Goal, WhatIsInTheHandOrFrozenThereDoesNotCount) {
    Playground held(box_in_reach(3));
    held.step(held.turn_to({0, 1.55_r, -1.6_r}));
    held.step(press({Action::Grab}));
    held.run(2, hold({Action::Grab}));
    ASSERT_TRUE(held.game->holds());
    EXPECT_EQ(state(held).counted, 0);
    held.run(3, hold({Action::Grab}));
    EXPECT_EQ(state(held).end, GoalEnd::Lost);

    Playground frozen(box_in_reach(3));
    const auto& body =
        frozen.simulation->registry.get<scene::BodyRef>(frozen.simulation->find("box"));
    frozen.simulation->physics.set_frozen(body.body, true);
    frozen.run(5);
    EXPECT_EQ(state(frozen).counted, 0);
}

TEST(Goal, GoesTheSameWayEachTime) {
    std::vector<std::uint64_t> hashes;
    std::vector<double> times;
    for (int run = 0; run < 2; ++run) {
        Playground play(shelf());
        for (int i = 0; i < 3; ++i) throw_at(play, {static_cast<Real>(i - 1), 1.35_r, -4});
        play.run(3);
        hashes.push_back(play.simulation->state_hash());
        times.push_back(state(play).passed_s);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(times[0], times[1]);
}

TEST(Goal, IsNotThereWithoutOne) {
    Playground play;
    EXPECT_EQ(play.game->goal(), nullptr);
    EXPECT_FALSE(play.game->hud(*play.simulation).goal);
}

}  // namespace
}  // namespace plumbline::game
