// Elastic joints against closed forms: stretch, bending, what they keep and what they damp.
#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kStiffness_Npm = 100;

/// A point mass of 1 kg on an elastic joint to the world, pulled out by `stretch_m`.
struct Hung : JointRig {
    std::uint32_t ball{0};

    Hung(const Vec3d& stretch_m, double damping_s) {
        kick = Kick::Steady;  // as islands do
        ball = add_body(1, {0, 0, 0}, stretch_m);
        add_joint(ball,
                  0,
                  {.kind = JointKind::Elastic,
                   .anchor_a_world = Vec3(stretch_m),
                   .anchor_b_world = {0, 0, 0},
                   .stiffness_Npm = static_cast<Real>(kStiffness_Npm),
                   .damping_s = static_cast<Real>(damping_s)});
    }
    double all_energy() const {
        return energy() + stored_J(joints.front(), pose(ball), MassPose{});
    }
};

// 10 rad/s along every direction: a circle stays one.
TEST(JointElastic, SwingsAlikeAlongAllDirections) {
    Hung rig({0.1, 0, 0}, 0);
    rig.gravity = {0, 0, 0};
    rig.bodies[rig.ball].velocity_mps = {0, 0, 1};
    rig.run(2, kFrame_s, 16);
    EXPECT_NEAR(glm::length(rig.position(rig.ball)), 0.1, 1e-4);
    EXPECT_NEAR(rig.position(rig.ball).x, 0.1 * std::cos(20.0), 1e-3);
    EXPECT_NEAR(rig.position(rig.ball).z, 0.1 * std::sin(20.0), 1e-3);
}

TEST(JointElastic, HangsByItsStiffness) {
    Hung rig({0, 0, 0}, 0.02);
    rig.run(20, kFrame_s, 4);
    EXPECT_NEAR(rig.position(rig.ball).y, -kG / kStiffness_Npm, 1e-6);
    EXPECT_NEAR(rig.velocity(rig.ball).y, 0, 1e-6);
    EXPECT_NEAR(rig.joints.front().total_impulse_Ns.y, kG * kFrame_s, 1e-6);
}

// A sub-step in which it swings many times: it rests where it should, without a speed, and never gains.
TEST(JointElastic, RestsWhereItIsTooFastToShow) {
    Hung rig({0, 0, 0}, 0);
    rig.joints.front().stiffness_Npm = 1e7_r;
    const double start_J = rig.all_energy();
    for (int i = 0; i < 600; ++i) {
        rig.step(kFrame_s, 2);
        EXPECT_LE(rig.all_energy(), start_J + 1e-6);
    }
    EXPECT_NEAR(rig.position(rig.ball).y, -kG / 1e7, 1e-8);
    EXPECT_NEAR(rig.velocity(rig.ball).y, 0, 1e-4);  // of 0.04 without it: kG * h / 2
}

TEST(JointElastic, KeepsEnergyWithoutDamping) {
    Hung rig({0, -0.3, 0}, 0);
    const double start_J = rig.all_energy();
    rig.run(10, kFrame_s, 8);
    EXPECT_NEAR(rig.all_energy(), start_J, 2e-3 * std::abs(start_J));
}

// c = stiffness * time: the amplitude falls by exp(-c t / (2 m)); within a swing, energy goes by steps of c / (2 w m).
TEST(JointElastic, DampsByATime) {
    Hung rig({0.1, 0, 0}, 0.01);
    rig.gravity = {0, 0, 0};
    rig.run(2, kFrame_s, 16);
    const double left_J = 0.5 * kStiffness_Npm * 0.01 * std::exp(-2.0);
    EXPECT_NEAR(rig.all_energy(), left_J, 0.05 * left_J);
}

// A pure moment M bends a clamped rod by M L^2 / (2 E I).
TEST(JointElastic, ARodBendsByItsMoment) {
    constexpr double kBend_Nm2 = 10;
    constexpr double kMoment_Nm = 0.0125;
    constexpr int kPieces = 20;
    constexpr double kPiece_m = 1.0 / kPieces;
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const Vec3d inertia(0.01 * kPiece_m * kPiece_m);
    std::uint32_t before = 0;
    for (int i = 0; i < kPieces; ++i) {
        const std::uint32_t piece = rig.add_body(0.1, inertia, {(i + 0.5) * kPiece_m, 0, 0});
        const Vec3 at{static_cast<Real>(i * kPiece_m), 0, 0};
        const double span_m = i == 0 ? kPiece_m / 2 : kPiece_m;
        rig.add_joint(piece,
                      before,
                      {.kind = JointKind::Elastic,
                       .anchor_a_world = at,
                       .anchor_b_world = at,
                       .bend_Nmprad = static_cast<Real>(kBend_Nm2 / span_m),
                       .damping_s = 0.05_r});
        before = piece;
    }
    rig.bodies[before].angular_acceleration_radps2 = {
        0, 0, static_cast<Real>(-kMoment_Nm / inertia.z)};
    rig.run(10, kFrame_s, 8);
    const Vec3d tip = rig.position(before) + rig.orientation(before) * Vec3d{kPiece_m / 2, 0, 0};
    const double exact_m = kMoment_Nm / (2 * kBend_Nm2);
    EXPECT_NEAR(-tip.y, exact_m, 0.02 * exact_m);
}

// Nothing from outside acts: spin about the common centre stays.
TEST(JointElastic, AFreePairKeepsMomentum) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t a = rig.add_body(1, Vec3d(0.01), {-0.5, 0, 0});
    const std::uint32_t b = rig.add_body(2, Vec3d(0.02), {0.5, 0, 0});
    rig.add_joint(a,
                  b,
                  {.kind = JointKind::Elastic,
                   .anchor_a_world = {0, 0, 0},
                   .anchor_b_world = {0, 0, 0},
                   .stiffness_Npm = 1000,
                   .bend_Nmprad = 5});
    rig.bodies[a].velocity_mps = {0, 1, 0};
    const auto angular = [&rig, a, b] {
        Vec3d sum{0, 0, 0};
        for (const std::uint32_t i : {a, b})
            sum += glm::cross(rig.position(i), rig.velocity(i)) * rig.mass(i) +
                   rig.bodies[i].inertia_kgm2 * rig.spin(i);
        return sum;
    };
    const Vec3d start = angular();
    rig.run(5, kFrame_s, 16);
    EXPECT_NEAR(glm::length(angular() - start), 0, 2e-3);
    const Vec3d momentum = rig.velocity(a) * rig.mass(a) + rig.velocity(b) * rig.mass(b);
    EXPECT_NEAR(glm::length(momentum - Vec3d{0, 1, 0}), 0, 1e-4);
}

// One by one they come to the same rest.
TEST(JointElastic, TheIterativeMethodRestsThereToo) {
    Hung rig({0, 0, 0}, 0.02);
    rig.method = JointMethod::Iterative;
    rig.run(20, kFrame_s, 8);
    EXPECT_NEAR(rig.position(rig.ball).y, -kG / kStiffness_Npm, 2e-3);
}

}  // namespace
}  // namespace plumbline::physics
