// A soft body by itself: closed forms, what is kept, and that it comes back from flat and inside out.
#include "engine/physics/soft_grid.h"
#include "tests/engine/physics/deformable/point_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

SoftBodyDef bar(std::uint32_t across, double poisson) {
    return {.grid = box_grid({1, 0.1, 0.1}, {10 * across, across, across}),
            .young_Pa = 1e6,
            .poisson = poisson};
}

void hold_left(SoftBody& soft) {
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i) {
        if (soft.grid().points_m[i].x < -0.49) soft.pin(i);
    }
}

Vec3d right_m(const SoftBody& soft) {
    Vec3d sum{0, 0, 0};
    double count = 0;
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i) {
        if (soft.grid().points_m[i].x < 0.49) continue;
        sum += soft.positions_m()[i] - soft.grid().points_m[i];
        ++count;
    }
    return sum / count;
}

TEST(SoftBody, ABarStretchesByItsWeight) {
    SoftBody soft(bar(1, 0));
    hold_left(soft);
    run_points(soft, 240, {9.81, 0, 0}, 500, 0.8);
    EXPECT_NEAR(right_m(soft).x / (1000 * 9.81 / (2 * 1e6)), 1, 1e-3);
}

// Also of one cell: rho A g L4 / (8 E I), and a little for shear.
TEST(SoftBody, AClampedBarSagsAsABeam) {
    for (const std::uint32_t across : {1U, 2U}) {
        for (const double poisson : {0.0, 0.4}) {
            SoftBody soft(bar(across, poisson));
            hold_left(soft);
            run_points(soft, 500, {0, -0.1, 0}, 500, 0.95);
            const double exact_m = 1000 * 0.01 * 0.1 / (8 * 1e6 * 1e-4 / 12);
            EXPECT_NEAR(-right_m(soft).y / exact_m, 1, poisson > 0 ? 0.05 : 0.02)
                << across << ' ' << poisson;
        }
    }
}

TEST(SoftBody, FlyingItKeepsMomentum) {
    SoftBody soft({.grid = box_grid({1, 0.6, 0.8}, {4, 3, 3})});
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i)
        soft.change_velocity(i, glm::cross(Vec3d{1, 4, 2}, soft.positions_m()[i]) + Vec3d{1, 0, 0});
    const Vec3d momentum = soft.totals().momentum_kgmps;
    const Vec3d turning = soft.totals().angular_momentum_kgm2ps;
    const double start_J = soft.totals().kinetic_J;
    run_points(soft, 120, {0, 0, 0}, 500);
    EXPECT_NEAR(
        glm::distance(soft.totals().momentum_kgmps, momentum), 0, 1e-9 * glm::length(momentum));
    EXPECT_NEAR(glm::distance(soft.totals().angular_momentum_kgm2ps, turning),
                0,
                1e-9 * glm::length(turning));
    EXPECT_NEAR((soft.totals().kinetic_J + soft.totals().elastic_J) / start_J, 1, 0.02);
}

// Points moved onto a plane, and through it, by a jump of their velocities for one sub-step.
TEST(SoftBody, ComesBackFromFlatAndInsideOut) {
    for (const double squeezed : {1.0, 2.0}) {
        SoftBody soft({.grid = box_grid({1, 1, 1}, {3, 3, 3})});
        displace_points(soft, [&](const Vec3d& at) { return Vec3d{0, -squeezed * at.y, 0}; });
        EXPECT_NEAR(soft.volume_m3(), 1 - squeezed, 1e-9);
        run_points(soft, 600, {0, 0, 0}, 500, 0.95);
        // Turned inside out, a corner may keep a dent.
        EXPECT_NEAR(soft.volume_m3(), 1, squeezed > 1 ? 0.05 : 0.01) << squeezed;
        if (squeezed == 1) {
            EXPECT_LT(soft.totals().elastic_J, 10);
        }
    }
}

TEST(SoftBody, WhereSubStepsAreFewItIsSofter) {
    SoftBodyDef def = bar(1, 0.3);
    def.young_Pa = 1e11;
    SoftBody soft(def);
    EXPECT_EQ(soft.plan(kPointStep_s, 5), 5U);
    EXPECT_LT(soft.stiffness_share(), 1e-3);
    hold_left(soft);
    for (int i = 0; i < 60; ++i) {
        const std::uint32_t count = soft.plan(kPointStep_s, 5);
        for (std::uint32_t k = 0; k < count; ++k) {
            soft.accelerate({0, -9.81, 0});
            soft.move(soft.substep_s());
        }
    }
    EXPECT_LT(glm::length(right_m(soft)), 3);
}

// A bar stretched along its first mode: its energy falls by exp(-w2 d t), however few sub-steps there are.
TEST(SoftBody, RingsDownAsItsDampingSays) {
    for (const std::uint32_t most : {10U, 1000U}) {
        SoftBodyDef def = bar(2, 0);
        def.damping_s = 2e-3;
        SoftBody soft(def);
        hold_left(soft);
        constexpr double wave_pm = 3.14159265 / 2;
        displace_points(soft, [](const Vec3d& at) {
            return Vec3d{0.02 * std::sin(wave_pm * (at.x + 0.5)), 0, 0};
        });
        const auto energy_J = [&soft] { return soft.totals().kinetic_J + soft.totals().elastic_J; };
        soft.plan(kPointStep_s, most);  // as stiff as the sub-steps bear
        const double start_J = energy_J();
        run_points(soft, 12, {0, 0, 0}, most);
        const double w2 = wave_pm * wave_pm * 1e6 / 1000;
        EXPECT_NEAR(std::log(energy_J() / start_J) / (-w2 * def.damping_s * 0.2), 1, 0.1) << most;
    }
}

TEST(SoftBody, WhereSubStepsAreFewItStillCarriesItself) {
    SoftBody soft({.grid = box_grid({1, 1, 1}, {12, 12, 12}), .young_Pa = 1e5, .poisson = 0.3});
    EXPECT_GT(soft.plan(kPointStep_s, 1), 1U);
    EXPECT_GT(soft.stiffness_share(), 1000 * 9.81 / (0.25 * 1e5) - 1e-3);
}

}  // namespace
}  // namespace plumbline::physics
