// The use key: doors, lamps and seats; and the outlines of what hands would take, use and put.
#include "engine/scene/extract.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "game/rules/use.h"
#include "tests/game/rules/playground.h"

#include <algorithm>

namespace plumbline::game {
namespace {

/// A leaf of 0.9 m x 2 m whose hinge is 0.45 m left of the line of sight, 2 m ahead.
scene::SceneDescription with_a_door(Real low_deg, Real high_deg) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("post", {0.1_r, 2, 0.1_r}, {-0.55_r, 1, -2}));
    scene.entities.push_back(
        block("door", {0.9_r, 2, 0.05_r}, {0, 1.01_r, -2}, physics::BodyKind::Dynamic, 25));
    scene.entities.back().body->can_sleep = false;
    scene.joints.push_back(
        {.name = "hinge",
         .kind = scene::JointKind::Hinge,
         .a = "door",
         .b = "post",
         .anchor_a_m = {-0.45_r, 1, -2},
         .anchor_b_m = {-0.45_r, 1, -2},
         .axis = {0, 1, 0},
         .limits = std::array{radians_from_degrees(low_deg), radians_from_degrees(high_deg)},
         .motor = physics::JointMotor{.target = 0, .max = 2}});
    return scene;
}

Real angle_deg(const Playground& play) {
    const physics::JointId hinge = play.simulation->joints().front().joint;
    return degrees_from_radians(play.simulation->physics.joint(hinge).state.position);
}

std::string words(Playground& play) {
    return play.game->hud(*play.simulation).use;
}

TEST(RulesUse, ADoorThatOpensBothWaysOpensAwayFromThePersonAndShutsAgain) {
    for (const Real side : {1.0_r, -1.0_r}) {
        scene::SceneDescription scene = with_a_door(-95, 95);
        // From the other side the person looks back at it.
        if (side < 0) {
            scene.player->feet_position_m = {0, 0, -4};
            scene.player->yaw_rad = kPi;
        }
        Playground play(scene);
        EXPECT_EQ(words(play), "open");
        play.step(press({Action::Use}));
        play.run(3);
        EXPECT_NEAR(angle_deg(play), side * 91, 4) << "about +Y its free edge goes to -Z";
        EXPECT_NEAR(play.state("door").angular_velocity_radps.y, 0, 0.05);
    }
}

TEST(RulesUse, TheSameKeyShutsItAndAHandThatHoldsItGoesFirst) {
    Playground play(with_a_door(-10, 110));
    play.step(press({Action::Use}));
    play.run(0.5);
    EXPECT_EQ(words(play), "close") << "half open";
    play.step(press({Action::Use}));
    play.run(2.5);
    EXPECT_NEAR(angle_deg(play), -10, 3);
    play.step(press({Action::Use}));
    play.run(0.2);
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->holds());
    const Real held_deg = angle_deg(play);
    play.run(1, hold({Action::Grab}));
    EXPECT_NEAR(angle_deg(play), held_deg, 25) << "it does not go on to 106";
}

TEST(RulesUse, ADoorThatIsBlockedIsLeftAloneAfterAWhile) {
    scene::SceneDescription scene = with_a_door(0, 95);
    scene.entities.push_back(block("wall", {2, 2, 0.2_r}, {0.3_r, 1, -2.4_r}));
    Playground play(scene);
    play.step(press({Action::Use}));
    play.run(5);
    const Real blocked_deg = angle_deg(play);
    EXPECT_LT(blocked_deg, 40);
    destroy(*play.simulation, play.simulation->find("wall"));
    play.run(2);
    EXPECT_NEAR(angle_deg(play), blocked_deg, 3) << "nobody pushes any more";
}

TEST(RulesUse, ADoorOnItsWayMayGo) {
    Playground play(with_a_door(0, 95));
    play.step(press({Action::Use}));
    play.simulation->registry.mark_for_destruction(play.simulation->find("door"));
    play.run(0.5);
    EXPECT_TRUE(play.simulation->joints().empty() ||
                !play.simulation->physics.contains(play.simulation->joints().front().joint));
}

