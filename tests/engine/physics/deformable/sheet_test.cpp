// A sheet by itself: closed forms at any mesh, what is kept, and what it does where it is torn or too stiff.
#include "engine/physics/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace plumbline::physics {
namespace {

constexpr Vec3d kDown_mps2{0, -9.81, 0};
constexpr double kSheetStep_s = 1.0 / 60;

void run_sheet(Sheet& sheet, int steps, const Vec3d& gravity_mps2, std::uint32_t most = 1000) {
    for (int i = 0; i < steps; ++i) {
        const std::uint32_t count = sheet.plan(kSheetStep_s, most);
        for (std::uint32_t k = 0; k < count; ++k) {
            sheet.accelerate(gravity_mps2);
            sheet.move(sheet.substep_s());
        }
    }
}

SheetDef strip(std::uint32_t cells, double stretch_Npm) {
    return {.size_m = {0.2, 1},
            .cells = {std::max(2U, cells / 5), cells},
            .stretch_Npm = stretch_Npm,
            .shear_Npm = stretch_Npm / 3,
            .damping_s = 0.02};
}

void pin_top(Sheet& sheet) {
    for (std::uint32_t i = 0; i < sheet.columns(); ++i) sheet.pin(i);
}

class SheetStretch : public testing::TestWithParam<std::tuple<std::uint32_t, double>> {};

// rho g L2 / (2 E), whatever the cells.
TEST_P(SheetStretch, ByItsOwnWeightIsThatOfARod) {
    const auto [cells, stretch_Npm] = GetParam();
    Sheet sheet(strip(cells, stretch_Npm));
    pin_top(sheet);
    run_sheet(sheet, 240, kDown_mps2);
    const double lower_m = -0.5 - sheet.positions_m().back().y;
    EXPECT_NEAR(lower_m / (0.2 * 9.81 / (2 * stretch_Npm)), 1, 1e-4);
    Vec3d held{0, 0, 0};
    for (std::uint32_t i = 0; i < sheet.columns(); ++i) held += sheet.support_Ns(i);
    EXPECT_NEAR(held.y / sheet.substep_s(), -9.81 * sheet.mass_kg(), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Sheets,
                         SheetStretch,
                         testing::Combine(testing::Values(10U, 20U),
                                          testing::Values(50.0, 1000.0)));

TEST(Sheet, FallsFreely) {
    Sheet sheet(strip(10, 500));
    run_sheet(sheet, 60, kDown_mps2);
    for (const Vec3d& v : sheet.velocities_mps()) EXPECT_NEAR(v.y, -9.81, 1e-9);
}

// Thrown about at random: momentum stays to rounding, and energy only goes.
TEST(Sheet, CrumpledItKeepsMomentumAndGainsNoEnergy) {
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
        run_sheet(sheet, 1, {0, 0, 0});
        ASSERT_LT(sheet.totals().kinetic_J + sheet.totals().elastic_J, start_J * 1.001);
    }
    EXPECT_NEAR(glm::distance(sheet.totals().momentum_kgmps, momentum), 0, 1e-9);
    EXPECT_NEAR(glm::distance(sheet.totals().angular_momentum_kgm2ps, turning), 0, 1e-9);
    EXPECT_LT(sheet.totals().kinetic_J, start_J / 2);
}

// What the sub-steps do not resolve becomes softer: it says so, and stays stable.
TEST(Sheet, WhereSubStepsAreFewItIsSofter) {
    Sheet sheet(strip(20, 1e6));
    pin_top(sheet);
    EXPECT_EQ(sheet.plan(kSheetStep_s, 10), 10U);
    EXPECT_LT(sheet.stiffness_share(), 0.01);
    run_sheet(sheet, 240, kDown_mps2, 10);
    const double stretch_Npm = 1e6 * sheet.stiffness_share();
    const double lower_m = -0.5 - sheet.positions_m().back().y;
    EXPECT_GT(lower_m, 0.3 * 0.2 * 9.81 / (2 * stretch_Npm));
    EXPECT_LT(lower_m, 3 * 0.2 * 9.81 / (2 * stretch_Npm));
    sheet.plan(kSheetStep_s, 1'000'000);
    EXPECT_EQ(sheet.stiffness_share(), 1);
}

TEST(Sheet, AirSlowsItToItsTerminalSpeed) {
    Sheet sheet({.orientation = glm::angleAxis(1.5707963267948966, Vec3d{1, 0, 0}), .drag = 1.2});
    run_sheet(sheet, 180, kDown_mps2);
    EXPECT_NEAR(-sheet.totals().momentum_kgmps.y / sheet.mass_kg() /
                    std::sqrt(2 * 0.2 * 9.81 / (1.2 * 1.2)),
                1,
                0.01);
    EXPECT_TRUE(sheet.feels_air());
}

TEST(Sheet, TearsWhereItCarriesTooMuch) {
    for (const double strength : {0.9, 1.1}) {
        SheetDef def = strip(10, 1000);
        def.damping_s = 0.2;
        def.tear_Npm = strength * 0.2 * 9.81;  // its own weight, at the top
        Sheet sheet(def);
        pin_top(sheet);
        // Lowered slowly.
        for (int i = 0; i < 240; ++i) run_sheet(sheet, 1, kDown_mps2 * std::min(1.0, i / 120.0));
        EXPECT_EQ(sheet.torn() > 0, strength < 1) << strength;
        EXPECT_EQ(sheet.is_whole(0, 0), strength > 1);
    }
}

TEST(Sheet, PlacesLieBetweenItsPoints) {
    const Sheet sheet({.size_m = {2, 1}, .cells = {4, 2}});
    EXPECT_EQ(sheet.places(1).size(), 15U);
    const std::vector<SurfacePlace> places = sheet.places(3);
    EXPECT_EQ(places.size(), 13U * 7U);
    for (std::size_t i = 0; i < places.size(); ++i) {
        Vec3d at{0, 0, 0};
        for (std::size_t k = 0; k < 4; ++k)
            at += places[i].weights[k] * sheet.positions_m()[places[i].points[k]];
        EXPECT_NEAR(at.x, -1 + static_cast<double>(i % 13) / 6, 1e-12);
        EXPECT_NEAR(at.y, 0.5 - static_cast<double>(i / 13) / 6, 1e-12);
    }
    EXPECT_NEAR(sheet.area_m2(), 2, 1e-12);
    EXPECT_NEAR(sheet.mass_kg(), 0.4, 1e-12);
}

}  // namespace
}  // namespace plumbline::physics
