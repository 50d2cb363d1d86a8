// PHYSICS.md C06, C09, C11, C13, C14: a person among moving things, far away.
#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

class CharacterAmongAtRate : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, CharacterAmongAtRate, ::testing::Values(30, 60, 120, 240));

// --- C09, H13

TEST_P(CharacterAmongAtRate, ComesOutOfAWallItStartsIn) {
    Stage stage(GetParam());
    stage.ground();
    const BodyId slab =
        stage.add(BoxShape{{2, 3, 2}}, {5, 1.5_r, 0}, {.kind = BodyKind::Kinematic});
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    // The wall is put where the person stands: 10 cm deep.
    stage.world.set_pose(slab, {.position = {1 + kRadius - 0.1_r, 1.5_r, 0}});
    int steps = 0;
    Real fastest = 0;
    while (stage.depth() > 1e-3_r && steps < 1000) {
        const Vec3 before = stage.feet();
        stage.step();
        fastest = std::max(fastest, glm::distance(stage.feet(), before) / stage.dt);
        ++steps;
    }
    EXPECT_LT(stage.seconds(steps), 0.5);
    // Out at 2.5 m/s, and what is then left of two skins at once: 6 mm at 240 Hz.
    EXPECT_LT(fastest, GetParam() == 240 ? 4.05 : 3.5);
    stage.rest(0.5_r);
    EXPECT_NEAR(stage.feet().x, -0.1, 2e-3);
    EXPECT_NEAR(stage.feet().y, 0, 1e-3);
    EXPECT_EQ(stage.person->state().velocity_mps, Vec3(0));
}

TEST_P(CharacterAmongAtRate, IsPushedAlongByAMovingWall) {
    Stage stage(GetParam());
    stage.ground();
    Platform wall(stage, {1, 3, 4}, {-2, 1.5_r, 0});
    stage.enter({0, 0, 0});
    for (int i = 0; i < stage.steps_in(3); ++i) {
        Pose next = wall.pose;
        next.position.x += 2 * stage.dt;
        wall.step(next);
        if (i > 2) {
            ASSERT_LT(stage.depth(), 5e-3);
        }
    }
    EXPECT_NEAR(stage.feet().x, wall.pose.position.x + 0.5_r + kRadius, 5e-3);
    EXPECT_NEAR(stage.feet().y, 0, 1e-3);
}

TEST_P(CharacterAmongAtRate, GetsFreeFromAVice) {
    Stage stage(GetParam());
    stage.ground();
    stage.wall({1, 3, 4}, {1.5_r, 1.5_r, 0});
    Platform jaw(stage, {1, 3, 4}, {-2.5_r, 1.5_r, 0});
    stage.enter({0, 0, 0.5_r});
    for (int i = 0; i < stage.steps_in(6); ++i) {
        // Closes to 20 cm within 3 s, waits, opens again.
        const Real t = static_cast<Real>(i) * stage.dt;
        Pose next = jaw.pose;
        next.position.x = -2.5_r + std::min({t, 2.8_r, 7 - t}) * 1.0_r;
        const CharacterState& state = jaw.step(next);
        ASSERT_TRUE(is_finite(state.feet_position_m));
        ASSERT_TRUE(is_finite(state.eye_position_m));
        ASSERT_GT(state.feet_position_m.y, -1e-3);
        ASSERT_LT(glm::length(state.feet_position_m), 10);
    }
    stage.rest(1);
    EXPECT_LT(stage.depth(), 2e-3);
    EXPECT_NEAR(stage.feet().y, 0, 1e-3);
}

TEST_P(CharacterAmongAtRate, SurvivesAPressFromAbove) {
    Stage stage(GetParam());
    stage.ground();
    Platform press(stage, {1, 1, 1}, {0, 3, 0});
    stage.enter({0, 0, 0});
    for (int i = 0; i < stage.steps_in(6); ++i) {
        const Real t = static_cast<Real>(i) * stage.dt;
        Pose next = press.pose;
        next.position.y = std::max({3 - t, 1.3_r, 3 - (6 - t)});
        const CharacterState& state = press.step(next);
        ASSERT_TRUE(is_finite(state.feet_position_m));
        ASSERT_GT(state.feet_position_m.y, -1e-3);
    }
    EXPECT_NEAR(stage.rest(1).feet_position_m.y, 0, 1e-3);
    EXPECT_FALSE(stage.person->state().crouched);
}

TEST(CharacterStart, MovesUpOutOfTheGroundAndWalls) {
    Stage stage;
    stage.ground();
    stage.wall({2, 2, 2}, {0, 1, 0});
    stage.enter({0, 0, 0});
    EXPECT_NEAR(stage.feet().y, 2, 0.2) << "on top of the block it was put into";
    stage.person->teleport({8, -0.6_r, 0});
    EXPECT_GE(stage.feet().y, -1e-3);
    stage.person->teleport({8, -50, 0});
    EXPECT_GE(stage.feet().y, -1e-3);
    EXPECT_NEAR(stage.rest(1).feet_position_m.y, 0, 1e-3);
}

