// Room for what is about to appear.
#include "game/rules/hands/placement.h"

#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

TEST(Placement, DoesNotDropIntoOrBehindAWall) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("wall", {10, 4, 0.2_r}, {0, 2, -0.6_r}));
    Playground play(scene);
    play.step(press({Action::Select1}));
    play.step(press({Action::Drop}));
    for (auto [entity, dropped, place] :
         play.simulation->registry.view<const scene::Dropped, const scene::Transform>()) {
        static_cast<void>(entity);
        static_cast<void>(dropped);
        EXPECT_GT(place.world_from_body.position.z, -0.5);
    }
    if (play.thing_count() == 0) {
        EXPECT_EQ(play.messages(), std::vector<std::string>{"no room for a crate there"});
    }
}

/// Where a box of that size would appear for an eye 2 m up that looks down -Z.
std::optional<Vec3> placed(const Playground& play, const Vec3& size_m) {
    const auto box = play.simulation->physics.create_shape(physics::BoxShape{size_m});
    EXPECT_TRUE(box.ok());
    return free_place(play.simulation->physics,
                      {.eye_m = {50, 2, 0}, .forward = {0, 0, -1}},
                      {.box = *box, .size_m = size_m},
                      1.6_r);
}

TEST(Placement, InTheOpenIsAsFarAsTheArmAndHalfTheThing) {
    Playground play;
    const auto small = placed(play, {0.2_r, 0.2_r, 0.2_r});
    ASSERT_TRUE(small.has_value());
    EXPECT_NEAR(glm::distance(*small, Vec3(50, 2, -1.7)), 0, 1e-5);
    const auto deep = placed(play, {0.2_r, 0.2_r, 2});
    EXPECT_NEAR(glm::distance(deep.value(), Vec3(50, 2, -2.6)), 0, 1e-5);
}

TEST(Placement, BeforeAWallIsACentimetreOffIt) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("wall", {10, 4, 1}, {50, 2, -1.5_r}));  // its face at z = -1
    Playground play(scene);
    const auto place = placed(play, {0.4_r, 0.4_r, 0.4_r});
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(glm::distance(*place, Vec3(50, 2, -1 + 0.2 + 0.01)), 0, 1e-4);
}

TEST(Placement, WhatStandsThereMovesItTowardsTheEyeOrUp) {
    scene::SceneDescription scene = meadow();
    // A post beside the line of sight, where the thing would be.
    scene.entities.push_back(block("post", {0.2_r, 4, 0.2_r}, {50.25_r, 2, -1.8_r}));
    Playground play(scene);
    const Vec3 size{0.4_r, 0.4_r, 0.4_r};
    const auto place = placed(play, size);
    ASSERT_TRUE(place.has_value());
    // 1.8 m off it would touch; 0.15 m nearer too, two such steps nearer it does not.
    EXPECT_NEAR(glm::distance(*place, Vec3(50, 2, -1.8 + 0.3)), 0, 1e-4);
}

TEST(Placement, WithoutRoomThereIsNone) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("wall", {10, 9, 1}, {50, 2, -0.6_r}));  // 0.1 m before the eye
    scene.entities.push_back(block("back", {10, 9, 1}, {50, 2, 0.7_r}));   // 0.2 m behind it
    Playground play(scene);
    EXPECT_FALSE(placed(play, {0.4_r, 0.4_r, 0.4_r}).has_value());
    EXPECT_TRUE(placed(play, {0.1_r, 0.1_r, 0.1_r}).has_value()) << "what is small enough fits";
}

}  // namespace
}  // namespace plumbline::game
