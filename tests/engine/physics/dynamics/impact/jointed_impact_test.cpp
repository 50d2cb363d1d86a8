// Restitution of what joints hold together: it bounces as a whole.
#include "tests/engine/physics/joint_bench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::physics {
namespace {

WorldDef afloat() {
    WorldDef def{.substeps = 4, .substeps_max = 16, .iterations = 1, .solver = Solver::SmallStep};
    def.gravity_mps2 = {0, 0, 0};
    return def;
}

BodyDef bouncing(Real mass_kg, Real restitution, const Vec3& velocity_mps) {
    return {.kind = BodyKind::Dynamic,
            .mass_kg = mass_kg,
            .velocity_mps = velocity_mps,
            .friction = 0,
            .restitution = restitution,
            .can_sleep = false};
}

/// Two bodies a metre apart that a joint holds in the middle fly against a wall at x = 0.
struct Thrown {
    Thrown(JointKind kind, Real restitution, Real speed_mps, const Vec3& apart, Real back_kg = 1)
        : test(afloat()) {
        const Vec3 front_m = Vec3{2, 0, 0} - apart * 0.5_r;
        const Vec3 back_m = Vec3{2, 0, 0} + apart * 0.5_r;
        test.add(
            BoxShape{{1, 10, 10}}, {-0.5_r, 0, 0}, {.friction = 0, .restitution = restitution});
        front = test.add(SphereShape{0.1_r}, front_m, bouncing(1, restitution, {-speed_mps, 0, 0}));
        back = test.add(
            SphereShape{0.1_r}, back_m, bouncing(back_kg, restitution, {-speed_mps, 0, 0}));
        join(test,
             {.kind = kind,
              .a = front,
              .b = back,
              .anchor_a_world = {2, 0, 0},
              .anchor_b_world = {2, 0, 0},
              .axis_world = {1, 0, 0}});
    }
    TestWorld test;
    BodyId front{};
    BodyId back{};
};

TEST(JointedImpact, WhatIsHeldTogetherBouncesAsAWhole) {
    for (const JointKind kind : {JointKind::BallAndSocket, JointKind::Fixed, JointKind::Hinge}) {
        for (const Real restitution : {0.3_r, 1.0_r}) {
            for (const Real back_kg : {1.0_r, 100.0_r}) {
                Thrown pair(kind, restitution, 10, {1, 0, 0}, back_kg);
                pair.test.run(0.5);
                const double out_mps = 10 * static_cast<double>(restitution);
                // One after the other, the second would take what the first had back.
                EXPECT_NEAR(pair.test.velocity(pair.front).x, out_mps, 1e-3);
                EXPECT_NEAR(pair.test.velocity(pair.back).x, out_mps, 1e-3);
            }
        }
    }
}

TEST(JointedImpact, BothAtOnceBounceWithoutASpin) {
    Thrown pair(JointKind::Fixed, 1, 10, {0, 1, 0});
    pair.test.run(0.5);
    EXPECT_NEAR(pair.test.velocity(pair.front).x, 10, 1e-3);
    EXPECT_NEAR(pair.test.velocity(pair.back).x, 10, 1e-3);
}

// m v' = m v - J, I w' = J r, and the point that meets the wall leaves it as fast as it came.
TEST(JointedImpact, AnEndThatMeetsTheWallFirstTurnsTheRest) {
    Thrown pair(JointKind::Fixed, 1, 10, {0.6_r, 0.8_r, 0});
    const double energy_J = energy(pair.test.world).kinetic_J;
    pair.test.run(0.18);
    EXPECT_NEAR(energy(pair.test.world).kinetic_J / energy_J, 1, 1e-4);
    EXPECT_GT(glm::length(pair.test.spin(pair.front)), 5);
}

TEST(JointedImpact, ACradleOfFiveBallsKeepsItsSwing) {
    WorldDef def = afloat();
    def.gravity_mps2 = {0, -static_cast<Real>(kG), 0};
    TestWorld test(def);
    std::vector<BodyId> balls;
    for (int i = 0; i < 5; ++i) {
        const Vec3 hook{0.2_r * static_cast<Real>(i), 2, 0};
        const Real angle = i == 0 ? -kPi / 6 : 0;
        balls.push_back(test.add(SphereShape{0.1_r},
                                 hook + Vec3{std::sin(angle), -std::cos(angle), 0},
                                 bouncing(1, 1, {0, 0, 0})));
        join(test,
             {.kind = JointKind::BallAndSocket,
              .a = balls.back(),
              .anchor_a_world = hook,
              .anchor_b_world = hook});
    }
    const double swing_J = kG * (1 - std::cos(kPiD / 6));
    // Of five balls that hang 1 m above the plane through the origin.
    const auto energy_J = [&] { return energy(test.world).total_J() - 5 * kG; };
    EXPECT_NEAR(energy_J() / swing_J, 1, 1e-4);
    double others_mps = 0;
    for (int i = 0; i < 600; ++i) {
        test.world.step();
        for (std::size_t k = 1; k < 4; ++k)
            others_mps = std::max(others_mps, glm::length(test.velocity(balls[k])));
    }
    EXPECT_NEAR(energy_J() / swing_J, 1, 0.02);
    const double fastest_mps = std::sqrt(2 * swing_J);
    EXPECT_LT(others_mps, 0.05 * fastest_mps) << "the three in the middle hang still";
}

/// A figure of six parts falls on its side, with friction: turned round, all its points' speeds would be more than it had.
TEST(JointedImpact, AFallingFigureGainsNothing) {
    WorldDef def = afloat();
    def.gravity_mps2 = {0, -static_cast<Real>(kG), 0};
    TestWorld test(def);
    test.ground(0.6_r, 0.9_r);
    const auto part = [&](const ShapeDef& shape, const Vec3& at, Real mass_kg, const Quat& turned) {
        BodyDef body = bouncing(mass_kg, 0.9_r, {0, 0, 0});
        body.friction = 0.6_r;
        body.world_from_body.orientation = turned;
        return test.add(shape, at, body);
    };
    const auto turned = [](Real degrees, const Vec3& axis) {
        return glm::angleAxis(degrees * kPi / 180, axis);
    };
    const BodyId torso = part(
        BoxShape{{0.4_r, 0.6_r, 0.25_r}}, {0, 3, 0}, 30, turned(30, glm::normalize(Vec3{2, 3, 1})));
    const auto hang = [&](BodyId limb, const Vec3& at) {
        join(test,
             {.kind = JointKind::BallAndSocket,
              .a = limb,
              .b = torso,
              .anchor_a_world = at,
              .anchor_b_world = at});
    };
    hang(part(SphereShape{0.13_r}, {0, 3.45_r, 0}, 5, kNoRotation), {0, 3.32_r, 0});
    for (const Real side : {-1.0_r, 1.0_r}) {
        hang(
            part(CapsuleShape{0.06_r, 0.4_r}, {side * 0.45_r, 3.15_r, 0}, 4, turned(90, {0, 0, 1})),
            {side * 0.2_r, 3.15_r, 0});
        hang(part(CapsuleShape{0.08_r, 0.5_r}, {side * 0.12_r, 2.35_r, 0}, 8, kNoRotation),
             {side * 0.12_r, 2.68_r, 0});
    }
    const double start_J = energy(test.world).total_J();
    double braked_J = 0;
    for (int i = 0; i < 300; ++i) {
        test.world.step();
        braked_J += test.world.report().cost.interventions.braked_J;
    }
    EXPECT_LT(braked_J, 1e-3 * start_J) << "what the energy guard took out";
    EXPECT_LT(energy(test.world).total_J(), 0.5 * start_J);
}

/// The brake gives way within the impact: in a sub-step it gives 2 N for some ms beside the 7.5 Ns of the bounce.
TEST(JointedImpact, ABoxOnABrakedSlideBouncesAsIfAlone) {
    TestWorld test(afloat());
    test.add(BoxShape{{1, 10, 10}}, {-0.5_r, 0, 0}, {.friction = 0, .restitution = 0.5_r});
    const BodyId box =
        test.add(BoxShape{{0.2_r, 0.2_r, 0.2_r}}, {0.6_r, 0, 0}, bouncing(1, 0.5_r, {-5, 0, 0}));
    join(test,
         {.kind = JointKind::Slider,
          .a = box,
          .axis_world = {1, 0, 0},
          .motor = JointMotor{.target = 0, .max = 2}});
    test.run(0.2);
    // 2 N slow it down by 2 m/s each second, on the way there and back: v1^2 = 25 - 2 * 2 * 0.5 at the wall.
    const double there_mps = std::sqrt(25 - 2);
    const double there_s = (5 - there_mps) / 2;
    EXPECT_NEAR(test.velocity(box).x, 0.5 * there_mps - 2 * (0.2 - there_s), 0.01);
}

/// What is on a slide across the way of a fast one may move along one tangent only, and is rubbed along. Where round ones meet,
/// the tangents are those of the moment, not of the sub-step's start, when the line between the centres was a slant.
TEST(JointedImpact, FrictionActsAlongTheOneWayThatAJointLeaves) {
    for (const ShapeDef& shape :
         {ShapeDef{BoxShape{{0.2_r, 0.2_r, 0.2_r}}}, ShapeDef{SphereShape{0.1_r}}}) {
        TestWorld test(afloat());
        BodyDef def = bouncing(1, 1, {0, 0, 0});
        def.friction = 0.2_r;
        def.inertia_kgm2 = Vec3{1e3_r, 1e3_r, 1e3_r};
        const BodyId slid = test.add(shape, {0, 0, 0}, def);
        join(test, {.kind = JointKind::Slider, .a = slid, .axis_world = {0, 1, 0}});
        def.velocity_mps = {-10, 4, 0};
        const BodyId thrown = test.add(shape, {1.21_r, -0.404_r, 0}, def);
        test.run(0.3);
        // The slide takes all along x: 20 Ns, of which friction may use 4 Ns. The slip of 4 m/s between two of 1 kg takes 2 Ns.
        EXPECT_NEAR(test.velocity(thrown).x, 10, 0.01);
        EXPECT_NEAR(test.velocity(slid).y, 2, 0.01);
        EXPECT_NEAR(test.velocity(thrown).y, 2, 0.01);
    }
}

/// All corners of the box meet the floor, and each push at one moves all 40 balls.
TEST(JointedImpact, ABoxOnAChainLandsWithoutSolvingTheChainForEveryPush) {
    WorldDef def = afloat();
    def.gravity_mps2 = {0, -static_cast<Real>(kG), 0};
    TestWorld test(def);
    test.ground(0.5_r, 0.1_r);
    BodyDef heavy = bouncing(4, 0.1_r, {0.3_r, -3, 0});
    heavy.friction = 0.5_r;
    BodyId last = test.add(BoxShape{{0.12_r, 0.12_r, 0.12_r}}, {0, 0.3_r, 0}, heavy);
    Real y_m = 0.36_r;
    for (int i = 0; i < 40; ++i, y_m += 0.03_r) {
        const BodyId ball = test.add(
            SphereShape{0.01_r}, {0, y_m + 0.015_r, 0}, bouncing(0.004_r, 0.1_r, {0.3_r, -3, 0}));
        join(test,
             {.kind = JointKind::BallAndSocket,
              .a = ball,
              .b = last,
              .anchor_a_world = {0, y_m, 0},
              .anchor_b_world = {0, y_m, 0}});
        last = ball;
    }
    std::uint64_t most = 0;
    double gap_m = 0;
    for (int i = 0; i < 30; ++i) {
        test.world.step();
        most = std::max(most, test.world.report().cost.row_solves);
        gap_m = std::max(gap_m, max_joint_error_m(test.world));
    }
    EXPECT_LT(most, 100'000U);
    EXPECT_LT(gap_m, 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