// Scenes that put a person at height 0 on paving, or in a room with a floor, mean the top of it.
TEST(CharacterStart, StandsOnPavingAndOnTheFloorOfARoomNotOnItsRoof) {
    Stage stage;
    stage.ground();
    stage.wall({4, 0.08_r, 4}, {0, 0.04_r, 0});
    stage.enter({0, 0, 0});
    EXPECT_NEAR(stage.feet().y, 0.08, 2e-3);
    stage.wall({4, 0.6_r, 4}, {20, 0.3_r, 0});
    stage.wall({4, 0.2_r, 4}, {20, 3.5_r, 0});
    stage.person->teleport({20, 0, 0});
    EXPECT_NEAR(stage.feet().y, 0.6, 0.11) << "in the room";
}

// A room that stands over a hole: nothing is below its floor.
TEST(CharacterStart, BelowAFloorWithNothingUnderItIsInTheRoom) {
    Stage stage;
    stage.wall({4, 0.6_r, 4}, {0, 0.3_r, 0});
    stage.wall({4, 0.2_r, 4}, {0, 3.5_r, 0});
    stage.enter({0, 0.1_r, 0});
    EXPECT_NEAR(stage.feet().y, 0.6, 0.11);
}

TEST_P(CharacterAmongAtRate, PushesTenKilogramsAndNotTenTonnes) {
    for (const Real mass : {10.0_r, 10000.0_r}) {
        Stage stage(GetParam());
        stage.ground();
        const BodyId box = stage.add(BoxShape{{0.8_r, 0.8_r, 0.8_r}},
                                     {0, 0.4_r, -1.5_r},
                                     {.kind = BodyKind::Dynamic, .mass_kg = mass});
        stage.enter({0, 0, 0});
        for (int i = 0; i < stage.steps_in(4); ++i) {
            stage.step({.direction_world = kForward});
            ASSERT_LT(stage.depth(), 0.02);
            ASSERT_LT(glm::length(stage.world.state(box).velocity_mps), 3) << "no kick";
        }
        if (mass < 100) {
            EXPECT_LT(stage.at(box).z, -4.5) << "pushed along at nearly walking pace";
            EXPECT_LT(stage.feet().z, -4);
        } else {
            EXPECT_NEAR(stage.at(box).z, -1.5, 2e-3);
            EXPECT_NEAR(stage.feet().z, -1.5_r + 0.4_r + kRadius, 0.01);
        }
        EXPECT_NEAR(stage.at(box).y, 0.4, 0.02);
    }
}

// FAULTS N31: 400 N did nothing to a stack that weighs 883 N, and friction at the bottom was all they met.
TEST_P(CharacterAmongAtRate, WalksThreeStackedCratesAwayOrOver) {
    for (const Real friction : {0.5_r, 0.63_r}) {
        Stage stage(GetParam());
        stage.world.create_body({.shape = stage.shape(BoxShape{{100, 1, 100}}),
                                 .world_from_body = {.position = {0, -0.5_r, 0}},
                                 .friction = friction});
        BodyId top{};
        for (int i = 0; i < 3; ++i)
            top = stage.add(BoxShape{{0.8_r, 0.8_r, 0.8_r}},
                            {0, 0.4_r + 0.8_r * static_cast<Real>(i), -1.2_r},
                            {.kind = BodyKind::Dynamic, .mass_kg = 30, .friction = friction});
        stage.enter({0, 0, 0});
        stage.walk(3);
        EXPECT_LT(stage.at(top).z, -2.2) << "friction " << friction;
    }
}

TEST_P(CharacterAmongAtRate, PushesAsHardAsTheSolesHold) {
    // 550 N against friction of half the weight: 112 kg are as much as moves.
    for (const Real mass_kg : {105.0_r, 120.0_r}) {
        Stage stage(GetParam());
        stage.ground();
        const BodyId box =
            stage.add(BoxShape{{0.8_r, 0.8_r, 0.8_r}},
                      {0, 0.4_r, -1.2_r},
                      {.kind = BodyKind::Dynamic, .mass_kg = mass_kg, .friction = 0.5_r});
        stage.enter({0, 0, 0});
        stage.walk(3);
        const double way_m = -1.2 - stage.at(box).z;
        const double a_mps2 = (550 - 0.5 * 9.81 * 105) / 105;
        if (mass_kg < 112) {
            EXPECT_NEAR(way_m, a_mps2 * 2.6 * 2.6 / 2, 0.4) << "from when it was reached";
        } else {
            EXPECT_LT(way_m, 0.1);
        }
    }
}

