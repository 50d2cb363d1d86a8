// Walking, looking, dropping, throwing, switching: what actions do, with numbers.
#include "engine/scene/simulation/entity_lookup.h"
#include "tests/game/rules/playground.h"

#include <algorithm>

namespace plumbline::game {
namespace {

constexpr float kDown_rad = -0.3F;

TEST(Rules, LooksWhereTheMouseSaysAndNotPastTheZenith) {
    Playground play;
    play.step(look(0.5F, 0.2F));
    const auto now = play.game->view(*play.simulation, 1, 0.1F, -0.1F);
    const Vec3 forward = now.world_from_camera.orientation * Vec3{0, 0, -1};
    EXPECT_NEAR(std::atan2(-forward.x, -forward.z), 0.6, 1e-5) << "left is positive";
    EXPECT_NEAR(std::asin(forward.y), 0.1, 1e-5);
    EXPECT_TRUE(now.has_player);

    play.step(look(0.0F, 100.0F));
    const auto up = play.game->view(*play.simulation, 1, 0.0F, 1.0F);
    const Vec3 zenith = up.world_from_camera.orientation * Vec3{0, 0, -1};
    EXPECT_NEAR(std::asin(zenith.y), radians_from_degrees(89.0), 1e-3);
}

TEST(Rules, KeysTurnAsFastAfterAChangeOfTheRate) {
    const auto turned_rad = [](bool changes_rate) {
        Playground play;
        if (changes_rate) {
            physics::WorldDef def = play.simulation->physics.def();
            def.step_s /= 4;
            play.simulation->set_accuracy(def);
        }
        play.run(0.5, hold({Action::RotateLeft}));
        const Quat view = play.game->view(*play.simulation, 1, 0, 0).world_from_camera.orientation;
        const Vec3 forward = view * Vec3{0, 0, -1};
        return std::atan2(-forward.x, -forward.z);
    };
    EXPECT_GT(turned_rad(false), 0.3);
    EXPECT_NEAR(turned_rad(true), turned_rad(false), 0.03);
}

TEST(Rules, TheHandIsBelowTheEyeAndAimsAtTheSamePoint) {
    Playground play;
    const auto view = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    const Vec3 hand =
        transform_point(invert(view.world_from_camera), view.world_from_hand.position);
    EXPECT_NEAR(hand.x, 0.25, 1e-4);
    EXPECT_NEAR(hand.y, -0.25, 1e-4);
    const Vec3 seen = transform_point(view.world_from_camera, {0, 0, -12});
    const Vec3 aimed = transform_point(invert(view.world_from_hand), seen);
    EXPECT_NEAR(aimed.x, 0, 1e-3);
    EXPECT_NEAR(aimed.y, 0, 1e-3);
    EXPECT_LT(aimed.z, 0);
}

TEST(Rules, DropsOneThingInFront) {
    Playground play;
    play.step(press({Action::Select1}));
    play.step(press({Action::Drop}));
    ASSERT_EQ(play.thing_count(), 1U);
    const physics::BodyState crate = play.state("crate#1");
    EXPECT_NEAR(crate.world_from_body.position.x, 0, 1e-3);
    EXPECT_LT(crate.world_from_body.position.z, -1);
    EXPECT_GT(crate.world_from_body.position.z, -3);
    play.run(2);
    EXPECT_NEAR(play.state("crate#1").world_from_body.position.y, 0.4, 0.01) << "it fell";
    EXPECT_NEAR(play.feet().z, 0, 1e-3) << "and pushed nobody";
}

TEST(Rules, AHeldKeyDropsSixASecond) {
    for (const int hz : {30, 60, 240}) {
        Playground play(meadow(), hz);
        play.step(press({Action::Select4}));
        play.step(press({Action::Drop}));
        play.run(3, hold({Action::Drop}));
        // One at once, then from 0.4 s on six a second.
        EXPECT_NEAR(static_cast<double>(play.thing_count()), 1 + 1 + 2.6 * 6, 1) << hz << " Hz";
    }
}

TEST(Rules, FivePressesDropFive) {
    Playground play;
    play.step(press({Action::Select2}));
    for (int i = 0; i < 5; ++i) {
        play.step(press({Action::Drop}));
        play.step();
    }
    EXPECT_EQ(play.thing_count(), 5U);
}

TEST(Rules, RemovesWhatIsLookedAtButNotTheGround) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("box", {1, 1, 1}, {0, 1.2_r, -3}, physics::BodyKind::Dynamic, 5));
    Playground play(scene);
    play.step(look(0.0F, kDown_rad));
    play.step(press({Action::Remove}));
    EXPECT_FALSE(play.simulation->registry.alive(play.simulation->find("box")));
    play.step(press({Action::Remove}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"nothing to delete"});
    EXPECT_TRUE(play.simulation->registry.alive(play.simulation->find("ground")));
}

