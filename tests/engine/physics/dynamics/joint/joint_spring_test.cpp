#include "tests/engine/physics/dynamics/joint/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

struct Numbers {
    double stiffness_Npm{100};
    double damping_Nspm{0};
    double mass_kg{1};
    double start_m{1};  ///< length; at rest 1
};

/// A ball under a spring of 1 m that hangs from the world.
struct Hanging : JointRig {
    std::uint32_t ball{0};

    explicit Hanging(const Numbers& numbers) {
        const Vec3 at{0, static_cast<Real>(-numbers.start_m), 0};
        ball = add_ball_body(numbers.mass_kg, 0.1, Vec3d(at));
        add_joint(ball,
                  0,
                  {.kind = JointKind::Spring,
                   .anchor_a_world = at,
                   .anchor_b_world = {0, 0, 0},
                   .stiffness_Npm = static_cast<Real>(numbers.stiffness_Npm),
                   .damping_Nspm = static_cast<Real>(numbers.damping_Nspm),
                   .rest_length_m = 1});
    }
    double stretch_m() const { return -position(ball).y - 1; }
    /// With the spring's own.
    double all_energy(double stiffness_Npm) const {
        return energy() + 0.5 * stiffness_Npm * stretch_m() * stretch_m();
    }
};

class JointSpringBothKicks : public testing::TestWithParam<Kick> {};
INSTANTIATE_TEST_SUITE_P(Kicks, JointSpringBothKicks, testing::Values(Kick::Halves, Kick::Steady));

TEST_P(JointSpringBothKicks, DampedOscillationKeepsAmplitudeAndPhase) {
    const double rate = std::sqrt(100 - 0.25);
    const double amplitude = std::hypot(0.5, 0.25 / rate) * std::exp(-2.5);
    const double phase = rate * 5 - std::atan2(0.25 / rate, 0.5);
    double before = 0;
    for (const int substeps : {1, 2, 4, 8}) {
        Hanging rig({.damping_Nspm = 1, .start_m = 1.5});
        rig.gravity = {0, 0, 0};
        rig.kick = GetParam();
        rig.run(5, kFrame_s, substeps);
        const double x = rig.stretch_m();
        const double y = -(-rig.velocity(rig.ball).y + 0.5 * x) / rate;
        const double amplitude_error = std::hypot(x, y) / amplitude - 1;
        const double phase_error = std::remainder(std::atan2(y, x) - phase, 2 * glm::pi<double>());
        if (substeps == 4) {
            EXPECT_NEAR(x, 0.0381922, 2e-6);
            EXPECT_NEAR(amplitude_error, 0, 1e-4);
            EXPECT_NEAR(phase_error, 0, 1e-4);
        }
        const double error = std::hypot(amplitude_error, phase_error);
        if (before > 0 && !kFloat32) {
            EXPECT_NEAR(before / error, 4, 0.3);
        }
        before = error;
    }
}

TEST_P(JointSpringBothKicks, SagIsWeightByStiffnessHoweverStiffOrDamped) {
    for (const Numbers& numbers : {Numbers{100, 1},
                                   Numbers{100, 20},
                                   Numbers{1e4, 10},
                                   Numbers{1e5, 300},
                                   Numbers{1e7, 1e4, 1000}}) {
        for (const int substeps : {1, 4}) {
            Hanging rig(numbers);
            rig.kick = GetParam();
            rig.run(20, kFrame_s, substeps);
            const double sag = numbers.mass_kg * kG / numbers.stiffness_Npm;
            EXPECT_NEAR(rig.stretch_m() / sag, 1, 1e-3) << numbers.stiffness_Npm;
            EXPECT_NEAR(rig.joints[0].total_impulse_Ns.y / kFrame_s,
                        numbers.mass_kg * kG,
                        1e-4 * numbers.mass_kg * kG);
        }
    }
}

TEST_P(JointSpringBothKicks, StiffSpringsNeverGainEnergy) {
    for (const Numbers& numbers : {Numbers{1e7, 0, 1, 1.01},
                                   Numbers{1e7, 1000, 1, 1.01},
                                   Numbers{1e4, 1e5, 1, 1.01},
                                   Numbers{1e5, 10, 1, 1.01},
                                   Numbers{1e5, 0, 1, 1.01}}) {
        for (const int substeps : {1, 4}) {
            Hanging rig(numbers);
            rig.kick = GetParam();
            const double start_J = rig.all_energy(numbers.stiffness_Npm);
            double gained_J = 0;
            double widest_m = 0;
            for (int i = 0; i < 600; ++i) {
                rig.step(kFrame_s, substeps);
                gained_J = std::max(gained_J, rig.all_energy(numbers.stiffness_Npm) - start_J);
                widest_m = std::max(widest_m, std::abs(rig.stretch_m()));
            }
            // float32 rounds 1e7 N/m times a hundredth of a metre. What the latter half of gravity gives is damped in the
            // next sub-step.
            const double later_mps = GetParam() == Kick::Halves ? kG * kFrame_s / substeps / 2 : 0;
            const double later_J = 0.5 * numbers.mass_kg * later_mps * later_mps;
            EXPECT_LT(gained_J, kFloat32 ? 0.2 : later_J + 1e-6) << numbers.stiffness_Npm;
            EXPECT_LT(widest_m, 0.0101) << numbers.stiffness_Npm;
        }
    }
}

