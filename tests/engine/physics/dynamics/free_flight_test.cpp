#include "engine/physics/totals.h"
#include "tests/engine/physics/test_world.h"

#include <cmath>

namespace plumbline::physics {
namespace {

/// Enough for a second of 240 steps: each rounds to half a unit in the last place once.
constexpr double kExact = sizeof(Real) == sizeof(float) ? 1e-6 : 1e-13;

class FreeFlight : public testing::TestWithParam<std::pair<int, int>> {
protected:
    WorldDef def() const { return at_hz(GetParam().first, GetParam().second); }
};

TEST_P(FreeFlight, FallFromEightMetresFollowsGalileo) {
    TestWorld test(def());
    test.ground();
    const BodyId cube = test.add(BoxShape{}, {0, 8, 0});
    test.run(1.0);
    EXPECT_NEAR(test.at(cube).y, 8.0 - 0.5 * kG, kExact * 8);
    EXPECT_NEAR(test.velocity(cube).y, -kG, kExact * 10);
    EXPECT_EQ(test.at(cube).x, 0.0);
}

TEST_P(FreeFlight, ThrowFollowsItsParabolaAtEveryStep) {
    TestWorld test(def());
    const BodyId ball = test.add(SphereShape{.radius_m = 0.1_r},
                                 {1, 2, 3},
                                 {.kind = BodyKind::Dynamic, .velocity_mps = {3, 10, -2}});
    const double step_s = test.world.def().step_s;
    const int steps = static_cast<int>(2.0 / step_s + 0.5);
    for (int i = 1; i <= steps; ++i) {
        test.world.step();
        const double t = i * step_s;
        EXPECT_NEAR(test.at(ball).x, 1 + 3 * t, kExact * 8);
        EXPECT_NEAR(test.at(ball).y, 2 + 10 * t - 0.5 * kG * t * t, kExact * 8);
        EXPECT_NEAR(test.at(ball).z, 3 - 2 * t, kExact * 8);
        EXPECT_NEAR(test.velocity(ball).y, 10 - kG * t, kExact * 10);
    }
}

TEST_P(FreeFlight, DampedFallFollowsItsExponential) {
    TestWorld test(def());
    const double k = 0.4;
    const BodyId ball = test.add(
        SphereShape{.radius_m = 0.1_r},
        {0, 50, 0},
        {.kind = BodyKind::Dynamic, .velocity_mps = {5, 0, 0}, .linear_damping_per_s = 0.4_r});
    test.run(2.0);
    // The definition's own number, as Real holds it.
    const double kept = std::exp(-static_cast<double>(0.4_r) * 2.0);
    EXPECT_NEAR(test.velocity(ball).x, 5 * kept, kExact * 10);
    EXPECT_NEAR(test.velocity(ball).y, -kG / k * (1 - kept), kExact * 20);
    EXPECT_NEAR(test.at(ball).x, 5 / k * (1 - kept), kExact * 20);
    EXPECT_NEAR(test.at(ball).y, 50 - kG / k * (2.0 - (1 - kept) / k), kExact * 60);
}

TEST_P(FreeFlight, SteadyForceAddsItsShare) {
    TestWorld test(def());
    const BodyId ball =
        test.add(SphereShape{}, {0, 20, 0}, {.kind = BodyKind::Dynamic, .mass_kg = 4});
    const double step_s = test.world.def().step_s;
    for (int i = 0; i < static_cast<int>(1.0 / step_s + 0.5); ++i) {
        test.world.apply_force(ball, {12, 0, 0});
        test.world.step();
    }
    EXPECT_NEAR(test.at(ball).x, 0.5 * 3.0, kExact * 40);
    EXPECT_NEAR(test.velocity(ball).x, 3.0, kExact * 40);
    EXPECT_NEAR(test.at(ball).y, 20 - 0.5 * kG, kExact * 40);
}

TEST_P(FreeFlight, SpinTurnsAtItsRateAndDecays) {
    TestWorld test(def());
    const BodyId ball = test.add(SphereShape{},
                                 {0, 100, 0},
                                 {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 2, 0}});
    const BodyId slowing = test.add(SphereShape{},
                                    {5, 100, 0},
                                    {.kind = BodyKind::Dynamic,
                                     .angular_velocity_radps = {0, 0, 30},
                                     .angular_damping_per_s = 0.5_r});
    test.run(1.0);
    const Quat turned = test.world.state(ball).world_from_body.orientation;
    EXPECT_NEAR(2.0 * std::atan2(static_cast<double>(turned.y), static_cast<double>(turned.w)),
                2.0,
                kExact * 4);
    EXPECT_NEAR(test.spin(slowing).z, 30 * std::exp(-0.5), kExact * 40);
}

INSTANTIATE_TEST_SUITE_P(
    Rates,
    FreeFlight,
    testing::Values(std::pair{30, 1}, std::pair{60, 1}, std::pair{240, 1}, std::pair{60, 4}),
    [](const auto& param_info) {
        return std::to_string(param_info.param.first) + "Hz" +
               std::to_string(param_info.param.second);
    });

TEST(FreeFlightOrigin, BodiesWithMassAsideFlyAroundTheirCentre) {
    TestWorld test(weightless());
    // Origin 1 m left of the centre of mass, turning about z at pi: half a turn in one second.
    const BodyId body = test.add(BoxShape{},
                                 {0, 0, 0},
                                 {.kind = BodyKind::Dynamic,
                                  .center_of_mass_m = Vec3{1, 0, 0},
                                  .velocity_mps = {0, -kPi, 0},
                                  .angular_velocity_radps = {0, 0, kPi}});
    test.run(1.0);
    EXPECT_NEAR(test.at(body).x, 2.0, 20 * kRounding);
    EXPECT_NEAR(test.at(body).y, 0.0, 20 * kRounding);
    EXPECT_NEAR(test.velocity(body).y, static_cast<double>(kPi), 20 * kRounding);
    EXPECT_NEAR(test.velocity(body).x, 0.0, 40 * kRounding);
}

/// Torque-free box 1 x 2 x 3 near its middle axis: it tips over every 6.45 s, and a small error in
/// the energy shifts that by seconds. Reference by Runge-Kutta on two grids.
TEST(FreeFlightSpin, TumblingBoxFollowsEuler) {
    TestWorld test({.gravity_mps2 = {0, 0, 0}, .step_s = 1.0 / 120.0});
    const BodyId box =
        test.add(BoxShape{.size_m = {1, 2, 3}},
                 {0, 0, 0},
                 {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0.01_r, 5, 0.01_r}});
    const Vec3d momentum = angular_momentum_kgm2ps(test.world);
    const double energy_J = energy(test.world).kinetic_J;
    test.run(10.0);
    const BodyState state = test.world.state(box);
    const Vec3d spin{glm::conjugate(state.world_from_body.orientation) *
                     state.angular_velocity_radps};
    EXPECT_NEAR(spin.x, 1.035165, 2e-3);
    EXPECT_NEAR(spin.y, 4.771933, 2e-3);
    EXPECT_NEAR(spin.z, -1.292900, 2e-3);
    const Vec3d change = angular_momentum_kgm2ps(test.world) - momentum;
    // In float64 600 steps add up to more of its roundings.
    const int roundings = sizeof(Real) == sizeof(double) ? 100 : 20;
    EXPECT_NEAR(glm::length(change) / glm::length(momentum), 0.0, roundings * kRounding);
    EXPECT_NEAR(energy(test.world).kinetic_J / energy_J, 1.0, 1e-5);
    EXPECT_EQ(test.world.report().use.gyro_bodies, 1U);
}