TEST_P(CharacterAmongAtRate, StandsAndWalksOnACrateWithoutShakingIt) {
    Stage stage(GetParam());
    stage.ground();
    const BodyId crate = stage.add(
        BoxShape{{2, 0.8_r, 2}}, {0, 0.4_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 60});
    stage.enter({-0.6_r, 0.8_r, 0});
    stage.rest(1);
    const Vec3d before = stage.at(crate);
    for (int i = 0; i < stage.steps_in(0.6_r); ++i) {
        ASSERT_EQ(stage.step({.direction_world = kRight}).footing, Footing::Ground);
    }
    stage.rest(1);
    EXPECT_LT(glm::distance(stage.at(crate), before), 0.01);
    EXPECT_NEAR(stage.feet().y, stage.at(crate).y + 0.4, 0.01);
}

TEST_P(CharacterAmongAtRate, CarriesABoxOnTheHeadWithoutKickingIt) {
    Stage stage(GetParam());
    stage.ground();
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    const BodyId box = stage.add(
        BoxShape{{1, 0.2_r, 1}}, {0, 1.91_r, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 5});
    for (int i = 0; i < stage.steps_in(3); ++i) {
        stage.step({.crouch = i > stage.steps_in(1)});
        ASSERT_LT(glm::length(stage.world.state(box).velocity_mps), 6);
        ASSERT_TRUE(is_finite(stage.feet()));
    }
    EXPECT_NEAR(stage.feet().y, 0, 1e-3);
}

TEST_P(CharacterAmongAtRate, TwoPeopleHeadOnDoNotOverlap) {
    Stage stage(GetParam());
    stage.ground();
    stage.enter({0, 0, 2});
    CharacterDef def;
    def.feet_position_m = {0, 0, -2};
    Character other(stage.world, def);
    for (int i = 0; i < stage.steps_in(4); ++i) {
        stage.person->update({.direction_world = kForward, .run = true});
        other.update({.direction_world = -kForward, .run = true});
        stage.world.step();
        const Real apart = glm::distance(stage.feet(), other.state().feet_position_m);
        ASSERT_GT(apart, 2 * kRadius - 1e-3_r);
    }
    EXPECT_NEAR(glm::distance(stage.feet(), other.state().feet_position_m), 2 * kRadius, 0.01);
    EXPECT_NEAR(stage.feet().z, 0.3, 0.05);
}

std::vector<Vec3> tour(Real offset, int hz) {
    Stage stage(hz);
    const Vec3 away{offset, 0, -offset};
    stage.wall({40, 1, 40}, away - Vec3{0, 0.5_r, 0});
    stage.wall({4, 0.25_r, 4}, away + Vec3{0, 0.125_r, -4});
    stage.wall({1, 3, 10}, away + Vec3{3, 1.5_r, 0});
    stage.add(BoxShape{{0.6_r, 0.6_r, 0.6_r}},
              away + Vec3{-2, 0.3_r, 0},
              {.kind = BodyKind::Dynamic, .mass_kg = 10});
    stage.enter(away);
    std::vector<Vec3> path;
    for (int i = 0; i < stage.steps_in(6); ++i) {
        const Real angle = static_cast<Real>(i) * stage.dt * 1.1_r;
        const CharacterState& state =
            stage.step({.direction_world = {-std::sin(angle), 0, -std::cos(angle)},
                        .run = i % 100 > 50,
                        .crouch = i % 150 > 120,
                        .jump = i % 90 == 40});
        path.push_back(state.feet_position_m - away);
        path.push_back(state.eye_position_m - away);
    }
    return path;
}

TEST_P(CharacterAmongAtRate, RepeatsToTheLastBit) {
    const auto first = tour(0, GetParam());
    EXPECT_EQ(first, tour(0, GetParam()));
    const auto far_away = tour(1e5_r, GetParam());
    EXPECT_EQ(far_away, tour(1e5_r, GetParam()));
    EXPECT_NE(first, far_away);
}

TEST_P(CharacterAmongAtRate, WalksFarFromTheOriginToo) {
    Stage stage(GetParam());
    const Vec3 away{1e5_r, 0, -1e5_r};
    stage.wall({40, 1, 40}, away - Vec3{0, 0.5_r, 0});
    stage.enter(away);
    stage.rest(0.5_r);
    for (int i = 0; i < stage.steps_in(3); ++i) {
        ASSERT_EQ(stage.step({.direction_world = kForward}).footing, Footing::Ground);
        ASSERT_NEAR(stage.feet().y, 0, 0.01);
    }
    // A float is 8 mm wide out there.
    EXPECT_NEAR(away.z - stage.feet().z, 5.36, sizeof(Real) == sizeof(float) ? 0.05 : 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
