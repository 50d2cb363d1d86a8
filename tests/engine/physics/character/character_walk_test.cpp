// PHYSICS.md C01–C05, C07, C10, C12: a person alone with floors, stairs, slopes and walls.
#include "tests/engine/physics/character/character_stage.h"

#include <array>

namespace plumbline::physics {
namespace {

class CharacterWalking : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Rates, CharacterWalking, ::testing::Values(30, 60, 120, 240));

TEST_P(CharacterWalking, WalksAtItsSpeed) {
    Stage stage(GetParam());
    stage.ground();
    stage.enter({0, 0, 0});
    stage.rest(0.2_r);
    stage.walk(3);
    // The first 45 ms go into getting up to speed.
    // In the step that ends it, speed is taken to rise evenly: up to a h^2 / 8 less way.
    const double even_m = 40 * static_cast<double>(stage.dt * stage.dt) / 8;
    EXPECT_NEAR(stage.feet().z, -(1.8 * 3 - 1.8 * 1.8 / 80), 1e-4 + even_m);
    EXPECT_EQ(stage.feet().x, 0);
    const Real stopped = stage.rest(0.5_r).feet_position_m.z;
    stage.rest(2);
    EXPECT_EQ(stage.feet().z, stopped) << "rest is rest, to the last bit";
}

/// A slope about the x axis, rising towards -z, through the origin.
struct Slope : Stage {
    Slope(Real angle_deg, int hz) : Stage(hz), turn(tilt(angle_deg, {1, 0, 0})) {
        normal = turn * Vec3{0, 1, 0};
        wall({20, 1, 200}, -normal * 0.5_r, turn);
    }
    /// Of the round foot from the slope.
    Real gap() const { return glm::dot(feet() + Vec3{0, kRadius, 0}, normal) - kRadius; }
    Vec3 standing_at(Real z) const {
        // The foot's middle is one radius above the slope.
        const Real y = (kRadius - normal.z * z) / normal.y - kRadius;
        return {0, y, z};
    }
    Quat turn;
    Vec3 normal{};
};

class CharacterOnSlope : public ::testing::TestWithParam<std::tuple<Real, int>> {};
INSTANTIATE_TEST_SUITE_P(
    Walkable,
    CharacterOnSlope,
    ::testing::Combine(::testing::Values(0.0_r, 15.0_r, 30.0_r, 40.0_r, 44.5_r),
                       ::testing::Values(30, 60, 240)));

TEST_P(CharacterOnSlope, WalksUpDownAndAcrossWithoutBobbing) {
    const auto [angle_deg, hz] = GetParam();
    Slope stage(angle_deg, hz);
    stage.enter(stage.standing_at(0));
    stage.rest(0.5_r);
    ASSERT_EQ(stage.person->state().footing, Footing::Ground);
    for (const Vec3& way : {kForward, -kForward, kRight, Vec3{0.6_r, 0, 0.8_r}}) {
        stage.walk(0.2_r, way);
        const Vec3 start = stage.feet();
        for (int i = 0; i < stage.steps_in(1); ++i) {
            const CharacterState& state = stage.step({.direction_world = way});
            ASSERT_EQ(state.footing, Footing::Ground);
            ASSERT_NEAR(stage.gap(), 0, 1e-3);
        }
        EXPECT_NEAR(glm::distance(stage.feet(), start), 1.8, 0.02) << "the pace along the slope";
    }
}

TEST_P(CharacterOnSlope, RestsWithoutCreeping) {
    const auto [angle_deg, hz] = GetParam();
    Slope stage(angle_deg, hz);
    stage.enter(stage.standing_at(0));
    stage.rest(0.5_r);
    const Vec3 start = stage.feet();
    stage.rest(5);
    EXPECT_EQ(stage.feet(), start);
}

class CharacterOnSteepSlope : public ::testing::TestWithParam<std::tuple<Real, int>> {};
INSTANTIATE_TEST_SUITE_P(Steep,
                         CharacterOnSteepSlope,
                         ::testing::Combine(::testing::Values(45.5_r, 50.0_r, 60.0_r),
                                            ::testing::Values(30, 60, 240)));

TEST_P(CharacterOnSteepSlope, SlidesAsWithoutFriction) {
    const auto [angle_deg, hz] = GetParam();
    Slope stage(angle_deg, hz);
    stage.enter(stage.standing_at(0));
    const Vec3 start = stage.feet();
    stage.rest(1);
    const double sine = std::sin(radians_from_degrees(static_cast<double>(angle_deg)));
    EXPECT_NEAR(glm::distance(stage.feet(), start), 0.5 * kG * sine, 0.02);
    EXPECT_EQ(stage.person->state().footing, Footing::SteepSlope);
    EXPECT_NEAR(stage.gap(), 0, 2e-3);
}

TEST_P(CharacterOnSteepSlope, CannotBeWalkedUp) {
    const auto [angle_deg, hz] = GetParam();
    Slope stage(angle_deg, hz);
    stage.ground();
    const Vec3 foot_of_slope = stage.standing_at(1);
    stage.enter({0, 0, std::max(foot_of_slope.z, 1.0_r) + 1});
    stage.rest(0.3_r);
    Real highest = 0;
    for (int i = 0; i < stage.steps_in(3); ++i) {
        stage.step({.direction_world = kForward, .run = true});
        highest = std::max(highest, stage.feet().y);
        ASSERT_LT(stage.depth(), 1e-3);
    }
    EXPECT_LT(highest, 0.02);
}

struct Stairs : Stage {
    /// Six steps of 0.3 m from z = 0 towards -z, then a landing.
    Stairs(Real height, int hz) : Stage(hz) {
        ground();
        for (int i = 0; i < 6; ++i) {
            const Real top = height * static_cast<Real>(i + 1);
            const Real length = i == 5 ? 20.0_r : 0.3_r;
            wall({4, top, length}, {0, top / 2, -0.3_r * static_cast<Real>(i) - length / 2});
        }
    }
};

class CharacterOnStairs : public ::testing::TestWithParam<std::tuple<Real, Real, int>> {};
INSTANTIATE_TEST_SUITE_P(Steps,
                         CharacterOnStairs,
                         ::testing::Combine(::testing::Values(0.1_r, 0.2_r, 0.3_r, 0.35_r),
                                            ::testing::Values(1.0_r, 2.5_r, 4.5_r, 6.0_r),
                                            ::testing::Values(30, 60, 120, 240)));

TEST_P(CharacterOnStairs, ClimbsAndDescendsAtItsPace) {
    const auto [height, speed, hz] = GetParam();
    Stairs stage(height, hz);
    CharacterDef def;
    def.walk_speed_mps = speed;
    stage.enter({0, 0, 1.5_r}, def);
    stage.rest(0.2_r);
    // From a run-up to well past the last step: 4.4 m, then back down.
    for (const Real direction : {-1.0_r, 1.0_r}) {
        stage.walk(0.3_r / speed + 0.15_r, {0, 0, direction});
        const Real start = stage.feet().z;
        const Real seconds = 3.2_r / speed;
        for (int i = 0; i < stage.steps_in(seconds); ++i) {
            const CharacterState& state = stage.step({.direction_world = {0, 0, direction}});
            ASSERT_EQ(state.footing, Footing::Ground) << "at z " << stage.feet().z;
            ASSERT_LT(stage.depth(), 1e-3) << "at z " << stage.feet().z;
        }
        const Real expected = speed * static_cast<Real>(stage.steps_in(seconds)) * stage.dt;
        EXPECT_NEAR(std::abs(stage.feet().z - start) / expected, 1, 0.05);
        if (direction < 0) {
            stage.walk(0.3_r / speed, {0, 0, direction});
            EXPECT_NEAR(stage.feet().y, 6 * height, 1e-3);
            stage.rest(0.5_r);
        }
    }
}

TEST_P(CharacterWalking, RefusesStepsThatAreTooHigh) {
    for (const Real speed : {1.0_r, 4.5_r, 6.0_r}) {
        Stairs stage(0.40_r, GetParam());
        CharacterDef def;
        def.walk_speed_mps = speed;
        stage.enter({0, 0, 1.5_r}, def);
        stage.walk(3);
        EXPECT_NEAR(stage.feet().y, 0, 1e-3);
        EXPECT_NEAR(stage.feet().z, kRadius, 2e-3);
    }
}

TEST_P(CharacterWalking, KeepsTheEyeSmoothOnStairs) {
    Stairs stage(0.18_r, GetParam());
    stage.enter({0, 0, 1.0_r});
    stage.rest(0.3_r);
    Real eye = stage.person->state().eye_position_m.y;
    Real feet_y = stage.feet().y;
    Real largest_eye = 0;
    Real largest_feet = 0;
    for (int i = 0; i < stage.steps_in(2); ++i) {
        const CharacterState& state = stage.step({.direction_world = kForward});
        largest_eye = std::max(largest_eye, std::abs(state.eye_position_m.y - eye));
        largest_feet = std::max(largest_feet, std::abs(state.feet_position_m.y - feet_y));
        eye = state.eye_position_m.y;
        feet_y = state.feet_position_m.y;
    }
    EXPECT_NEAR(feet_y, 6 * 0.18, 1e-3);
    EXPECT_GT(largest_feet, 1.5_r * largest_eye) << "the feet do jump";
    EXPECT_GT(largest_feet, 2.3_r * stage.dt) << "the feet do jump";
    // Six steps of 0.18 m in 1 s rise at 1.1 m/s on average; the eye never faster than twice that.
    EXPECT_LT(largest_eye, 2.2 * stage.seconds(1) + 1e-3);
    stage.rest(1);
    EXPECT_NEAR(stage.person->state().eye_position_m.y - stage.feet().y, 1.65, 1e-3);
}

TEST_P(CharacterWalking, DoesNotDriftOnStairsAlongAWall) {
    Stairs stage(0.2_r, GetParam());
    stage.wall({1, 10, 40}, {0.5_r + kRadius, 5, 0});
    stage.enter({0, 0, 1.5_r});
    stage.rest(0.2_r);
    for (int i = 0; i < stage.steps_in(3); ++i) {
        stage.step({.direction_world = kForward});
        ASSERT_LT(std::abs(stage.feet().x), 0.01);
    }
    EXPECT_LT(stage.feet().z, -3.5);
}

TEST_P(CharacterWalking, SticksToTheFloorRunningDown) {
    Slope stage(30, GetParam());
    CharacterDef def;
    def.run_speed_mps = 5;
    stage.enter(stage.standing_at(-20), def);
    stage.rest(0.3_r);
    for (int i = 0; i < stage.steps_in(4); ++i) {
        const CharacterState& state = stage.step({.direction_world = -kForward, .run = true});
        ASSERT_EQ(state.footing, Footing::Ground) << "step " << i;
    }
    EXPECT_GT(stage.feet().z, -20 + 4.9_r * 4 * std::cos(radians_from_degrees(30.0_r)) - 0.5_r);
}

TEST_P(CharacterWalking, FeelsNoSeamsInAMeshFloor) {
    Stage stage(GetParam());
    stage.world.create_body({.shape = stage.shape(flat_mesh(110, 1))});
    CharacterDef def;
    def.run_speed_mps = 5;
    stage.enter({0.37_r, 0, 50}, def);
    stage.rest(0.2_r);
    for (int i = 0; i < stage.steps_in(20); ++i) {
        const CharacterState& state = stage.step({.direction_world = kForward, .run = true});
        ASSERT_EQ(state.footing, Footing::Ground) << "at z " << stage.feet().z;
        ASSERT_NEAR(stage.feet().x, 0.37, 1e-3);
        ASSERT_NEAR(stage.feet().y, 0, 1e-3);
    }
    EXPECT_NEAR(stage.feet().z, 50 - 100, 0.5);
}

TEST_P(CharacterWalking, RefusesANarrowGapCleanly) {
    for (const Real gap : {0.3_r, 0.5_r, 0.57_r, 0.59_r}) {
        Stage stage(GetParam());
        stage.ground();
        stage.wall({2, 3, 1}, {-1 - gap / 2, 1.5_r, 0});
        stage.wall({2, 3, 1}, {1 + gap / 2, 1.5_r, 0});
        stage.enter({0.02_r, 0, 2});
        stage.walk(3);
        const Vec3 there = stage.feet();
        for (int i = 0; i < stage.steps_in(2); ++i) {
            stage.step({.direction_world = kForward});
            ASSERT_LT(stage.depth(), 2e-2) << "gap " << gap;
            ASSERT_LT(glm::distance(stage.feet(), there), 1e-3) << "gap " << gap;
        }
        EXPECT_GT(there.z, 0.3) << "not let in: gap " << gap;
    }
}

TEST_P(CharacterWalking, RefusesAStepUnderALowCeilingCleanly) {
    Stage stage(GetParam());
    stage.ground();
    stage.wall({4, 0.3_r, 4}, {0, 0.15_r, -2});
    stage.wall({4, 1, 4}, {0, 1.95_r + 0.5_r, -2});
    stage.enter({0, 0, 1.5_r});
    stage.walk(2);
    EXPECT_NEAR(stage.feet().y, 0, 1e-3);
    EXPECT_NEAR(stage.feet().z, kRadius, 2e-3);
    const Vec3 there = stage.feet();
    stage.walk(1);
    EXPECT_LT(glm::distance(stage.feet(), there), 1e-3);
    // Crouched it fits.
    for (int i = 0; i < stage.steps_in(2); ++i) {
        stage.step({.direction_world = kForward, .crouch = true});
    }
    EXPECT_NEAR(stage.feet().y, 0.3, 1e-3);
    EXPECT_LT(stage.feet().z, -0.5);
    // And does not stand up into the ceiling.
    EXPECT_TRUE(stage.rest(0.5_r).crouched);
}

}  // namespace
}  // namespace plumbline::physics
