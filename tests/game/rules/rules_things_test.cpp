// What the hands are told about.
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

TEST(RulesThings, AThingInSightIsCalledByItsLabel) {
    scene::SceneDescription scene = meadow();
    const auto pillar = [&](const char* name, const char* label, const Vec3& position_m) {
        scene.entities.push_back(block(name, {1, 2, 1}, position_m, physics::BodyKind::Dynamic));
        scene.entities.back().label = label;
    };
    pillar("crate_17", "oak crate", {0, 1, -2});
    pillar("stone_3", "", {2, 1, 0});
    Playground play(scene);
    EXPECT_EQ(play.game->hud(*play.simulation).looking_at, "oak crate, 1 kg");
    play.step(look(-static_cast<float>(kPi) / 2, 0.0F));
    EXPECT_EQ(play.game->hud(*play.simulation).looking_at, "stone, 1 kg") << "where there is none";
    EXPECT_EQ(play.simulation->registry.get<scene::Name>(play.simulation->find("crate_17")).text,
              "crate_17")
        << "files and reports go on with its name";
}

// What it fell into goes with it.
TEST(RulesThings, UndoTakesAwayAllPartsOfWhatBroke) {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription crate =
        block("crate", {0.4_r, 0.4_r, 0.4_r}, {0, 0, 0}, physics::BodyKind::Dynamic, 5);
    crate.body->fracture = scene::FractureDescription{.pieces = 6};
    scene.prefabs.emplace("crate", crate);
    Playground play(scene);
    play.step(press({Action::Drop}));
    play.step(press({Action::Drop}));
    ASSERT_EQ(play.thing_count(), 2U);
    const std::vector<std::vector<std::uint32_t>> parts{{0, 1}, {2, 3}, {4, 5}};
    play.simulation->break_up(play.simulation->find("crate#2"), parts, {});
    play.run(0.2);
    EXPECT_EQ(play.thing_count(), 4U);
    play.step(press({Action::UndoDrop}));
    EXPECT_EQ(play.thing_count(), 1U);
    EXPECT_TRUE(play.simulation->find("crate#1"));
    play.step(press({Action::UndoDrop}));
    EXPECT_EQ(play.thing_count(), 0U);
}

TEST(Plaques, TheOneNearestToTheMiddleOfTheViewIsRead) {
    scene::SceneDescription scene = meadow();
    for (const auto& [name, x_m] : {std::pair{"left", -1.0_r}, {"ahead", 0.2_r}, {"far", 0.0_r}}) {
        scene.entities.push_back(
            block(name, {0.1_r, 0.1_r, 0.1_r}, {x_m, 1.6_r, std::string(name) == "far" ? -9 : -3}));
        scene.entities.back().plaque = scene::PlaqueDescription{.title = name};
    }
    Playground play(scene);
    const auto title = [&] {
        const auto plaque = play.game->hud(*play.simulation).plaque;
        return plaque ? plaque->says.title : std::string();
    };
    EXPECT_EQ(title(), "ahead");
    play.step(look(0.5F, 0));
    EXPECT_EQ(title(), "left") << "turned left";
    play.step(look(1.5F, 0));
    EXPECT_EQ(title(), "");
}

}  // namespace
}  // namespace plumbline::game
