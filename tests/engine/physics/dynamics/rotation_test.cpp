#include "engine/physics/dynamics/rotation.h"

#include "engine/core/random.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace plumbline::physics {
namespace {

const Vec3d kBoxInertia{13.0 / 12, 10.0 / 12, 5.0 / 12};  // edges 1, 2, 3 m; 1 kg
const Vec3d kNearlySteady{0.01, 5, 0.01};

Vec3d momentum_of(const FreeTurn& state, const Vec3d& inertia) {
    return state.orientation * (inertia * (glm::conjugate(state.orientation) * state.spin_radps));
}
double energy_of(const FreeTurn& state, const Vec3d& inertia) {
    return glm::dot(state.spin_radps, momentum_of(state, inertia)) / 2;
}
Vec3d body_spin(const FreeTurn& state) {
    return glm::conjugate(state.orientation) * state.spin_radps;
}
Vec3d random_spin(Random& random, float size) {
    return {static_cast<double>(random.uniform(-size, size)),
            static_cast<double>(random.uniform(-size, size)),
            static_cast<double>(random.uniform(-size, size))};
}

TEST(TurnBy, IsTheRotationByAngleAboutTheSpin) {
    const Quatd quarter = turn_by(Vec3d{0, 0, 3.14159265358979323846}, 0.5);
    EXPECT_LT(glm::length(quarter * Vec3d{1, 0, 0} - Vec3d{0, 1, 0}), 1e-15);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3d spin = random_spin(random, 20);
        const Quatd turn = turn_by(spin, 0.1);
        EXPECT_NEAR(glm::length(turn), 1, 1e-14);
        const Quatd by_angle = glm::angleAxis(glm::length(spin) * 0.1, glm::normalize(spin));
        EXPECT_NEAR(std::abs(glm::dot(turn, by_angle)), 1, 1e-14);
        // Halves follow each other.
        const Quatd twice = turn_by(spin, 0.05) * turn_by(spin, 0.05);
        EXPECT_NEAR(glm::dot(twice, turn), 1, 1e-14);
    }
}

TEST(TurnBy, HasNoStepWhereTheSeriesEnds) {
    // The half angle 1e-3 is where one formula takes over from the other.
    const Quatd below = turn_by(Vec3d{2e-3 * (1 - 1e-9), 0, 0}, 1.0);
    const Quatd above = turn_by(Vec3d{2e-3 * (1 + 1e-9), 0, 0}, 1.0);
    EXPECT_NEAR(above.x - below.x, 2e-12, 2e-14);
    EXPECT_NEAR(above.w, below.w, 1e-13);
}

TEST(TurnBy, IsTrueToRoundingForSmallAngles) {
    for (double half : {0.0, 1e-12, 1e-8, 1e-5, 3e-4, 9.99e-4}) {
        const Quatd turn = turn_by(Vec3d{0, 2 * half, 0}, 1.0);
        EXPECT_NEAR(turn.y, std::sin(half), 1e-17 + 1e-14 * half) << half;
        EXPECT_NEAR(turn.w, std::cos(half), 1e-13) << half;
        const auto narrow = turn_by(Vec3{0, static_cast<Real>(2 * half), 0}, Real{1});
        EXPECT_NEAR(static_cast<double>(narrow.y),
                    std::sin(half),
                    (2 * static_cast<double>(std::numeric_limits<Real>::epsilon()) + 1e-14) * half)
            << half;
    }
}

TEST(TurnedFreely, ABallTurnsSteadily) {
    const FreeTurn start{Quatd{1, 0, 0, 0}, Vec3d{1, 2, 3}};
    const FreeTurn end = turned_freely(start, Vec3d(0.4), 0.7);
    EXPECT_LT(glm::length(end.spin_radps - start.spin_radps), 1e-14);
    EXPECT_NEAR(std::abs(glm::dot(end.orientation, turn_by(start.spin_radps, 0.7))), 1, 1e-14);
}

TEST(TurnedFreely, KeepsMomentumAndEnergy) {
    Random random(11);
    for (int trial = 0; trial < 20; ++trial) {
        FreeTurn state{glm::normalize(Quatd{1, random_spin(random, 1)}), random_spin(random, 10)};
        const Vec3d momentum = momentum_of(state, kBoxInertia);
        const double energy = energy_of(state, kBoxInertia);
        for (int i = 0; i < 600; ++i) state = turned_freely(state, kBoxInertia, 1.0 / 60);
        EXPECT_LT(glm::length(momentum_of(state, kBoxInertia) - momentum),
                  1e-11 * glm::length(momentum));
        EXPECT_NEAR(energy_of(state, kBoxInertia) / energy, 1, 1e-5);
    }
}

