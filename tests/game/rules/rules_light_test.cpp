// What the garden report's keys do: the spotlight, the fog, the pace, turning while one walks.
#include "engine/scene/environment/live_light.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

scene::SceneDescription lit_meadow() {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription lamp;
    lamp.name = "lamp";
    lamp.world_from_body = {.position = {3, 4, -2},
                            .orientation = glm::angleAxis(kPi / 2, Vec3{0, 1, 0})};
    lamp.light = scene::LightDescription{.is_spot = true};
    scene.entities.push_back(lamp);
    lamp.name = "far";
    lamp.world_from_body.position = {90, 4, 0};
    scene.entities.push_back(lamp);
    return scene;
}

Vec3 spot_direction(const Playground& play, const char* name) {
    const ecs::Entity entity = play.simulation->find(name);
    const auto& light = play.simulation->registry.get<scene::PointLight>(entity);
    return play.simulation->registry.get<scene::Transform>(entity).world_from_body.orientation *
           Vec3(light.direction_body);
}

// SOURCES B13: from (3, 4, -2) to where the eye at (0, 1.65, 0) meets the ground.
TEST(RulesLight, TheNearestSpotShinesWhereOneLooksWhileTheKeyIsDown) {
    Playground play(lit_meadow());
    const Vec3 untouched = spot_direction(play, "far");
    play.step(look(0.0F, -0.3F));
    play.step(press({Action::AimSpot}));
    const Real eye_m = play.game->player()->state().eye_position_m.y;
    const Vec3 seen{0, 0, -eye_m / std::tan(0.3_r)};
    const Vec3 wanted = glm::normalize(seen - Vec3{3, 4, -2});
    EXPECT_NEAR(glm::distance(spot_direction(play, "lamp"), wanted), 0, 1e-3);
    EXPECT_NEAR(glm::distance(spot_direction(play, "far"), untouched), 0, 1e-6);
    EXPECT_EQ(play.messages(), std::vector<std::string>{"spotlight aimed"});

    Actions held = hold({Action::AimSpot});
    held.look_yaw_rad = 0.4F;
    play.step(held);
    const Real away_m = eye_m / std::tan(0.3_r);
    const Vec3 turned{-away_m * std::sin(0.4_r), 0, -away_m * std::cos(0.4_r)};
    EXPECT_NEAR(
        glm::distance(spot_direction(play, "lamp"), glm::normalize(turned - Vec3{3, 4, -2})),
        0,
        1e-3)
        << "the mouse moves it";

    const Vec3 before = spot_direction(play, "lamp");
    play.step(look(0.5F, 0.0F));
    EXPECT_EQ(spot_direction(play, "lamp"), before) << "the key is up";
}

TEST(RulesLight, WithoutASpotItSaysSo) {
    Playground play;
    play.step(press({Action::AimSpot}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"this scene has no spotlight"});
}

// SOURCES B26
TEST(RulesLight, FogGrowsDenserAndThinnerAndTakesColours) {
    scene::SceneDescription scene = meadow();
    scene.fog.emplace();
    scene.fog->density_per_m = 0.04F;
    scene.fog->on = false;
    Playground play(scene);
    const scene::LiveSwitches& switches = play.simulation->switches;
    EXPECT_FALSE(switches.is_on("fog", scene.fog->on));
    play.step(press({Action::Fog}));
    EXPECT_TRUE(switches.is_on("fog", scene.fog->on)) << "off at first, so a press is on";
    play.step(press({Action::Fog}));
    EXPECT_FALSE(switches.is_on("fog", scene.fog->on));
    play.step(press({Action::FogDenser}));
    EXPECT_TRUE(switches.is_on("fog", scene.fog->on)) << "who changes it wants to see it";
    EXPECT_EQ(switches.fog_density_scale, 1.25F);
    EXPECT_EQ(play.messages(), std::vector<std::string>{"fog: 0.05 per m, scene colour"});
    for (int i = 0; i < 100; ++i) play.step(press({Action::FogThinner}));
    EXPECT_EQ(switches.fog_density_scale, 0.05F) << "the thinnest";
    for (int i = 0; i < 100; ++i) play.step(press({Action::FogDenser}));
    EXPECT_EQ(switches.fog_density_scale, 50.0F) << "the densest";
    play.messages();
    play.step(press({Action::FogColor}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"fog: 2 per m, white"});
    for (std::size_t i = 1; i < scene::kFogColors.size(); ++i) play.step(press({Action::FogColor}));
    EXPECT_EQ(switches.fog_color, 0U) << "round once";
}

// SOURCES B11: each notch a quarter more, in every mode.
TEST(RulesLight, TheWheelSetsThePace) {
    Playground play;
    play.step(press({Action::Push}));
    play.step(press({Action::Push}));
    EXPECT_EQ(play.messages(),
              (std::vector<std::string>{"walk speed 2.2 m/s", "walk speed 2.8 m/s"}));
    const Real from = play.feet().z;
    play.run(3, hold({Action::Forward}));
    EXPECT_NEAR(from - play.feet().z, 1.8 * 1.25 * 1.25 * 3, 0.1);
    for (int i = 0; i < 40; ++i) play.step(press({Action::Pull}));
    play.run(1);
    const Real slow_from = play.feet().z;
    play.run(3, hold({Action::Forward}));
    EXPECT_NEAR(slow_from - play.feet().z, 1.8 * 0.25 * 3, 0.05) << "the slowest";
    play.step(press({Action::MoveMode}));
    play.messages();
    play.step(press({Action::Push}));
    EXPECT_EQ(play.messages(), std::vector<std::string>{"fly speed 6.2 m/s"});
}

// SOURCES B9: Q and E of the profile nature.
TEST(RulesLight, TurnsWhileWalking) {
    Playground play;
    play.run(0.5, hold({Action::RotateLeft, Action::Forward}));
    const auto view = play.game->view(*play.simulation, 1, 0, 0);
    const Vec3 forward = view.world_from_camera.orientation * Vec3{0, 0, -1};
    EXPECT_NEAR(std::atan2(-forward.x, -forward.z), 1.6 * 0.5, 1e-4) << "left, 1.6 rad/s";
    EXPECT_LT(play.feet().z, -0.3) << "and walks on";
}

}  // namespace
}  // namespace plumbline::game
