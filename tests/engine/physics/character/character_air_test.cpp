// PHYSICS.md C01, C02: jumping and falling.
#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

class CharacterInAir : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, CharacterInAir, ::testing::Values(30, 60, 120, 240));

TEST_P(CharacterInAir, FallsAsGalileoSays) {
    Stage stage(GetParam());
    stage.ground();
    stage.enter({0, 5, 0});
    const double landing_s = std::sqrt(2 * 5.0 / kG);
    for (int i = 1; stage.seconds(i) < landing_s; ++i) {
        const double t = stage.seconds(i);
        ASSERT_NEAR(stage.step().feet_position_m.y, 5 - 0.5 * kG * t * t, 1e-4) << "at " << t;
        ASSERT_EQ(stage.person->state().footing, Footing::Air);
    }
    const CharacterState& landed = stage.step();
    EXPECT_EQ(landed.footing, Footing::Ground);
    EXPECT_NEAR(landed.feet_position_m.y, 0, 1e-4);
    EXPECT_NEAR(landed.landing_speed_mps, std::sqrt(2 * kG * 5), kG * stage.seconds(1));
    EXPECT_EQ(stage.step().landing_speed_mps, 0);
}

TEST_P(CharacterInAir, JumpsAsHighAtEveryRate) {
    Stage stage(GetParam());
    stage.ground();
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    ASSERT_EQ(stage.person->state().footing, Footing::Ground);
    const double start_mps = std::sqrt(2 * kG * 1.0);
    Real apex = 0;
    stage.step({.jump = true});
    for (int i = 1; stage.seconds(i) < 0.85; ++i) {
        const double t = stage.seconds(i);
        ASSERT_NEAR(stage.feet().y, start_mps * t - 0.5 * kG * t * t, 1e-4);
        apex = std::max(apex, stage.feet().y);
        stage.step();
    }
    EXPECT_NEAR(apex, 1.0, 0.01);
    stage.rest(0.2_r);
    EXPECT_EQ(stage.person->state().footing, Footing::Ground);
    EXPECT_NEAR(stage.feet().y, 0, 1e-4);
}

TEST(Character, JumpsOnceAPress) {
    Stage stage;
    stage.ground();
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    stage.step({.jump = true});
    stage.rest(0.2_r);
    const Real rising = stage.person->state().velocity_mps.y;
    stage.step({.jump = true});
    EXPECT_LT(stage.person->state().velocity_mps.y, rising) << "no second jump in the air";
}

TEST_P(CharacterInAir, CeilingsStopAJump) {
    Stage stage(GetParam());
    stage.ground();
    stage.wall({10, 1, 10}, {0, 2.2_r + 0.5_r, 0});
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    stage.step({.jump = true});
    Real highest = 0;
    int airborne = 0;
    for (; stage.person->state().footing != Footing::Ground && airborne < 1000; ++airborne) {
        highest = std::max(highest, stage.feet().y + 1.8_r);
        ASSERT_LT(stage.depth(), 1e-3);
        stage.step({.direction_world = kForward});
    }
    EXPECT_NEAR(highest, 2.2, 1e-3);
    // Up 0.4 m at 4.43 m/s, then 0.4 m of free fall.
    EXPECT_NEAR(stage.seconds(airborne), 0.102 + 0.286, stage.seconds(2));
}

}  // namespace
}  // namespace plumbline::physics
