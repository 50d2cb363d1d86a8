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

}  // namespace
}  // namespace plumbline::game