TEST(RulesUse, ADoorOnItsWayIsSavedWithTheGame) {
    const auto load = [](const std::string& bytes, Playground& world) {
        Archive archive(bytes);
        world.game->serialize(archive, *world.simulation);
        serialize_state(*world.simulation, archive);
        EXPECT_FALSE(archive.failed()) << archive.fault();
    };
    Playground there(with_a_door(0, 95));
    there.step(press({Action::Use}));
    there.run(0.4);
    Archive archive;
    there.game->serialize(archive, *there.simulation);
    serialize_state(*there.simulation, archive);
    Playground here(with_a_door(0, 95));
    load(archive.take(), here);
    there.run(2);
    here.run(2);
    EXPECT_GT(angle_deg(here), 85);
    EXPECT_EQ(here.simulation->state_hash(), there.simulation->state_hash());
}

TEST(RulesUse, WhatTurnsOnAndOnOrHasNoHingeIsNoDoor) {
    scene::SceneDescription wheel = with_a_door(0, 95);
    wheel.joints.front().limits.reset();
    for (const scene::SceneDescription& scene : {wheel, meadow()}) {
        Playground play(scene);
        EXPECT_EQ(words(play), "");
        play.step(press({Action::Use}));
        EXPECT_EQ(play.messages(), std::vector<std::string>{"nothing to use"});
    }
}

scene::EntityDescription lamp(const std::string& name, const Vec3& position_m, scene::LampOn on) {
    scene::EntityDescription entity;
    entity.name = name;
    entity.world_from_body.position = position_m;
    entity.light.emplace();
    entity.light->on = on;
    return entity;
}

scene::EntityDescription bulb(const std::string& name, const Vec3& position_m, scene::LampOn on) {
    scene::EntityDescription entity = lamp(name, position_m, on);
    entity.visual = scene::Primitive{physics::SphereShape{0.1_r}};
    return entity;
}

bool is_on(const Playground& play, const std::string& name) {
    return is_lit(*play.simulation, play.simulation->find(name));
}

TEST(RulesUse, ALampIsSwitchedWithTheGlowThatBelongsToIt) {
    scene::SceneDescription scene = meadow();
    scene.sun.emplace();
    scene.sun->direction = {0, -1, 0};  // by day the lamps that wait for the dark are off
    scene.entities.push_back(bulb("bulb", {0.1_r, 1.6_r, -2}, scene::LampOn::Dark));
    scene.entities.push_back(lamp("glow", {0, 2, -2.5_r}, scene::LampOn::Dark));
    scene.entities.push_back(bulb("other", {4, 1.6_r, -2}, scene::LampOn::Always));
    scene.entities.push_back(lamp("other glow", {3, 2, -2}, scene::LampOn::Always));
    Playground play(scene);
    ASSERT_FALSE(is_on(play, "bulb"));
    EXPECT_EQ(words(play), "switch on");
    play.step(press({Action::Use}));
    EXPECT_TRUE(is_on(play, "bulb"));
    EXPECT_TRUE(is_on(play, "glow"));
    EXPECT_EQ(words(play), "switch off");
    play.step(press({Action::Use}));
    EXPECT_FALSE(is_on(play, "bulb"));
    EXPECT_FALSE(is_on(play, "glow"));
    EXPECT_TRUE(is_on(play, "other")) << "nobody looked at it";
    EXPECT_TRUE(is_on(play, "other glow"));
}

TEST(RulesUse, ALampBehindAWallIsNotSwitched) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(bulb("bulb", {0, 1.6_r, -2.5_r}, scene::LampOn::Always));
    scene.entities.push_back(block("wall", {4, 4, 0.2_r}, {0, 2, -1.6_r}));
    Playground play(scene);
    EXPECT_EQ(words(play), "");
    play.step(press({Action::Use}));
    EXPECT_TRUE(is_on(play, "bulb"));
}

TEST(RulesUse, AStandingLampWithABodyIsSwitchedByItsBody) {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription stove = block("stove", {0.6_r, 2, 0.5_r}, {0, 1, -2});
    stove.light.emplace();
    stove.light->on = scene::LampOn::Never;
    scene.entities.push_back(stove);
    Playground play(scene);
    play.step(press({Action::Use}));
    EXPECT_TRUE(is_on(play, "stove"));
}

/// A seat 0.45 m high, with a back, 1.5 m ahead; the person looks down at it.
scene::SceneDescription with_a_chair() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("chair", {1, 0.45_r, 0.5_r}, {0, 0.225_r, -1.5_r}));
    scene.entities.push_back(block("back", {1, 1, 0.05_r}, {0, 0.5_r, -1.775_r}));
    scene.player->pitch_rad = -0.68_r;
    return scene;
}