TEST(Rules, ThrowsFasterTheLongerTheCharge) {
    // 5 m/s up to 0.2 s, then evenly up to 25 m/s at 1 s.
    for (const double held_s : {0.1, 0.2, 0.6, 1.0, 2.0}) {
        Playground play;
        play.step(press({Action::Select2}));
        play.step(press({Action::Throw}));
        play.run(held_s - play.simulation->step_s(), hold({Action::Throw}));
        play.step();  // released
        ASSERT_EQ(play.thing_count(), 1U);
        const double share = std::clamp((held_s - 0.2) / 0.8, 0.0, 1.0);
        const double g_step = 9.81 / 60;
        const Vec3 velocity = play.state("ball#1").velocity_mps;
        EXPECT_NEAR(-velocity.z, 5 + 20 * share, 0.02) << held_s;
        EXPECT_NEAR(velocity.y, -g_step, 0.02);
    }
}

TEST(Rules, AThrowTakesTheRunAlong) {
    Playground play;
    play.step(press({Action::Select2}));
    play.run(1, hold({Action::Forward, Action::Sprint}));
    Actions tap = hold({Action::Forward, Action::Sprint});
    tap.pressed[static_cast<std::size_t>(Action::Throw)] = 1;
    play.step(tap);
    ASSERT_EQ(play.thing_count(), 1U);
    EXPECT_NEAR(-play.state("ball#1").velocity_mps.z, 5 + 4.5, 0.02);
}

TEST(Rules, TheFlashlightOnlyWorksWhereThereIsOne) {
    Playground dark;
    dark.step(press({Action::Flashlight}));
    EXPECT_TRUE(dark.simulation->switches.effects.empty());
    EXPECT_EQ(dark.messages(), std::vector<std::string>{"this scene has no flashlight"});

    scene::SceneDescription scene = meadow();
    scene.flashlight.emplace();
    Playground lit(scene);
    lit.step(press({Action::Flashlight}));
    EXPECT_TRUE(lit.simulation->switches.is_on("flashlight", false));
    lit.step(press({Action::Flashlight}));
    EXPECT_FALSE(lit.simulation->switches.is_on("flashlight", true));
}

TEST(Rules, FogAndLightAnswerTheirKeys) {
    Playground play;
    play.step(press({Action::Fog}));
    EXPECT_TRUE(play.simulation->switches.is_on("fog", false));
    play.step(press({Action::LightBrighter}));
    EXPECT_FLOAT_EQ(play.simulation->switches.light_scale, 1.25F);
    play.step(press({Action::LightDimmer}));
    EXPECT_FLOAT_EQ(play.simulation->switches.light_scale, 1.0F);
    play.step(press({Action::SunFaster}));
    EXPECT_GT(play.simulation->switches.sun_rotation_radps, 0.0F);
    play.step(press({Action::SunStop}));
    EXPECT_EQ(play.simulation->switches.sun_rotation_radps, 0.0F);
}

TEST(Rules, FliesOrbitsAndWalksAgain) {
    Playground play;
    play.step(press({Action::MoveMode}));
    ASSERT_EQ(play.game->mode(), MoveMode::Fly);
    play.run(2, hold({Action::Jump}));
    const auto high = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    EXPECT_NEAR(high.world_from_camera.position.y, 1.65 + 5 * (2 - 0.08), 0.1);
    EXPECT_FALSE(high.has_player);
    const Vec3 before = high.world_from_camera.position;
    play.step(press({Action::Push}));  // one notch faster
    play.run(2);
    play.run(1, hold({Action::Forward}));
    const auto ahead = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    EXPECT_NEAR(before.z - ahead.world_from_camera.position.z, 6.25 * (1 - 0.08), 0.1);

    play.step(look(0.0F, -0.5F));
    play.step(press({Action::MoveMode}));
    ASSERT_EQ(play.game->mode(), MoveMode::Orbit);
    const auto start = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    const Vec3 target = start.world_from_camera.position +
                        start.world_from_camera.orientation * Vec3{0, 0, -1} *
                            (start.world_from_camera.position.y / std::sin(0.5_r));
    const Real distance = glm::distance(start.world_from_camera.position, target);
    play.run(1, hold({Action::RotateLeft}));
    const auto turned = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    EXPECT_NEAR(glm::distance(turned.world_from_camera.position, target), distance, 0.01);
    EXPECT_GT(glm::distance(turned.world_from_camera.position, start.world_from_camera.position),
              1);
    play.run(30, hold({Action::ZoomIn}));
    const auto near = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    EXPECT_NEAR(glm::distance(near.world_from_camera.position, target), 0.1, 0.01);

    play.step(press({Action::MoveMode}));
    EXPECT_EQ(play.game->mode(), MoveMode::Walk);
    play.run(3);
    EXPECT_NEAR(play.feet().y, 0, 1e-3);
}

