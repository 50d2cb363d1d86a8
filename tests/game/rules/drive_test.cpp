// Sitting on a cart and driving it.
#include "game/rules/drive.h"

#include "engine/effects/advance.h"
#include "engine/effects/effect_runtime.h"
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

/// A cart of 440 kg, its middle 2.5 m ahead of the person, that heads for -Z.
scene::SceneDescription with_a_cart() {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("chassis", {1.4_r, 0.3_r, 3}, {0, 0.5_r, -2.8_r}, physics::BodyKind::Dynamic, 400));
    for (scene::EntityDescription& entity : scene.entities) entity.body->friction = 0.9_r;
    scene::VehicleDescription cart{.name = "cart", .body = "chassis"};
    for (const Real x : {-0.8_r, 0.8_r}) {
        for (const Real z : {-1.2_r, 1.2_r})
            cart.wheels.push_back({.position_m = {x, -0.15_r, z}, .steers = z<0, .drives = z> 0});
    }
    cart.controls.brake = 1;
    scene.forces.vehicles = {cart};
    return scene;
}

/// With the effects that turn wheels.
class DrivenPlayground : public Playground {
public:
    DrivenPlayground() : Playground(with_a_cart()), effects_(*simulation, {}) {}

    void drive(double seconds, const Actions& actions = {}) {
        const auto count = static_cast<int>(seconds / simulation->step_s() + 0.5);
        for (int i = 0; i < count; ++i) effects::advance(*simulation, effects_, *game, actions);
    }
    void get_on() {
        drive(0.1, look(0, -0.07F));
        drive(1.0 / 60, press({Action::Use}));
        drive(0.5);
    }
    std::string words() { return game->hud(*simulation).use; }
    /// The person's place on the cart.
    Vec3 on_cart() { return transform_point(invert(state("chassis").world_from_body), feet()); }

private:
    effects::EffectRuntime effects_;
};

TEST(Drive, OneSitsOnItDrivesBrakesAndGetsOff) {
    DrivenPlayground play;
    play.drive(0.1, look(0, -0.07F));
    EXPECT_EQ(play.words(), "drive");
    play.drive(0.02, press({Action::Use}));
    play.drive(0.5);
    EXPECT_EQ(play.words(), "get off");
    EXPECT_TRUE(play.game->player()->sits());
    const Vec3 seat = play.on_cart();
    EXPECT_NEAR(seat.y, 0.15, 0.03);

    play.drive(3, hold({Action::Forward}));
    EXPECT_TRUE(play.game->player()->sits());
    EXPECT_LT(play.state("chassis").velocity_mps.z, -3);
    EXPECT_LT(glm::distance(play.on_cart(), seat), 0.1_r) << "one rides along";

    play.drive(2, hold({Action::Back}));
    EXPECT_GT(play.state("chassis").velocity_mps.z, 1) << "it brakes, then it backs";
    play.drive(0.02, press({Action::Use}));
    play.drive(1);
    EXPECT_FALSE(play.game->player()->sits());
    EXPECT_EQ(play.simulation->vehicles()[0].controls.brake, 1);
    EXPECT_LT(glm::length(play.state("chassis").velocity_mps), 0.1_r) << "it is parked";
}

TEST(Drive, TheCartTurnsWhereItIsSteered) {
    for (const auto& [key, side] : {std::pair{Action::Left, 1.0_r}, {Action::Right, -1.0_r}}) {
        DrivenPlayground play;
        play.get_on();
        play.drive(2, hold({Action::Forward, key}));
        const Vec3 forward = play.state("chassis").world_from_body.orientation * Vec3{0, 0, -1};
        EXPECT_LT(side * forward.x, -0.3_r);
        EXPECT_TRUE(play.game->player()->sits());
    }
}

TEST(Drive, LeftAloneItRollsOutAndStands) {
    DrivenPlayground play;
    play.get_on();
    play.drive(1, hold({Action::Forward}));
    play.drive(1, hold({Action::Jump}));
    EXPECT_LT(glm::length(play.state("chassis").velocity_mps), 0.1_r) << "locked";
    play.drive(0.02, press({Action::Jump}));
    EXPECT_TRUE(play.game->player()->sits()) << "jumping is the brake";
}

TEST(Drive, NobodyDrivesWhatLiesOnItsSideOrIsGone) {
    DrivenPlayground play;
    play.get_on();
    play.simulation->registry.destroy(play.simulation->find("chassis"));
    play.drive(0.5, hold({Action::Forward}));
    EXPECT_NE(play.words(), "get off");

    DrivenPlayground turned;
    Pose pose = turned.state("chassis").world_from_body;
    pose.orientation = portable_angle_axis(kPi / 2, Vec3{0, 0, 1});
    turned.simulation->physics.set_pose(turned.body("chassis"), pose);
    EXPECT_FALSE(driver_seat_at(
        *turned.simulation,
        {.entity = turned.simulation->find("chassis"), .body = turned.body("chassis")},
        turned.game->player()->body()));
}

}  // namespace
}  // namespace plumbline::game
