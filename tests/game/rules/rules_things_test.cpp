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

}  // namespace
}  // namespace plumbline::game
