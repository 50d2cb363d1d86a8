// PHYSICS.md C08: a person in corners.
#include "tests/engine/physics/character/character_stage.h"

namespace plumbline::physics {
namespace {

class CharacterInCorner : public ::testing::TestWithParam<std::tuple<int, int>> {};
INSTANTIATE_TEST_SUITE_P(Angles,
                         CharacterInCorner,
                         ::testing::Combine(::testing::Values(30, 60, 90, 120, 150),
                                            ::testing::Values(30, 60, 240)));

/// Two walls that meet at the origin and leave `angle_deg` of room around the way to +z.
void build_corner(Stage& stage, Real angle_deg) {
    for (const Real side : {-1.0_r, 1.0_r}) {
        const Quat turn = tilt(side * angle_deg / 2, {0, 1, 0});
        // The wall's inner face runs along the turned +z axis.
        const Vec3 middle = turn * Vec3{side * 0.5_r, 1.5_r, 5};
        stage.wall({1, 3, 12}, middle, turn);
    }
}

TEST_P(CharacterInCorner, StaysQuietInAnInnerCorner) {
    const auto [angle_deg, hz] = GetParam();
    Stage stage(hz);
    stage.ground();
    build_corner(stage, static_cast<Real>(angle_deg));
    stage.enter({0.1_r, 0, 4});
    for (const Vec3& way : {kForward, Vec3{0.2_r, 0, -0.98_r}, Vec3{-0.2_r, 0, -0.98_r}}) {
        for (int i = 0; i < stage.steps_in(4); ++i) {
            stage.step({.direction_world = way, .run = true});
            ASSERT_LT(stage.depth(), 1e-3);
        }
        const Vec3 there = stage.feet();
        for (int i = 0; i < stage.steps_in(6); ++i) {
            stage.step({.direction_world = way, .run = true});
            ASSERT_LT(stage.depth(), 1e-3);
            ASSERT_LT(glm::distance(stage.feet(), there), 1e-3);
        }
    }
}

TEST_P(CharacterInCorner, PassesAnOuterCorner) {
    const auto [angle_deg, hz] = GetParam();
    Stage stage(hz);
    stage.ground();
    // A wedge with its edge towards the walker.
    const Real half = radians_from_degrees(static_cast<Real>(angle_deg)) / 2;
    const Real depth = 2;
    const Real wide = depth * std::tan(half);
    HullShape wedge;
    for (const Real y : {0.0_r, 3.0_r}) {
        wedge.points_m.insert(wedge.points_m.end(),
                              {{0, y, 0}, {wide, y, -depth}, {-wide, y, -depth}});
    }
    stage.world.create_body({.shape = stage.shape(wedge)});
    stage.enter({0.05_r, 0, 2});
    Real largest_step = 0;
    for (int i = 0; i < stage.steps_in(4); ++i) {
        const Vec3 before = stage.feet();
        stage.step({.direction_world = kForward, .run = true});
        largest_step = std::max(largest_step, glm::distance(stage.feet(), before));
        ASSERT_LT(stage.depth(), 1e-3);
    }
    EXPECT_LE(largest_step, 4.5_r * stage.dt * 1.02_r) << "nothing throws it about";
    // Slid along the right side: the farther, the sharper the wedge.
    EXPECT_GT(stage.feet().x, 0.3);
}

}  // namespace
}  // namespace plumbline::physics
