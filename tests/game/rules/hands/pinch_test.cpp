// Cloth and soft bodies in a person's hand: lifted, let go, thrown, too heavy, saved.
#include "game/rules/hands/pinch.h"

#include "engine/core/io/archive.h"
#include "engine/effects/advance.h"
#include "engine/effects/effect_runtime.h"
#include "engine/physics/deformable.h"
#include "engine/scene/simulation/simulation_archive.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

constexpr double kStepsPerSecond = 60;

/// A jelly of 8 kg ahead, or of 216 kg, and a flag beside it.
scene::SceneDescription kitchen(double jelly_kgpm3) {
    scene::SceneDescription scene = meadow();
    scene::SoftDescription soft;
    soft.name = "jelly";
    soft.size_m = {0.6, 0.6, 0.6};
    soft.cell_m = 0.2;
    soft.young_Pa = 5e4;
    soft.density_kgpm3 = jelly_kgpm3;
    soft.damping_s = 0.01;
    soft.pose.position = {0, 0.31_r, -1.6_r};
    scene.forces.softs = {soft};
    scene::ClothDescription cloth;
    cloth.name = "flag";
    cloth.cells = {{8, 8}};
    cloth.pose.position = {2, 1.2_r, 0};
    cloth.pose.orientation = glm::angleAxis(1.5707963_r, Vec3{0, 1, 0});
    cloth.pins = {{.along = {0, 0, 1, 0}, .to = {}}};
    scene.forces.cloths = {cloth};
    return scene;
}

class PinchPlayground : public Playground {
public:
    explicit PinchPlayground(double jelly_kgpm3 = 40)
        : Playground(kitchen(jelly_kgpm3)), effects_(*simulation, {}) {
        go_on(0.5);
    }
    void go_on(double seconds, const Actions& actions = {}) {
        const auto count = static_cast<int>(seconds * kStepsPerSecond + 0.5);
        for (int i = 0; i < count; ++i) effects::advance(*simulation, effects_, *game, actions);
    }
    /// Looks there, takes what is there and holds on.
    void take(const Vec3& point_m) {
        effects::advance(*simulation, effects_, *game, turn_to(point_m));
        effects::advance(*simulation, effects_, *game, press({Action::Grab}));
    }
    physics::Deformable& jelly() { return *simulation->softs()[0].body; }
    physics::Deformable& flag() { return *simulation->cloths()[0].body; }
    static Vec3d middle_of(const physics::Deformable& each) {
        return each.body().totals().moment_kgm / each.body().mass_kg();
    }

private:
    effects::EffectRuntime effects_;
};

Actions up_while_holding() {
    Actions actions = hold({Action::Grab});
    actions.look_pitch_rad = 0.01F;
    return actions;
}

TEST(Pinch, LiftsASoftBodyAndLetsItFall) {
    PinchPlayground play;
    const double lying_m = PinchPlayground::middle_of(play.jelly()).y;
    play.take({0, 0.4_r, -1.3_r});
    ASSERT_TRUE(play.jelly().is_gripped());
    EXPECT_TRUE(play.game->holds());
    play.go_on(1, up_while_holding());
    play.go_on(1, hold({Action::Grab}));
    const double lifted_m = PinchPlayground::middle_of(play.jelly()).y;
    EXPECT_GT(lifted_m, lying_m + 0.5);
    EXPECT_EQ(play.thing_count(), 0U);
    play.go_on(0.3);
    EXPECT_FALSE(play.jelly().is_gripped());
    EXPECT_FALSE(play.game->holds());
    EXPECT_LT(PinchPlayground::middle_of(play.jelly()).y, lifted_m - 0.2) << "it falls";
}

TEST(Pinch, ThrowsItAsAWhole) {
    PinchPlayground play;
    play.take({0, 0.4_r, -1.3_r});
    play.go_on(1, up_while_holding());
    play.go_on(1.0 / 60, press({Action::Throw, Action::Grab}));
    play.go_on(1.0 / 60, hold({Action::Grab}));
    EXPECT_FALSE(play.jelly().is_gripped());
    const physics::PointTotals totals = play.jelly().body().totals();
    EXPECT_LT(totals.momentum_kgmps.z / play.jelly().body().mass_kg(), -1);
    EXPECT_EQ(play.thing_count(), 0U) << "nothing else was thrown";
}

