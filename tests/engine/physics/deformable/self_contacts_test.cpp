// A sheet that touches itself: halves that are folded onto each other stay apart, and lose no momentum by it.
#include "engine/physics/self_contacts.h"

#include "engine/physics/sheet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace plumbline::physics {
namespace {

constexpr double kFoldStep_s = 1e-3;
constexpr double kThick_m = 0.01;

/// Level, its x along the world's; the right half is turned over onto the left one, this far above it.
std::unique_ptr<Sheet> folded(double gap_m) {
    auto sheet = std::make_unique<Sheet>(SheetDef{
        .size_m = {0.8, 0.4}, .cells = {8, 4}, .stretch_Npm = 1, .shear_Npm = 1, .bend_Nm = 0});
    std::vector<Vec3d> places(sheet->positions_m().begin(), sheet->positions_m().end());
    for (Vec3d& at : places) {
        const double along = std::abs(at.x);
        // Not above each other: a third of a cell aside, so that points lie over triangles.
        at = at.x > 0 ? Vec3d{along + 0.033, gap_m, at.y + 0.029} : Vec3d{along, 0, at.y};
    }
    sheet->put_back(places);
    sheet->plan(kFoldStep_s, 1);
    return sheet;
}

Vec3d momentum_of(const Sheet& sheet) {
    return sheet.totals().momentum_kgmps;
}

TEST(SelfContacts, HalvesThatMeetStopAtTheThickness) {
    const auto owned = folded(0.012);
    Sheet& sheet = *owned;
    const Sheet flat({.size_m = {0.8, 0.4}, .cells = {8, 4}});
    SelfContacts contacts(flat, kThick_m, 0);
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i) {
        if (sheet.positions_m()[i].y > 0) sheet.change_velocity(i, {0, -5, 0});
    }
    const Vec3d before = momentum_of(sheet);
    contacts.find(sheet, kFoldStep_s);
    contacts.solve(sheet, kFoldStep_s);
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

TEST(SelfContacts, LeaveAloneWhatIsFlatOrFar) {
    Sheet sheet({.size_m = {0.8, 0.4}, .cells = {80, 40}});  // cells as long as it is thick
    SelfContacts contacts(sheet, kThick_m, 0.5);
    sheet.plan(kFoldStep_s, 1);
    for (std::size_t i = 0; i < sheet.positions_m().size(); ++i)
        sheet.change_velocity(i, {3, 100, -20});
    contacts.find(sheet, kFoldStep_s);
    contacts.solve(sheet, kFoldStep_s);
    for (const Vec3d& v : sheet.velocities_mps()) EXPECT_EQ(v, (Vec3d{3, 100, -20}));
}

TEST(SelfContacts, WhatPassedThroughIsSentBack) {
    const auto owned = folded(0.009);
    Sheet& sheet = *owned;
    const Sheet flat({.size_m = {0.8, 0.4}, .cells = {8, 4}});
    SelfContacts contacts(flat, kThick_m, 0);
    contacts.find(sheet, kFoldStep_s);
    contacts.solve(sheet, kFoldStep_s);
    std::vector<Vec3d> places(sheet.positions_m().begin(), sheet.positions_m().end());
    for (Vec3d& at : places) at.y = at.y > 0 ? -0.002 : at.y;
    sheet.put_back(places);
    contacts.find(sheet, kFoldStep_s);
    contacts.solve(sheet, kFoldStep_s);
    double sum_mps = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].x > 0.15 && places[i].y < 0) sum_mps += sheet.velocities_mps()[i].y;
    }
    EXPECT_GT(sum_mps, 0) << "upwards, from where it came";
}

}  // namespace
}  // namespace plumbline::physics
