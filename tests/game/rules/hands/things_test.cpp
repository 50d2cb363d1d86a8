// The things that may be dropped, and the order in which they came and go.
#include "engine/scene/simulation/entity_lookup.h"
#include "tests/game/rules/playground.h"

#include <filesystem>

namespace plumbline::game {
namespace {

TEST(Things, ChoosesByNumberAndInTurn) {
    Playground play;
    for (std::size_t i = 0; i < kThingCount; ++i) {
        play.step(press({static_cast<Action>(static_cast<std::size_t>(Action::Select1) + i)}));
        EXPECT_EQ(play.game->hud(*play.simulation).chosen_thing, kThingNames[i]);
    }
    play.step(press({Action::NextThing}));
    EXPECT_EQ(play.game->things().chosen_name(), "crate");
    play.step(press({Action::PreviousThing}));
    EXPECT_EQ(play.game->things().chosen_name(), "domino");
    play.step(press({Action::Select9}));
    EXPECT_EQ(play.game->things().chosen_name(), "domino") << "there is no ninth thing";
}

TEST(Things, EveryThingCanBeDropped) {
    for (std::size_t i = 0; i < kThingCount; ++i) {
        Playground play;
        play.step(press({static_cast<Action>(static_cast<std::size_t>(Action::Select1) + i)}));
        play.step(press({Action::Drop}));
        EXPECT_EQ(play.thing_count(), 1U) << kThingNames[i];
        play.run(1);
        const Vec3 place = play.state(std::string(kThingNames[i]) + "#1").world_from_body.position;
        EXPECT_GT(place.y, 0) << kThingNames[i];
    }
}

TEST(Things, TheShippedThingsAreDroppedInScenesThatDoNotKnowThem) {
    Playground play(meadow(), 60, PL_SOURCE_DIR "/assets");
    for (std::size_t i = 0; i < kThingCount; ++i) {
        ASSERT_FALSE(play.game->things().thing(i).description.location.file == nullptr)
            << kThingNames[i] << " is not in things.toml";
        play.step(press({static_cast<Action>(static_cast<std::size_t>(Action::Select1) + i)}));
        play.step(press({Action::Drop}));
        play.run(0.8);
        play.step(look(0.8F, 0.0F));
    }
    EXPECT_EQ(play.thing_count(), kThingCount);
    play.run(3);
    for (auto [entity, dropped, place, visual] :
         play.simulation->registry
             .view<const scene::Dropped, const scene::Transform, const scene::Visual>()) {
        static_cast<void>(dropped);
        EXPECT_GT(place.world_from_body.position.y, -0.01);
        EXPECT_LT(place.world_from_body.position.y, 1) << "at rest on the ground";
        EXPECT_FALSE(visual.materials.empty()) << describe(*play.simulation, entity);
        for (const assets::MaterialId id : visual.materials) {
            const assets::MaterialData& material = play.simulation->library().material(id);
            EXPECT_FALSE(material.base_color_map.empty() && material.surface.empty())
                << describe(*play.simulation, entity) << " is grey: nobody knows its "
                << material.name;
        }
    }
    EXPECT_TRUE(play.simulation->warnings.empty()) << play.simulation->warnings.front();
}

TEST(Things, UndoTakesTheLatestAway) {
    Playground play;
    play.step(press({Action::Select2}));
    play.step(press({Action::Drop}));
    play.step(press({Action::Drop}));
    play.step(press({Action::UndoDrop}));
    EXPECT_EQ(play.thing_count(), 1U);
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("ball#1")));
    play.step(press({Action::UndoDrop}));
    play.step(press({Action::UndoDrop}));
    EXPECT_EQ(play.thing_count(), 0U);
    EXPECT_EQ(play.messages(), std::vector<std::string>{"nothing to undo"});
}

TEST(Things, DroppingOnAndOnKeepsToTheLimitAndSaysSoOnce) {
    Playground play;
    play.step(press({Action::Select2}));
    int told = 0;
    for (std::size_t i = 0; i < Things::kMost + 40; ++i) {
        play.step(look(0.37F, 0.0F));
        play.step(press({Action::Drop}));
        for (const std::string& message : play.messages()) {
            if (message ==
                "limit of 500 dropped objects reached: the oldest one is removed for each new one")
                ++told;
        }
    }
    EXPECT_LE(play.thing_count(), Things::kMost);
    EXPECT_EQ(told, 1);
}

TEST(Things, AScenesOwnPrefabGoesBeforeTheShippedOne) {
    scene::SceneDescription scene = meadow();
    scene.prefabs["brick"] = block("gold bar", {0.3_r, 0.1_r, 0.1_r}, {0, 0, 0});
    Playground play(scene, 60, PL_SOURCE_DIR "/assets");
    const Things& things = play.game->things();
    const auto index = [](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(kThingNames, name) - kThingNames.begin());
    };
    const scene::EntityDescription& brick = things.thing(index("brick")).description;
    const auto& bar = std::get<physics::BoxShape>(std::get<scene::Primitive>(brick.visual));
    EXPECT_EQ(bar.size_m, Vec3(0.3_r, 0.1_r, 0.1_r));
    EXPECT_EQ(brick.name, "brick") << "called as what it stands for";
    EXPECT_EQ(brick.body->kind, physics::BodyKind::Dynamic) << "whatever the scene has it as";
    EXPECT_FALSE(things.thing(index("brick")).material.has_value());
    EXPECT_NE(things.thing(index("ball")).description.location.file, nullptr) << "things.toml";
}

TEST(Things, WithoutAnyFileAllAreOfTheirPlainMass) {
    Playground play;
    const Things& things = play.game->things();
    constexpr std::array<Real, kThingCount> kMass_kg{30, 0.6_r, 35, 3.5_r, 13, 35, 20};
    for (std::size_t i = 0; i < kThingCount; ++i) {
        EXPECT_EQ(things.thing(i).description.body->mass_kg, kMass_kg[i]) << kThingNames[i];
        EXPECT_TRUE(things.thing(i).material.has_value());
        // The builder cannot look up what the scene does not know.
        EXPECT_TRUE(things.thing(i).description.body->friction.has_value());
    }
}

TEST(Things, TheNextOneGoesRoundInBothDirections) {
    Playground play;
    Things things(*play.simulation, "no such folder");
    things.choose_next(-1);
    EXPECT_EQ(things.chosen(), kThingCount - 1);
    things.choose_next(1);
    EXPECT_EQ(things.chosen(), 0U);
    things.choose_next(-15);
    EXPECT_EQ(things.chosen(), 6U) << "two rounds and one";
    things.choose(3);
    things.choose(kThingCount);
    EXPECT_EQ(things.chosen(), 3U) << "there is no such thing";
}

}  // namespace
}  // namespace plumbline::game