TEST(Pinch, PullsClothAsideWhosePinsHold) {
    PinchPlayground play;
    const Vec3d corner = play.flag().body().positions_m()[0];
    play.take({2, 1, 0});
    ASSERT_TRUE(play.flag().is_gripped());
    Actions aside = hold({Action::Grab});
    aside.look_yaw_rad = 0.01F;
    play.go_on(0.5, aside);
    EXPECT_GT(glm::distance(PinchPlayground::middle_of(play.flag()), {2, 1.2, 0}), 0.05);
    EXPECT_LT(glm::distance(play.flag().body().positions_m()[0], corner), 1e-6);
    play.go_on(3);
    EXPECT_LT(std::abs(PinchPlayground::middle_of(play.flag()).x - 2), 0.1);
}

TEST(Pinch, WhatIsTooHeavySlipsOutOfTheHand) {
    PinchPlayground play(1000);
    play.take({0, 0.4_r, -1.3_r});
    ASSERT_TRUE(play.jelly().is_gripped());
    play.messages();
    play.go_on(2, up_while_holding());
    EXPECT_FALSE(play.jelly().is_gripped());
    EXPECT_EQ(play.messages(), std::vector<std::string>{"too heavy to lift"});
    EXPECT_LT(PinchPlayground::middle_of(play.jelly()).y, 1);
}

TEST(Pinch, WhatIsFrozenStaysInTheAirUntilItThaws) {
    PinchPlayground play;
    play.take({0, 0.4_r, -1.3_r});
    play.go_on(1, up_while_holding());
    play.messages();
    play.go_on(1.0 / 60, press({Action::Freeze, Action::Grab}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"frozen"});
    EXPECT_TRUE(play.jelly().is_frozen());
    play.go_on(0.1);
    const Vec3d there = PinchPlayground::middle_of(play.jelly());
    EXPECT_GT(there.y, 0.6);
    play.go_on(2);
    EXPECT_EQ(PinchPlayground::middle_of(play.jelly()), there);
    EXPECT_TRUE(play.jelly().is_asleep());
    play.go_on(1.0 / 60, play.turn_to(Vec3(there)));
    play.go_on(1.0 / 60, press({Action::Freeze}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"unfrozen"});
    play.go_on(0.5);
    EXPECT_LT(PinchPlayground::middle_of(play.jelly()).y, there.y - 0.2);
}

TEST(Pinch, WhatIsDeletedIsGoneAndLetsFallWhatLayOnIt) {
    PinchPlayground play;
    scene::EntityDescription box;
    box.name = "box";
    box.visual = physics::BoxShape{.size_m = {0.3_r, 0.2_r, 0.3_r}};
    box.world_from_body.position = {0, 0.75_r, -1.6_r};
    box.body = scene::BodyDescription{.mass_kg = Real{1}};
    const ecs::Entity entity = play.simulation->spawn(box);
    const physics::BodyId body = play.simulation->registry.get<scene::BodyRef>(entity).body;
    play.go_on(4);
    const auto height = [&] {
        return static_cast<double>(play.simulation->physics.state(body).world_from_body.position.y);
    };
    EXPECT_GT(height(), 0.5) << "it lies on the jelly";
    play.go_on(1.0 / 60, play.turn_to({0, 0.3_r, -1.35_r}));
    EXPECT_EQ(play.game->hud(*play.simulation).looking_at, "soft body, 8.64 kg");
    play.go_on(1.0 / 60, press({Action::Remove}));
    play.go_on(2);
    EXPECT_TRUE(play.simulation->softs().empty());
    EXPECT_NEAR(height(), 0.1, 0.01);

    Archive out;
    play.game->serialize(out, *play.simulation);
    scene::serialize_state(*play.simulation, out);
    PinchPlayground again;
    const std::string bytes = out.take();
    Archive in(bytes);
    again.game->serialize(in, *again.simulation);
    EXPECT_TRUE(again.simulation->softs().empty()) << in.fault();
}

TEST(Pinch, GoesOnFromASavedGameToTheBit) {
    PinchPlayground first;
    first.take({0, 0.4_r, -1.3_r});
    first.go_on(0.5, up_while_holding());
    Archive out;
    scene::serialize_state(*first.simulation, out);
    first.game->serialize(out, *first.simulation);
    const std::string bytes = out.take();
    PinchPlayground second;
    Archive in(bytes);
    scene::serialize_state(*second.simulation, in);
    second.game->serialize(in, *second.simulation);
    ASSERT_FALSE(in.failed()) << in.fault();
    EXPECT_TRUE(second.jelly().is_gripped());
    first.go_on(0.5, up_while_holding());
    second.go_on(0.5, up_while_holding());
    EXPECT_EQ(second.simulation->state_hash(), first.simulation->state_hash());
    second.go_on(0.1);
    EXPECT_FALSE(second.jelly().is_gripped());
}

}  // namespace
}  // namespace plumbline::game
