// The water on a soft body's surface: Archimedes' law to rounding at any level and tilt, energy and forces of one potential.
#include "engine/physics/soft_grid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

constexpr double kWater_Npm3 = 9810;
constexpr double kFloatStep_s = 1e-5;

/// A block of 1 x 0.5 x 1 m about the origin, so light that its weight does not count.
SoftBody floating_block(const Vec3d& cells = {4, 2, 4}) {
    return SoftBody({.grid = box_grid({1, 0.5, 1},
                                      {static_cast<std::uint32_t>(cells.x),
                                       static_cast<std::uint32_t>(cells.y),
                                       static_cast<std::uint32_t>(cells.z)}),
                     .density_kgpm3 = 500,
                     .young_Pa = 1e5,
                     .poisson = 0});
}

void flood(SoftBody& soft, double level_m, double slope, double drag = 0) {
    for (const Vec3d& at : soft.positions_m())
        soft.fluids().push_back({.level_m = level_m + slope * at.x,
                                 .density_kgpm3 = 1000,
                                 .weight_Npm3 = kWater_Npm3,
                                 .drag = drag});
}

/// Force, and moment about the origin, in one short sub-step from rest.
struct Push {
    Vec3d force_N{0, 0, 0};
    Vec3d moment_Nm{0, 0, 0};
};

Push push_on(SoftBody& soft) {
    soft.plan(kFloatStep_s, 1);
    soft.accelerate({0, 0, 0});
    const PointTotals totals = soft.totals();
    return {totals.momentum_kgmps / kFloatStep_s, totals.angular_momentum_kgm2ps / kFloatStep_s};
}

TEST(SoftSurface, LiftIsTheWeightOfTheWaterDisplaced) {
    for (const double level_m : {-0.3, -0.13, 0.0, 0.07, 0.3, 2.0}) {
        SoftBody soft = floating_block();
        flood(soft, level_m, 0);
        const double draft_m = std::clamp(level_m + 0.25, 0.0, 0.5);
        const Push push = push_on(soft);
        EXPECT_NEAR(push.force_N.y, kWater_Npm3 * draft_m, 1e-6) << level_m;
        EXPECT_NEAR(soft.totals().displaced_m3, draft_m, 1e-9);
        EXPECT_NEAR(push.force_N.x, 0, 1e-6);
        EXPECT_NEAR(glm::length(push.moment_Nm), 0, 1e-6);
    }
}

// A surface that slopes by s: -grad p over the wedge below it, about the origin, whatever the cells that the waterline cuts.
TEST(SoftSurface, ASlopingSurfaceLiftsAcrossItself) {
    constexpr double kSlope = 0.2;
    const double over_y_m4 = (kSlope * kSlope / 12 - 0.25 * 0.25) / 2;
    for (const double cells : {1.0, 3.0, 5.0}) {
        SoftBody soft = floating_block({cells, 1, 2});
        flood(soft, 0, kSlope);
        const Push push = push_on(soft);
        EXPECT_NEAR(push.force_N.y, kWater_Npm3 * 0.25, 1e-6) << cells;
        EXPECT_NEAR(push.force_N.x, -kWater_Npm3 * 0.25 * kSlope, 1e-6) << cells;
        EXPECT_NEAR(push.moment_Nm.z, kWater_Npm3 * kSlope * (1.0 / 12 + over_y_m4), 1e-6) << cells;
    }
}

TEST(SoftSurface, ForcesAreTheSlopeOfTheEnergy) {
    SoftBody soft = floating_block({2, 1, 2});
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i)
        soft.change_velocity(i, Vec3d{0.3, 0.2, -0.1} * std::sin(static_cast<double>(3 * i)));
    soft.plan(0.1, 1);
    soft.move(soft.substep_s());
    soft.put_back(std::vector<Vec3d>(soft.positions_m().begin(), soft.positions_m().end()));
    flood(soft, 0.03, 0);
    soft.plan(kFloatStep_s, 1);
    const double before_J = soft.totals().water_J + soft.totals().elastic_J;
    soft.accelerate({0, 0, 0});
    const double moving_J = soft.totals().kinetic_J;
    soft.move(soft.substep_s());
    const double after_J = soft.totals().water_J + soft.totals().elastic_J;
    // From rest over h: dE = -F dt F dt / m = -2 kinetic energy, to the order of h.
    EXPECT_GT(moving_J, 1e-9);
    EXPECT_NEAR((after_J - before_J) / (-2 * moving_J), 1, 1e-3);
}

TEST(SoftSurface, ResistanceIsThatOfTheSilhouetteAhead) {
    SoftBody soft = floating_block();
    flood(soft, 0.05, 0, 1);
    const double mass_kg = soft.mass_kg();
    for (std::size_t i = 0; i < soft.positions_m().size(); ++i) soft.change_velocity(i, {2, 0, 0});
    const double moved_kgmps = soft.totals().momentum_kgmps.x;
    soft.plan(kFloatStep_s, 1);
    soft.accelerate({0, 0, 0});
    // 0.3 m of it is under; what moves along with it takes its part of the push.
    const double alone_N = 0.5 * 1000 * 0.3 * 4;
    const double force_N = (moved_kgmps - soft.totals().momentum_kgmps.x) / kFloatStep_s;
    EXPECT_LT(force_N, alone_N);
    EXPECT_GT(force_N, alone_N / (1 + 0.5 * 1000 / (mass_kg / 0.5)));
}

TEST(SoftSurface, ItsTrianglesEncloseItsVolume) {
    const SoftBody soft = floating_block();
    SurfaceParts parts;
    soft.list_parts(parts);
    double six_m3 = 0;
    for (const auto& [a, b, c] : parts.triangles)
        six_m3 += glm::dot(soft.positions_m()[a],
                           glm::cross(soft.positions_m()[b], soft.positions_m()[c]));
    EXPECT_NEAR(six_m3 / 6, soft.volume_m3(), 1e-12);
    EXPECT_NEAR(soft.volume_m3(), 0.5, 1e-12);
    EXPECT_TRUE(parts.encloses);
}

}  // namespace
}  // namespace plumbline::physics
