// What acts within a sheet: what is kept, what damping takes, how air slows it.
#include "tests/engine/physics/deformable/sheet_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::physics {
namespace {

// Thrown about at random: momentum stays to rounding, and energy only goes.
TEST(SheetForces, CrumpledItKeepsMomentumAndGainsNoEnergy) {
    SheetDef def{.cells = {8, 8}, .stretch_Npm = 500, .shear_Npm = 170, .bend_Nm = 1e-3};
    Sheet sheet(def);
    std::uint32_t random = 7;
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i) {
        Vec3d kick{0, 0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            random = random * 1664525U + 1013904223U;
            kick[axis] = static_cast<double>(random >> 16U) / 6554 - 5;
        }
        sheet.change_velocity(i, kick);
    }
    const Vec3d momentum = sheet.totals().momentum_kgmps;
    const Vec3d turning = sheet.totals().angular_momentum_kgm2ps;
    const double start_J = sheet.totals().kinetic_J;
    for (int i = 0; i < 120; ++i) {
        run_points(sheet, 1, {0, 0, 0});
        ASSERT_LT(sheet.totals().kinetic_J + sheet.totals().elastic_J, start_J * 1.001);
    }
    EXPECT_NEAR(glm::distance(sheet.totals().momentum_kgmps, momentum), 0, 1e-9);
    EXPECT_NEAR(glm::distance(sheet.totals().angular_momentum_kgm2ps, turning), 0, 1e-9);
    EXPECT_LT(sheet.totals().kinetic_J, start_J / 2);
}

// Stretched along its first mode: its energy falls by exp(-w2 d t).
TEST(SheetForces, AStripRingsDownAsItsDampingSays) {
    SheetDef def = strip(20, 500);
    def.damping_s = 1e-3;
    Sheet sheet(def);
    pin_top(sheet);
    constexpr double wave_pm = 3.14159265 / 2;
    displace_points(sheet, [](const Vec3d& at) {
        return Vec3d{0, -0.02 * std::sin(wave_pm * (0.5 - at.y)), 0};
    });
    const auto energy_J = [&sheet] { return sheet.totals().kinetic_J + sheet.totals().elastic_J; };
    sheet.plan(kPointStep_s, 1000);
    const double start_J = energy_J();
    run_points(sheet, 12, {0, 0, 0});
    const double w2 = wave_pm * wave_pm * 500 / 0.2;
    EXPECT_NEAR(std::log(energy_J() / start_J) / (-w2 * def.damping_s * 0.2), 1, 0.1);
}

TEST(SheetForces, AirSlowsItToItsTerminalSpeed) {
    Sheet sheet({.orientation = glm::angleAxis(1.5707963267948966, Vec3d{1, 0, 0}), .drag = 1.2});
    run_points(sheet, 180, kDown_mps2);
    EXPECT_NEAR(-sheet.totals().momentum_kgmps.y / sheet.mass_kg() /
                    std::sqrt(2 * 0.2 * 9.81 / (1.2 * 1.2)),
                1,
                0.01);
    EXPECT_TRUE(sheet.feels_air());
}

}  // namespace
}  // namespace plumbline::physics
