// Holding things: still, never through walls, never beyond a person's strength.
#include "tests/game/rules/playground.h"

namespace plumbline::game {
namespace {

/// A box of 0.4 m on a table, level with the eye, 2 m ahead.
scene::SceneDescription table(Real mass_kg) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(block("table", {1, 1.4_r, 1}, {0, 0.7_r, -2}));
    scene.entities.push_back(
        block("box", {0.4_r, 0.4_r, 0.4_r}, {0, 1.6_r, -2}, physics::BodyKind::Dynamic, mass_kg));
    return scene;
}

Vec3 place(const Playground& play) {
    return play.state("box").world_from_body.position;
}

class GrabAtRate : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, GrabAtRate, ::testing::Values(30, 60, 240));

TEST_P(GrabAtRate, HoldsStillAndCarriesAlong) {
    Playground play(table(5), GetParam());
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->grab().holding());
    // Up, off the table, then still.
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.3F;
    play.step(up);
    play.run(1, hold({Action::Grab}));
    const Vec3 there = place(play);
    double squares = 0;
    const int count = GetParam();
    for (int i = 0; i < count; ++i) {
        play.step(hold({Action::Grab}));
        const double off = glm::distance(Vec3d(place(play)), Vec3d(there));
        squares += off * off;
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 1e-3);
    // Where the eye looks, at the distance at which it was taken.
    const auto view = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    const Vec3 held = transform_point(invert(view.world_from_camera), place(play));
    EXPECT_NEAR(held.x, 0, 2e-3);
    EXPECT_NEAR(held.y, 0, 2e-3);
    EXPECT_NEAR(held.z, -2, 0.02);
    // Carried backwards at walking pace it stays there.
    play.run(2, hold({Action::Grab, Action::Back}));
    const auto walked = play.game->view(*play.simulation, 1, 0.0F, 0.0F);
    const Vec3 carried = transform_point(invert(walked.world_from_camera), place(play));
    EXPECT_LT(glm::distance(carried, held), 0.01);
}

TEST_P(GrabAtRate, DoesNotPassAWall) {
    scene::SceneDescription scene = table(5);
    scene.entities.push_back(block("wall", {4, 6, 0.2_r}, {-3.6_r, 3, -2}));
    Playground play(scene, GetParam());
    play.step(press({Action::Grab}));
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.2F;
    play.step(up);
    play.run(0.5, hold({Action::Grab}));
    // Turned left, behind the wall's face, and pushed away as far as it goes.
    Actions turn = hold({Action::Grab});
    turn.look_yaw_rad = static_cast<float>(0.9 / GetParam());
    play.run(1, turn);
    for (int i = 0; i < 3 * GetParam(); ++i) {
        play.step(hold({Action::Grab, Action::Push}));
        ASSERT_GT(place(play).z, -1.72_r) << "the wall's face is at -1.9, half the box 0.2";
    }
    EXPECT_LT(place(play).x, -1.8) << "it did come to the wall";
}

TEST(Grab, RefusesWhatIsTooHeavyOrDoesNotMove) {
    Playground heavy(table(10000));
    heavy.step(press({Action::Grab}));
    EXPECT_FALSE(heavy.game->grab().holding());
    EXPECT_EQ(heavy.messages(), std::vector<std::string>{"too heavy to lift"});

    Playground fixed(table(5));
    fixed.step(look(0.0F, -0.3F));
    fixed.step(press({Action::Grab}));
    EXPECT_FALSE(fixed.game->grab().holding());
    EXPECT_EQ(fixed.messages(), std::vector<std::string>{"this object is fixed"});

    Playground nothing;
    nothing.step(press({Action::Grab}));
    EXPECT_EQ(nothing.messages(), std::vector<std::string>{"nothing within reach"});
}

TEST(Grab, LetsGoWithTheKeyAndWhenTheThingIsGone) {
    Playground play(table(5));
    play.step(press({Action::Grab}));
    EXPECT_TRUE(play.simulation->registry.has<Held>(play.simulation->find("box")));
    play.step();
    EXPECT_FALSE(play.game->grab().holding());
    EXPECT_FALSE(play.simulation->registry.has<Held>(play.simulation->find("box")));

    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->grab().holding());
    destroy(*play.simulation, play.simulation->find("box"));
    play.run(0.5, hold({Action::Grab}));
    EXPECT_FALSE(play.game->grab().holding());
}

TEST(Grab, ThrowsWhatItHolds) {
    Playground play(table(5));
    play.step(press({Action::Grab}));
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.3F;
    play.step(up);
    play.run(1, hold({Action::Grab}));
    Actions tap = hold({Action::Grab});
    tap.pressed[static_cast<std::size_t>(Action::Throw)] = 1;
    play.step(tap);
    EXPECT_FALSE(play.game->grab().holding());
    EXPECT_NEAR(glm::length(play.state("box").velocity_mps), 5, 0.2);
    EXPECT_EQ(play.thing_count(), 0U) << "nothing new was thrown";
}

