// A sheet that touches itself: halves that are folded onto each other stay apart, and lose no momentum by it.
#include "engine/physics/deformable/part_contacts.h"

#include "engine/physics/sheet.h"
#include "engine/physics/soft_body.h"
#include "engine/physics/soft_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace plumbline::physics {
namespace {

constexpr double kFoldStep_s = 1e-3;
constexpr double kThick_m = 0.01;

/// Level, its x along the world's; the right half is turned over onto the left one, this far above it.
void fold_over(Sheet& sheet, double gap_m) {
    std::vector<Vec3d> places(sheet.positions_m().begin(), sheet.positions_m().end());
    for (Vec3d& at : places) {
        const double along = std::abs(at.x);
        // Not above each other: a third of a cell aside, so that points lie over triangles.
        at = at.x > 0 ? Vec3d{along + 0.033, gap_m, at.y + 0.029} : Vec3d{along, 0, at.y};
    }
    sheet.put_back(places);
    sheet.plan(kFoldStep_s, 1);
}

const SheetDef kFlat{
    .size_m = {0.8, 0.4}, .cells = {8, 4}, .stretch_Npm = 1, .shear_Npm = 1, .bend_Nm = 0};

Vec3d momentum_of(const Sheet& sheet) {
    return sheet.totals().momentum_kgmps;
}

TEST(PartContacts, HalvesThatMeetStopAtTheThickness) {
    Sheet sheet(kFlat);
    PartContacts contacts(sheet, {.thickness_m = kThick_m, .friction = 0});
    fold_over(sheet, 0.012);
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i) {
        if (sheet.positions_m()[i].y > 0) sheet.change_velocity(i, {0, -5, 0});
    }
    const Vec3d before = momentum_of(sheet);
    contacts.begin_step(kFoldStep_s);
    contacts.solve(kFoldStep_s);
    EXPECT_NEAR(glm::length(momentum_of(sheet) - before), 0, 1e-12);
    double lowest_m = 1;
    double highest_m = -1;
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i) {
        const double y = sheet.positions_m()[i].y + sheet.velocities_mps()[i].y * kFoldStep_s;
        // Away from the fold, where cells still hang together.
        if (sheet.positions_m()[i].x < 0.15) continue;
        if (sheet.positions_m()[i].y > 0) {
            lowest_m = std::min(lowest_m, y);
        } else {
            highest_m = std::max(highest_m, y);
        }
    }
    EXPECT_GT(lowest_m - highest_m, 0.8 * kThick_m) << "two sweeps leave a little";
}

TEST(PartContacts, LeaveAloneWhatIsFlatOrFar) {
    Sheet sheet({.size_m = {0.8, 0.4}, .cells = {80, 40}});  // cells as long as it is thick
    PartContacts contacts(sheet, {.thickness_m = kThick_m, .friction = 0.5});
    sheet.plan(kFoldStep_s, 1);
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i)
        sheet.change_velocity(i, {3, 100, -20});
    contacts.begin_step(kFoldStep_s);
    contacts.solve(kFoldStep_s);
    for (const Vec3d& v : sheet.velocities_mps()) EXPECT_EQ(v, (Vec3d{3, 100, -20}));
}

TEST(PartContacts, WhatPassedThroughIsSentBack) {
    Sheet sheet(kFlat);
    PartContacts contacts(sheet, {.thickness_m = kThick_m, .friction = 0});
    fold_over(sheet, 0.009);
    contacts.begin_step(kFoldStep_s);
    contacts.solve(kFoldStep_s);
    std::vector<Vec3d> places(sheet.positions_m().begin(), sheet.positions_m().end());
    for (Vec3d& at : places) at.y = at.y > 0 ? -0.002 : at.y;
    sheet.put_back(places);
    contacts.begin_step(kFoldStep_s);
    contacts.solve(kFoldStep_s);
    double sum_mps = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].x > 0.15 && places[i].y < 0) sum_mps += sheet.velocities_mps()[i].y;
    }
    EXPECT_GT(sum_mps, 0) << "upwards, from where it came";
}

/// Aligned blocks: points over edges, edges along edges. Nothing pushes aside or inwards.
TEST(PartContacts, FacesOfSolidsThatMeetPushApartAlongTheirNormal) {
    for (const double sunk_m : {0.0, 0.004, 0.015}) {
        SoftBodyDef lower{.grid = box_grid({0.4, 0.2, 0.4}, {4, 2, 4})};
        SoftBodyDef upper = lower;
        for (Vec3d& point : upper.grid.points_m) point += Vec3d{0.0, 0.2 + kThick_m - sunk_m, 0.0};
        SoftBody below(std::move(lower));
        SoftBody above(std::move(upper));
        below.plan(kFoldStep_s, 1);
        above.plan(kFoldStep_s, 1);
        PartContacts contacts(above, below, {.thickness_m = kThick_m, .friction = 0.5});
        for (std::size_t i = 0; i < above.positions_m().size(); ++i)
            above.change_velocity(i, {0, -1, 0});
        contacts.begin_step(kFoldStep_s);
        contacts.solve(kFoldStep_s);
        const Vec3d pushed = above.totals().momentum_kgmps;
        EXPECT_GT(pushed.y, -above.mass_kg() + 0.01) << sunk_m;
        EXPECT_NEAR(pushed.y + below.totals().momentum_kgmps.y, -above.mass_kg(), 1e-9);
        for (const Vec3d& v : above.velocities_mps()) {
            EXPECT_GT(v.y, -1.001) << sunk_m;
            EXPECT_LT(std::abs(v.x) + std::abs(v.z), 0.1) << sunk_m;
        }
    }
}

/// Corners of cells that lie over corners of others turn a little: edges that run along each other have no side to keep.
TEST(PartContacts, EdgesThatTurnPastEachOtherStayOnTheirSide) {
    SheetDef def = kFlat;
    Sheet below(def);
    def.position_m.z = 0.009;
    def.orientation = glm::angleAxis(0.3, Vec3d{0, 0, 1});
    Sheet above(def);
    below.plan(kFoldStep_s, 1);
    above.plan(kFoldStep_s, 1);
    PartContacts contacts(above, below, {.thickness_m = kThick_m, .friction = 0});
    std::vector<Vec3d> places(above.positions_m().begin(), above.positions_m().end());
    for (int turn = 0; turn < 60; ++turn) {
        for (Vec3d& at : places) at = glm::angleAxis(-0.01, Vec3d{0, 0, 1}) * at;
        above.put_back(places);
        contacts.begin_step(kFoldStep_s);
        contacts.solve(kFoldStep_s);
        for (const Vec3d& v : above.velocities_mps()) ASSERT_GT(v.z, -1e-6) << turn;
    }
}

}  // namespace
}  // namespace plumbline::physics
