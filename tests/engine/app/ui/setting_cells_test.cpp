// Cells that change a value.
#include "engine/app/ui/setting_cells.h"

#include <gtest/gtest.h>

namespace plumbline::app::ui {
namespace {

/// A slider from 0 to 1 by quarters, and what it was set to.
struct Slid {
    double value{0};
    double set{-1};
    Cell cell() {
        return slider("x", value, 0, 1, 0.25, [this](double wanted) { set = wanted; });
    }
    double after(int direction) {
        set = -1;
        cell().adjust(direction);
        return set;
    }
};

TEST(SettingCells, ASliderMovesByItsStepWithinItsEnds) {
    EXPECT_EQ(Slid{.value = 0.5}.after(1), 0.75);
    EXPECT_EQ(Slid{.value = 0.5}.after(-1), 0.25);
    EXPECT_EQ(Slid{.value = 1}.after(1), 1);
    EXPECT_EQ(Slid{.value = 0}.after(-1), 0);
}

TEST(SettingCells, FromBetweenTwoStepsASliderGoesToTheNextOne) {
    EXPECT_EQ(Slid{.value = 0.3}.after(-1), 0.25) << "the nearest lies that way";
    EXPECT_EQ(Slid{.value = 0.3}.after(1), 0.5);
    EXPECT_EQ(Slid{.value = 0.45}.after(1), 0.5);
    EXPECT_EQ(Slid{.value = 0.45}.after(-1), 0.25);
    EXPECT_EQ(Slid{.value = 0.5000001}.after(1), 0.75) << "as good as on a step";
}

TEST(SettingCells, AClickOrDragSetsTheNearestStepOnce) {
    Slid slid{.value = 0.5};
    EXPECT_EQ(slid.cell().fraction, 0.5F);
    slid.cell().set_fraction(0.9F);
    EXPECT_EQ(slid.set, 1.0);
    slid.set = -1;
    slid.cell().set_fraction(0.55F);
    EXPECT_EQ(slid.set, -1.0) << "it is there already";
    Cell celsius = slider("x", 20, 10, 30, 5, [](double) {});
    EXPECT_EQ(celsius.fraction, 0.5F);
}

TEST(SettingCells, ASwitchTurnsRoundOrGoesWhereTheArrowPoints) {
    bool set = false;
    const auto keep = [&](bool on) { set = on; };
    const Cell off = toggle(false, keep);
    EXPECT_EQ(off.text, "off");
    EXPECT_EQ(off.icon, Icon::Off);
    off.activate();
    EXPECT_TRUE(set);
    const Cell on = toggle(true, keep);
    EXPECT_EQ(on.text, "on");
    EXPECT_EQ(on.icon, Icon::On);
    on.activate();
    EXPECT_FALSE(set);
    on.adjust(1);
    EXPECT_TRUE(set);
    on.adjust(-1);
    EXPECT_FALSE(set);
}

TEST(SettingCells, AShareIsToldInWholePerCents) {
    EXPECT_EQ(percent(0.0F), "0 %");
    EXPECT_EQ(percent(0.846F), "85 %");
    EXPECT_EQ(percent(1.5F), "150 %");
}

}  // namespace
}  // namespace plumbline::app::ui