TEST(TurnedFreely, MiddleAxisFlipsWhenEulersEquationsSay) {
    // Reference: Runge-Kutta 4 of Euler's equations on two grids.
    for (int substeps : {1, 4, 16}) {
        const double h = 1.0 / 60 / substeps;
        FreeTurn state{Quatd{1, 0, 0, 0}, kNearlySteady};
        std::vector<double> flips;
        for (int i = 0; i < 600 * substeps; ++i) {
            const double before = body_spin(state).y;
            state = turned_freely(state, kBoxInertia, h);
            const double after = body_spin(state).y;
            if (before * after < 0) flips.push_back(h * (i + before / (before - after)));
        }
        ASSERT_EQ(flips.size(), 2U);
        // What one step of 1/60 s leaves falls with the fourth power of h.
        const double finer = std::pow(substeps, 4);
        EXPECT_NEAR(flips[0], 2.76718, 1e-5) << substeps;
        EXPECT_NEAR(flips[1], 9.21780, 6e-3 / finer + 1e-5) << substeps;
        const Vec3d spin = body_spin(state);
        EXPECT_LT(glm::length(spin - Vec3d(1.035165, 4.771933, -1.292900)), 0.025 / finer + 2e-6)
            << substeps;
    }
}

TEST(TurnedFreely, SymmetricTopPrecessesAtItsRate) {
    // Cylinder r = 0.5 m, h = 0.1 m, 1 kg, axis y: the axis circles the momentum at |L| / I_across.
    const double along = 0.5 * 0.25;
    const double across = (3 * 0.25 + 0.01) / 12;
    const Vec3d inertia{across, along, across};
    const double tilt = 20 * 3.14159265358979323846 / 180;
    const FreeTurn start{Quatd{1, 0, 0, 0}, 30.0 * Vec3d(std::sin(tilt), std::cos(tilt), 0)};
    const Vec3d momentum = momentum_of(start, inertia);
    const double rate = glm::length(momentum) / across;
    FreeTurn state = start;
    for (int i = 1; i <= 60; ++i) {
        state = turned_freely(state, inertia, 1.0 / 60);
        const Vec3d axis = turn_by(glm::normalize(momentum) * rate, i / 60.0) * Vec3d(0, 1, 0);
        EXPECT_LT(glm::length(state.orientation * Vec3d(0, 1, 0) - axis), 1e-3) << i;
    }
}

TEST(TurnedFreely, IsOfFourthOrder) {
    // Short enough not to be followed in pieces.
    const Vec3d spin{1, 2, -1};
    const auto end_after = [&](int pieces) {
        FreeTurn state{Quatd{1, 0, 0, 0}, spin};
        for (int i = 0; i < pieces; ++i) state = turned_freely(state, kBoxInertia, 0.8 / pieces);
        return state.spin_radps;
    };
    const Vec3d best = end_after(3200);
    const double coarse = glm::length(end_after(40) - best);
    const double fine = glm::length(end_after(80) - best);
    EXPECT_NEAR(coarse / fine, 16, 3);
}

TEST(TurnedFreely, AThinRodKeepsItsMotionWhateverTheStep) {
    // Edges 4, 0.04, 0.04 m: 1 to 5000. A symmetric top precesses about its momentum and turns
    // about its own axis, both evenly.
    const Vec3d inertia{2.0 * 0.0016 / 12, 16.0016 / 12, 16.0016 / 12};
    const Vec3d spin{3.9, -20, 6.1};
    for (const double h : {1.0 / 30, 1.0 / 240}) {
        FreeTurn state{{1, 0, 0, 0}, spin};
        const Vec3d momentum = momentum_of(state, inertia);
        const double energy = energy_of(state, inertia);
        const double precession = glm::length(momentum) / inertia.y;
        const int steps = static_cast<int>(std::lround(10 / h));
        for (int i = 0; i < steps; ++i) state = turned_freely(state, inertia, h);
        EXPECT_NEAR(energy_of(state, inertia) / energy, 1, 1e-9);
        EXPECT_LT(glm::distance(momentum_of(state, inertia), momentum), 1e-8);
        EXPECT_NEAR(body_spin(state).x, spin.x, 1e-6);
        const Vec3d axis = turn_by(momentum / inertia.y, 10.0) * Vec3d{1, 0, 0};
        EXPECT_LT(glm::distance(state.orientation * Vec3d{1, 0, 0}, axis), 1e-7) << precession;
    }
}

}  // namespace
}  // namespace plumbline::physics