TEST(RulesUse, SitsDownInFrontOfTheBackAndGetsUpByWalking) {
    Playground play(with_a_chair());
    EXPECT_EQ(words(play), "sit down");
    const Real standing_m = play.game->view(*play.simulation, 1, 0, 0).world_from_camera.position.y;
    play.step(press({Action::Use}));
    play.run(1);
    const physics::CharacterState& state = play.game->player()->state();
    EXPECT_TRUE(play.game->player()->sits());
    EXPECT_EQ(state.ground_body, play.body("chair"));
    EXPECT_NEAR(play.feet().y, 0.45, 0.01);
    EXPECT_GT(play.feet().z, -1.75 + 0.29) << "before the back, not in it";
    const Real sitting_m = play.game->view(*play.simulation, 1, 0, 0).world_from_camera.position.y;
    EXPECT_NEAR(sitting_m, 0.45 + 0.95 - 0.2, 0.02);
    EXPECT_LT(sitting_m, standing_m - 0.3_r);
    EXPECT_FALSE(play.game->crouches()) << "no toggled crouch goes on";
    play.run(1);
    EXPECT_TRUE(play.game->player()->sits()) << "and stays";
    play.run(1, hold({Action::Back}));
    EXPECT_FALSE(play.game->player()->sits());
    EXPECT_NEAR(play.feet().y, 0, 0.01);
    const Real up_m = play.game->view(*play.simulation, 1, 0, 0).world_from_camera.position.y;
    EXPECT_NEAR(up_m, standing_m, 0.01);
}

TEST(RulesUse, NobodySitsOnTheGroundOnAWallOrWhereTheHeadWouldHit) {
    scene::SceneDescription high = meadow();
    high.entities.push_back(block("wall", {1, 1, 0.5_r}, {0, 0.5_r, -1.5_r}));
    high.player->pitch_rad = -0.4_r;
    scene::SceneDescription low = with_a_chair();
    low.entities.push_back(block("shelf", {1, 0.1_r, 1.4_r}, {0, 1.3_r, -1.9_r}));
    scene::SceneDescription ground = meadow();
    ground.player->pitch_rad = -0.8_r;
    for (const scene::SceneDescription& scene : {high, low, ground}) {
        Playground play(scene);
        EXPECT_EQ(words(play), "");
    }
}

TEST(RulesUse, WhoSitsFallsWithTheSeatAndIsSavedSitting) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("box", {1, 0.5_r, 1}, {0, 0.25_r, -1.5_r}, physics::BodyKind::Dynamic, 40));
    scene.player->pitch_rad = -0.75_r;
    Playground there(scene);
    there.step(press({Action::Use}));
    there.run(0.3);
    ASSERT_TRUE(there.game->player()->sits());
    Archive archive;
    there.game->serialize(archive, *there.simulation);
    serialize_state(*there.simulation, archive);
    const std::string bytes = archive.take();
    Playground here(scene);
    Archive read(bytes);
    here.game->serialize(read, *here.simulation);
    serialize_state(*here.simulation, read);
    ASSERT_FALSE(read.failed()) << read.fault();
    EXPECT_TRUE(here.game->player()->sits());
    here.simulation->registry.mark_for_destruction(here.simulation->find("box"));
    here.run(1);
    EXPECT_FALSE(here.game->player()->sits());
    EXPECT_NEAR(here.feet().y, 0, 0.01);
}

/// Corners of what is drawn.
std::pair<Vec3f, Vec3f> box_of(const LineList& lines) {
    Vec3f low{1e9F};
    Vec3f high{-1e9F};
    for (const LineVertex& vertex : lines.vertices) {
        low = glm::min(low, vertex.position_world);
        high = glm::max(high, vertex.position_world);
    }
    return {low, high};
}

LineList lines_of(const Playground& play) {
    LineList lines;
    play.game->add_lines(*play.simulation, 1, lines);
    return lines;
}