TEST_P(JointSpringBothKicks, OverdampedSpringCreepsAtItsRate) {
    // Damping 1e5, stiffness 1e4: 10 s to fall to 1/e of the way to the sag.
    Hanging rig({1e4, 1e5, 1, 1.01});
    rig.kick = GetParam();
    rig.run(10, kFrame_s, 4);
    const double sag = kG / 1e4;
    EXPECT_NEAR(rig.stretch_m(), sag + (0.01 - sag) * std::exp(-1), 3e-5);
}

// Its damping acted twice: what damping 50 should let sink by 17.5 cm in a second sank by 9.3.
TEST_P(JointSpringBothKicks, OverdampedSpringsCreepHoweverStrongTheirDamping) {
    const double weak_Npm = 10;
    for (const double damping : {50.0, 100.0, 300.0, 1000.0}) {
        Hanging rig({.stiffness_Npm = weak_Npm, .damping_Nspm = damping});
        rig.kick = GetParam();
        const double start_m = rig.stretch_m();
        rig.run(1, kFrame_s, 2);
        // (c - root) / 2 written without the cancellation.
        const double root = std::sqrt(damping * damping - 4 * weak_Npm);
        const double slow_per_s = 2 * weak_Npm / (damping + root);
        const double fast_per_s = (damping + root) / 2;
        const double sag = kG / weak_Npm;
        const double left =
            (fast_per_s * std::exp(-slow_per_s) - slow_per_s * std::exp(-fast_per_s)) /
            (fast_per_s - slow_per_s);
        EXPECT_NEAR((rig.stretch_m() - start_m) / (sag * (1 - left)), 1, 0.015) << damping;
    }
}

TEST_P(JointSpringBothKicks, StiffSpringFeelsWhatIsJoinedToItsBody) {
    // 1 kg on the spring, 999 kg fixed below it: 10 rad/s, not 316.
    for (const int substeps : {1, 4}) {
        Hanging rig({.stiffness_Npm = 1e5, .start_m = 1.1});
        rig.gravity = {0, 0, 0};
        rig.kick = GetParam();
        const std::uint32_t heavy = rig.add_ball_body(999, 0.3, {0, -1.6, 0});
        rig.add_joint(
            heavy, rig.ball, {.kind = JointKind::Fixed, .anchor_a_world = {0, -1.1_r, 0}});
        rig.run(2 * glm::pi<double>() / 10 * 5, kFrame_s, substeps);
        const double cycles = rig.time_s * 10;
        const double slower = 1 - std::pow(10 * kFrame_s / substeps, 2) / 12;
        EXPECT_NEAR(rig.stretch_m(), 0.1 * std::cos(cycles * slower), 1e-4);
        EXPECT_LT(rig.max_error(), 1e-7);
    }
}

TEST(JointSpring, ManySpringsOnOneBodyAreStable) {
    JointRig rig;
    const std::uint32_t body = rig.add_body(1, Vec3d(0.1), {0, 0, 0});
    for (int i = 0; i < 60; ++i) {
        const double angle = i * 0.1047;
        rig.add_joint(body,
                      0,
                      {.kind = JointKind::Spring,
                       .anchor_a_world = {0, 0, 0},
                       .anchor_b_world = Vec3(Vec3d{std::cos(angle), std::sin(angle), 0}),
                       .stiffness_Npm = 2000,
                       .damping_Nspm = 10});
    }
    rig.run(5, kFrame_s, 1);
    // Half of them act along y.
    EXPECT_NEAR(rig.position(body).y, -kG / (30 * 2000), 2e-6);
    EXPECT_LT(rig.max_speed(), 1e-4);
}

TEST(JointSpring, SpringBetweenTwoFreeBodiesKeepsTheirMomentum) {
    JointRig rig;
    rig.gravity = {0, 0, 0};
    const std::uint32_t a = rig.add_body(1, {0.1, 0.2, 0.3}, {0, 0, 0});
    const std::uint32_t b = rig.add_body(3, {0.3, 0.3, 0.5}, {2, 0, 0});
    rig.add_joint(a,
                  b,
                  {.kind = JointKind::Spring,
                   .anchor_a_world = {0.2_r, 0.3_r, 0},
                   .anchor_b_world = {1.5_r, -0.2_r, 0.3_r},
                   .stiffness_Npm = 60,
                   .damping_Nspm = 0.5_r,
                   .rest_length_m = 0.5_r});
    rig.run(5, kFrame_s, 4);
    const Vec3d momentum = rig.velocity(a) + 3.0 * rig.velocity(b);
    EXPECT_LT(glm::length(momentum), 1e-5);
    Vec3d angular{0, 0, 0};
    for (const std::uint32_t i : {a, b}) {
        const Quatd q = rig.orientation(i);
        angular += glm::cross(rig.position(i), rig.mass(i) * rig.velocity(i)) +
                   q * (rig.bodies[i].inertia_kgm2 * (glm::conjugate(q) * rig.spin(i)));
    }
    EXPECT_LT(glm::length(angular), 1e-4);
}

TEST(JointSpring, IterativeMethodIsStableToo) {
    for (const Numbers& numbers : {Numbers{1e7, 0, 1, 1.01}, Numbers{100, 20}}) {
        Hanging rig(numbers);
        rig.method = JointMethod::Iterative;
        rig.kick = Kick::Steady;
        rig.run(10, kFrame_s, 4);
        EXPECT_LT(std::abs(rig.stretch_m()), 0.2);
    }
}

}  // namespace
}  // namespace plumbline::physics
