// A sheet by itself: closed forms at any mesh, what is kept, and what it does where it is torn or too stiff.
#include "tests/engine/physics/deformable/sheet_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

namespace plumbline::physics {
namespace {

class SheetStretch : public testing::TestWithParam<std::tuple<std::uint32_t, double>> {};

// rho g L2 / (2 E), whatever the cells.
TEST_P(SheetStretch, ByItsOwnWeightIsThatOfARod) {
    const auto [cells, stretch_Npm] = GetParam();
    Sheet sheet(strip(cells, stretch_Npm));
    pin_top(sheet);
    run_points(sheet, 240, kDown_mps2);
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

// Hung in folds it is as wide along them as when flat, and stays in them where it does not resist bending.
TEST(Sheet, InFoldsItIsAsWideAsWhenFlat) {
    SheetDef def = strip(10, 1000);
    def.size_m = {0.6, 1};
    def.cells = {16, 10};
    def.folds = 4;
    def.gather = 0.6;
    def.bend_Nm = 0;  // nothing opens them below
    Sheet sheet(def);
    const auto points_m = sheet.positions_m();
    double width_m = 0;
    double least_m = 0;
    double most_m = 0;
    for (std::uint32_t i = 0; i + 1 < sheet.columns(); ++i) {
        width_m += glm::length(points_m[i + 1] - points_m[i]);
        least_m = std::min(least_m, points_m[i].z);
        most_m = std::max(most_m, points_m[i].z);
    }
    EXPECT_NEAR(width_m, 0.6, 1e-12);
    EXPECT_NEAR(points_m[sheet.columns() - 1].x - points_m[0].x, 0.36, 1e-12);
    EXPECT_NEAR(most_m - least_m, 0.8 * 0.6 / 8, 1e-12);  // of each flank, 0.8 across
    EXPECT_NEAR(most_m, -least_m, 1e-12);
    pin_top(sheet);
    run_points(sheet, 300, kDown_mps2);
    for (std::uint32_t i = 0; i < sheet.columns(); ++i)
        EXPECT_NEAR(sheet.positions_m()[10 * sheet.columns() + i].x, points_m[i].x, 0.01) << i;
}

TEST(Sheet, FallsFreely) {
    Sheet sheet(strip(10, 500));
    run_points(sheet, 60, kDown_mps2);
    for (const Vec3d& v : sheet.velocities_mps()) EXPECT_NEAR(v.y, -9.81, 1e-9);
}

// What the sub-steps do not resolve becomes softer: it says so, and stays stable.
TEST(Sheet, WhereSubStepsAreFewItIsSofter) {
    Sheet sheet(strip(20, 1e6));
    pin_top(sheet);
    EXPECT_EQ(sheet.plan(kPointStep_s, 10), 10U);
    EXPECT_LT(sheet.stiffness_share(), 0.01);
    run_points(sheet, 240, kDown_mps2, 10);
    const double stretch_Npm = 1e6 * sheet.stiffness_share();
    const double lower_m = -0.5 - sheet.positions_m().back().y;
    EXPECT_GT(lower_m, 0.3 * 0.2 * 9.81 / (2 * stretch_Npm));
    EXPECT_LT(lower_m, 3 * 0.2 * 9.81 / (2 * stretch_Npm));
    sheet.plan(kPointStep_s, 1'000'000);
    EXPECT_EQ(sheet.stiffness_share(), 1);
}

// What the sub-steps do not bear of its stiffness pulls nothing across its threads either: it once made the points so heavy that a
// stiffer sheet gave way farther than a soft one.
TEST(Sheet, WhereSubStepsAreFewAStifferOneHangsAsASofterOne) {
    for (const double load_mps2 : {9.81, 98.1}) {
        std::vector<double> lower_m;
        for (const double stretch_Npm : {1e4, 1e5, 1e7}) {
            Sheet sheet(strip(20, stretch_Npm));
            pin_top(sheet);
            run_points(sheet, 240, {0, -load_mps2, 0}, 10);
            lower_m.push_back(-0.5 - sheet.positions_m().back().y);
        }
        EXPECT_NEAR(lower_m[1] / lower_m[0], 1, 0.01) << load_mps2;
        EXPECT_NEAR(lower_m[2] / lower_m[0], 1, 0.01) << load_mps2;
    }
}
TEST(Sheet, TearsWhereItCarriesTooMuch) {
    for (const double strength : {0.9, 1.1}) {
        SheetDef def = strip(10, 1000);
        def.damping_s = 0.2;
        def.tear_Npm = strength * 0.2 * 9.81;  // its own weight, at the top
        Sheet sheet(def);
        pin_top(sheet);
        // Lowered slowly.
        for (int i = 0; i < 240; ++i) run_points(sheet, 1, kDown_mps2 * std::min(1.0, i / 120.0));
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