TEST(RulesOutlines, WhatTheHandWouldTakeHasCornersAndWhatItWouldNotHasNone) {
    const Vec3 middle{0, 1.6_r, -2};
    for (const Real mass_kg : {5.0_r, 5000.0_r}) {
        scene::SceneDescription scene = meadow();
        scene.entities.push_back(block("table", {1, 1.4_r, 1}, {0, 0.7_r, -2}));
        scene.entities.push_back(
            block("box", {0.4_r, 0.4_r, 0.4_r}, middle, physics::BodyKind::Dynamic, mass_kg));
        Playground play(scene);
        const LineList lines = lines_of(play);
        if (mass_kg > Grab::kMostMass_kg) {
            EXPECT_TRUE(lines.vertices.empty()) << "too heavy";
            continue;
        }
        EXPECT_EQ(lines.vertices.size(), 12U * 2 * 2);
        const auto [low, high] = box_of(lines);
        EXPECT_LT(glm::distance(low, Vec3f(middle) - 0.21F), 0.01F);
        EXPECT_LT(glm::distance(high, Vec3f(middle) + 0.21F), 0.01F);
        play.step(press({Action::Grab}));
        EXPECT_TRUE(lines_of(play).vertices.empty()) << "it is in the hand";
    }
}

TEST(RulesOutlines, AThingIsDroppedWhereTheEyeLooksAndThePreviewSaysWhereItComesToLie) {
    scene::SceneDescription scene = meadow();
    scene.player->pitch_rad = -0.4_r;
    Playground play(scene);
    EXPECT_TRUE(lines_of(play).vertices.empty()) << "nobody is about to drop anything";
    play.step(press({Action::Select1}));
    play.step(press({Action::Select7}));
    const auto [low, high] = box_of(lines_of(play));
    play.step(press({Action::Drop}));
    play.run(1.5);
    const Vec3 place = play.state("domino#1").world_from_body.position;
    EXPECT_NEAR(place.z, -1.65 / std::tan(0.4), 0.2) << "where the line of sight meets the ground";
    EXPECT_LT(glm::distance(Vec3f(place), (low + high) * 0.5F), 0.03F);
    EXPECT_NEAR(low.y, 0, 0.01);
    play.run(6);
    EXPECT_TRUE(lines_of(play).vertices.empty()) << "not for ever";
}

TEST(RulesOutlines, BeforeTheSkyAThingIsDroppedBeforeTheFeet) {
    scene::SceneDescription scene = meadow();
    scene.player->pitch_rad = 0.3_r;
    Playground play(scene);
    play.step(press({Action::Select2}));
    const auto [low, high] = box_of(lines_of(play));
    EXPECT_NEAR(low.y, 0, 0.01) << "it falls to the ground";
    play.step(press({Action::Drop}));
    const Vec3 place = play.state("ball#1").world_from_body.position;
    EXPECT_NEAR(glm::length(Vec3{place.x, 0, place.z}), 1.72 * std::cos(0.3), 0.05);
    EXPECT_NEAR((low.z + high.z) / 2, place.z, 0.01);
}

// A person of 75 kg, whose keys push with 80 N in time with the swing of a seat 2.3 m under its hinge.
TEST(RulesUse, WhoSitsOnASwingSwingsIt) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("seat", {0.6_r, 0.04_r, 0.3_r}, {0, 0.5_r, -1.2_r}, physics::BodyKind::Dynamic, 4));
    scene.joints.push_back({.name = "hinge",
                            .kind = physics::JointKind::Hinge,
                            .a = "seat",
                            .b = "world",
                            .anchor_a_m = {0, 2.8_r, -1.2_r},
                            .axis = {1, 0, 0}});
    Playground play(scene);
    play.step(look(0.0F, -0.75F));
    play.step(press({Action::Use}));
    ASSERT_TRUE(play.game->player()->sits());
    play.run(1);
    Real farthest_m = 0;
    for (int i = 0; i < 1200; ++i) {
        const Real speed = play.state("seat").velocity_mps.z;
        play.step(hold({speed <= 0 ? Action::Forward : Action::Back}));
        const Real off_m = play.state("seat").world_from_body.position.z + 1.2_r;
        farthest_m = std::max(farthest_m, std::abs(off_m));
        ASSERT_TRUE(play.game->player()->sits()) << i;
        ASSERT_LT(glm::distance(play.feet(), play.state("seat").world_from_body.position), 0.4_r);
        if (farthest_m > 1) break;
    }
    EXPECT_GT(farthest_m, 1) << "25 degrees";
    play.step(press({Action::Jump}));
    play.run(0.1);
    EXPECT_FALSE(play.game->player()->sits());
}

}  // namespace
}  // namespace plumbline::game