TEST(FreeFlightSpin, GyroscopicTorqueRunsOnlyWhereItActs) {
    TestWorld test(weightless());
    test.add(
        BoxShape{}, {0, 0, 0}, {.kind = BodyKind::Dynamic, .angular_velocity_radps = {1, 2, 3}});
    test.add(BoxShape{.size_m = {1, 2, 3}}, {9, 0, 0});
    test.world.step();
    EXPECT_EQ(test.world.report().use.gyro_bodies, 0U) << "a cube, and a box at rest";
    EXPECT_FALSE(test.world.report().use.turned);

    const BodyId plank = test.add(BoxShape{.size_m = {1, 2, 3}},
                                  {20, 0, 0},
                                  {.kind = BodyKind::Dynamic, .angular_velocity_radps = {1, 2, 3}});
    test.world.step();
    EXPECT_EQ(test.world.report().use.gyro_bodies, 1U);
    EXPECT_EQ(test.world.report().use.turned, plank);
    EXPECT_GT(std::abs(test.spin(plank).y - 2.0), 1e-3) << "it tumbles";
    test.world.set_velocity(plank, {0, 0, 0}, {1, 2, 3});
    test.world.set_features({.gyroscopic_torque = false});
    test.run(1.0);
    EXPECT_EQ(test.world.report().use.gyro_bodies, 0U);
    EXPECT_NEAR(test.spin(plank).y, 2.0, kRounding) << "without it the spin stays in world axes";
}

TEST(FreeFlightSpin, JointedBodiesFeelGyroscopicTorqueOnceOneTurns) {
    TestWorld test(weightless());
    const BodyId still = test.add(BoxShape{.size_m = {1, 2, 3}}, {0, 0, 0});
    const BodyId turning =
        test.add(BoxShape{.size_m = {1, 2, 3}},
                 {0, 2, 0},
                 {.kind = BodyKind::Dynamic, .angular_velocity_radps = {0, 0, 5e-4_r}});
    ASSERT_TRUE(test.world.create_joint(
        {.kind = JointKind::BallAndSocket, .a = turning, .b = still, .anchor_a_world = {0, 1, 0}}));
    test.world.step();
    EXPECT_EQ(test.world.report().use.gyro_bodies, 0U)
        << "nobody turns by a thousandth of a radian a second";
    test.world.set_velocity(turning, {0, 0, 0}, {0, 0, 2e-3_r});
    test.world.step();
    EXPECT_EQ(test.world.report().use.gyro_bodies, 1U);
    EXPECT_EQ(test.world.report().use.turned, turning);
}

TEST(FreeFlightSpin, AStepThatBeginsAtRestMayGoWithoutGyroscopicTorque) {
    const auto spin_after_a_torque = [](bool waits) {
        TestWorld test(weightless());
        test.world.set_features({.gyro_waits_for_spin = waits});
        const BodyId plank = test.add(BoxShape{.size_m = {1, 2, 3}}, {0, 0, 0});
        test.world.apply_torque(plank, {3000, 3000, 3000});
        test.world.step();
        return test.spin(plank);
    };
    const MassProperties mass = [] {
        TestWorld test(weightless());
        return test.world.state(test.add(BoxShape{.size_m = {1, 2, 3}}, {0, 0, 0})).mass;
    }();
    const Vec3d from_torque = Vec3d{3000.0 / 60} / Vec3d{mass.inertia_kgm2};
    EXPECT_NEAR(glm::distance(spin_after_a_torque(true), from_torque),
                0.0,
                20 * kRounding * glm::length(from_torque));
    EXPECT_GT(glm::distance(spin_after_a_torque(false), from_torque), 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