TEST(Rules, TargetsHaveNamesThatAPersonReads) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("oak_crate_12", {0.8_r, 3, 0.8_r}, {0, 1.5_r, -2}, physics::BodyKind::Dynamic, 30));
    Playground unlabelled(scene);
    EXPECT_EQ(unlabelled.game->hud(*unlabelled.simulation).looking_at, "oak crate, 30 kg");
    scene.entities.back().label = "ball of wool";
    scene.entities.back().body->mass_kg = 0.25_r;
    Playground labelled(scene);
    EXPECT_EQ(labelled.game->hud(*labelled.simulation).looking_at, "ball of wool, 0.25 kg");
    scene.entities.back().label.clear();
    scene.entities.back().name = "entity[1]";
    Playground nameless(scene);
    EXPECT_EQ(nameless.game->hud(*nameless.simulation).looking_at, "0.25 kg");
}

// The keys of the profiles `book`, `nature` and `viewer` do something in the mode a scene starts in.
TEST(Rules, TurnsByKeysAndZoomsByTheWheelWhileWalking) {
    Playground play;
    const auto forward = [&] {
        return play.game->view(*play.simulation, 1, 0.0F, 0.0F).world_from_camera.orientation *
               Vec3{0, 0, -1};
    };
    play.run(0.5, hold({Action::RotateLeft}));
    EXPECT_NEAR(forward().x, -std::sin(0.8), 0.02);  // 1.6 rad/s to the left
    play.run(0.5, hold({Action::RotateRight}));
    EXPECT_NEAR(forward().x, 0.0, 0.02);

    const Real before = play.game->view(*play.simulation, 1, 0.0F, 0.0F).fov_y_rad;
    Actions wheel;
    wheel.pressed[static_cast<std::size_t>(Action::ZoomIn)] = 2;
    play.step(wheel);
    EXPECT_NEAR(play.game->view(*play.simulation, 1, 0.0F, 0.0F).fov_y_rad,
                before * std::exp(-0.2_r),
                1e-4);
}

TEST(Rules, AFieldOfViewThatStaysIsTheSameToTheBitBetweenSteps) {
    Playground play;
    for (int zoom = 0; zoom < 5; ++zoom) {
        const auto fov_rad = [&play](Real blend) {
            return play.game->view(*play.simulation, blend, 0.0F, 0.0F).fov_y_rad;
        };
        for (int i = 0; i <= 1000; ++i)
            EXPECT_EQ(fov_rad(static_cast<Real>(i) / 1000), fov_rad(1)) << zoom << ' ' << i;
        const Real before_rad = fov_rad(1);
        play.step(press({Action::ZoomIn}));
        EXPECT_LT(fov_rad(1), before_rad);
        play.step({});
    }
}

TEST(Rules, AViewWithoutAPlayerStartsAtTheCamera) {
    scene::SceneDescription scene = meadow();
    scene.player.reset();
    scene.camera.position_m = {4, 3, 6};
    scene.camera.target_m = {0, 0.5_r, 0};
    Playground play(scene);
    EXPECT_EQ(play.game->mode(), MoveMode::Fly);
    const auto view = play.game->view(*play.simulation, 0.5_r, 0.0F, 0.0F);
    EXPECT_LT(glm::distance(view.world_from_camera.position, Vec3(4, 3, 6)), 1e-5);
    const Vec3 wanted = glm::normalize(scene.camera.target_m - scene.camera.position_m);
    EXPECT_GT(glm::dot(view.world_from_camera.orientation * Vec3{0, 0, -1}, wanted), 0.99999);
}

TEST(Rules, TheSameActionsGiveTheSameBits) {
    const auto play_once = [] {
        Playground play;
        Random random(7);
        for (int i = 0; i < 600; ++i) {
            Actions actions = look(random.uniform(-0.05F, 0.05F), random.uniform(-0.03F, 0.03F));
            for (const Action action : {Action::Forward,
                                        Action::Left,
                                        Action::Jump,
                                        Action::Drop,
                                        Action::Throw,
                                        Action::Grab,
                                        Action::NextThing,
                                        Action::UndoDrop,
                                        Action::Freeze}) {
                if (random.below(5) == 0) {
                    const Actions more = press({action});
                    actions.held |= more.held;
                    actions.pressed[static_cast<std::size_t>(action)] = 1;
                }
            }
            play.step(actions);
        }
        EXPECT_GT(play.thing_count(), 3U);
        return play.simulation->state_hash();
    };
    EXPECT_EQ(play_once(), play_once());
}

}  // namespace
}  // namespace plumbline::game