TEST(Grab, NobodyLiftsWhatHeStandsOn) {
    scene::SceneDescription scene = meadow();
    scene.entities.push_back(
        block("box", {1.2_r, 0.4_r, 1.2_r}, {0, 0.2_r, 0}, physics::BodyKind::Dynamic, 20));
    scene.player->feet_position_m = {0, 0.41_r, 0};
    Playground play(scene);
    play.step(look(0.0F, -1.4F));
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->grab().holding());
    Real highest = 0;
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.01F;
    for (int i = 0; i < 180; ++i) {
        play.step(up);
        highest = std::max(highest, play.feet().y);
    }
    EXPECT_LT(highest, 0.5) << "no flying";
}

TEST(Grab, FreezesAndFreesWhatIsHeldOrLookedAt) {
    Playground play(table(5));
    play.step(press({Action::Grab}));
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.2F;
    play.step(up);
    play.run(1, hold({Action::Grab}));
    play.step(press({Action::Freeze}));
    EXPECT_FALSE(play.game->grab().holding());
    const Vec3 there = place(play);
    play.run(1);
    EXPECT_EQ(place(play), there) << "hangs in the air";
    play.step(press({Action::Freeze}));
    play.run(1);
    EXPECT_LT(place(play).y, there.y - 0.2_r) << "falls again";
}

/// A tray of 14 kg on a wheel in front and two legs behind, its handle towards the person, with a load of 20 kg.
scene::SceneDescription barrow() {
    scene::SceneDescription scene = meadow();
    scene::EntityDescription tray = block("tray", {0.5_r, 0.05_r, 1.4_r}, {0, 0.4_r, -2});
    tray.body->kind = physics::BodyKind::Dynamic;
    tray.body->mass_kg = 14;
    physics::CompoundShape parts;
    parts.children.push_back({.shape = physics::BoxShape{{0.5_r, 0.05_r, 1.4_r}}});
    for (const Real x : {-0.2_r, 0.2_r})
        parts.children.push_back({.shape = physics::BoxShape{{0.04_r, 0.36_r, 0.04_r}},
                                  .body_from_child = {.position = {x, -0.2_r, 0.3_r}}});
    const auto add_rim = [&](const Vec3& size_m, const Vec3& at_m) {
        parts.children.push_back(
            {.shape = physics::BoxShape{size_m}, .body_from_child = {.position = at_m}});
    };
    for (const Real side : {-1.0_r, 1.0_r}) {
        add_rim({0.04_r, 0.15_r, 0.5_r}, {side * 0.23_r, 0.1_r, -0.4_r});
        add_rim({0.5_r, 0.15_r, 0.04_r}, {0, 0.1_r, -0.4_r + side * 0.25_r});
    }
    tray.body->shape = physics::ShapeDef{parts};
    scene.entities.push_back(tray);
    scene::EntityDescription wheel =
        block("wheel", {0.1_r, 0.1_r, 0.1_r}, {0, 0.2_r, -2.6_r}, physics::BodyKind::Dynamic, 1);
    wheel.visual = scene::Primitive{physics::CylinderShape{.radius_m = 0.2_r, .height_m = 0.07_r}};
    wheel.world_from_body.orientation = portable_angle_axis(kPi / 2, Vec3{0, 0, 1});
    scene.entities.push_back(wheel);
    scene.joints.push_back({.name = "axle",
                            .kind = physics::JointKind::Hinge,
                            .a = "wheel",
                            .b = "tray",
                            .anchor_a_m = {0, 0.2_r, -2.6_r},
                            .axis = {1, 0, 0}});
    scene.entities.push_back(
        block("load", {0.3_r, 0.3_r, 0.3_r}, {0, 0.58_r, -2.4_r}, physics::BodyKind::Dynamic, 20));
    return scene;
}

TEST(Grab, AWheelbarrowIsLiftedByItsHandleAndPushed) {
    Playground play(barrow());
    const Vec3 rest = play.state("tray").world_from_body.position;
    play.step(look(0.1F, -0.73F));  // a little to the left of the handle's middle
    play.step(press({Action::Grab}));
    ASSERT_TRUE(play.game->grab().holding());
    Actions up = hold({Action::Grab});
    up.look_pitch_rad = 0.15F;
    play.step(up);
    play.run(1, hold({Action::Grab}));
    const auto height_m = [&](Real z) {
        return transform_point(play.state("tray").world_from_body, {0, 0, z}).y;
    };
    EXPECT_GT(height_m(0.7_r), rest.y + 0.08_r) << "its legs are off the ground";
    EXPECT_NEAR(play.state("wheel").world_from_body.position.y, 0.2_r, 0.01_r);
    play.run(3, hold({Action::Grab, Action::Forward}));
    const Vec3 there = play.state("tray").world_from_body.position;
    EXPECT_LT(there.z, rest.z - 3) << "it rolls ahead";
    EXPECT_NEAR(play.state("wheel").world_from_body.position.y, 0.2_r, 0.02_r);
    const Vec3 side = play.state("tray").world_from_body.orientation * Vec3{1, 0, 0};
    EXPECT_NEAR(side.y, 0, 0.12) << "and does not tip over";
    const Vec3 load = transform_point(invert(play.state("tray").world_from_body),
                                      play.state("load").world_from_body.position);
    EXPECT_LT(std::abs(load.x), 0.25_r) << "its load is in it";
    EXPECT_LT(std::abs(load.z), 0.7_r);
    play.run(1);
    EXPECT_NEAR(height_m(0.3_r), rest.y, 0.03_r) << "let go, it stands on its legs";
}

}  // namespace
}  // namespace plumbline::game
