#include "tests/engine/app/ui/pages_fixture.h"

#include <algorithm>

namespace plumbline::app::ui {
namespace {

TEST_F(PagesTest, EscapeAndEnterLeadInAndOut) {
    keys({kEscape});
    EXPECT_TRUE(control_->open());
    EXPECT_EQ(cell(control_->menu().focus()).text, "Resume");
    keys({kEnter});
    EXPECT_FALSE(control_->open());
}

TEST_F(PagesTest, NoPressIsLostWhenAllComeInOneFrame) {
    // Opens the menu, goes down twice and up once, starts the scene again: one late frame.
    const InputSnapshot rest = keys({'Q', kEscape, 264, 264, 265, kEnter, 'W'});
    EXPECT_TRUE(started_again_);
    EXPECT_FALSE(control_->open());
    // What came before and after belongs to playing.
    std::vector<int> pressed;
    for (const DeviceEvent& event : rest.events)
        if (event.pressed) pressed.push_back(event.code);
    EXPECT_EQ(pressed, (std::vector<int>{'Q', kEscape, 'W'}));
}

TEST_F(PagesTest, TheHelpKeyOpensTheHelpAndClosesIt) {
    keys({'H'});
    ASSERT_TRUE(control_->open());
    EXPECT_EQ(control_->menu().page().title, "Help");
    keys({'H'});
    EXPECT_FALSE(control_->open());
    keys({'H', 'H', 'H'});
    EXPECT_TRUE(control_->open());
}

// EXPERIENCE A14: the window goes to a monitor of another scale. Letters are made once, and what was
// chosen stays chosen.
TEST_F(PagesTest, AnotherMonitorsScaleRemakesTheLettersOnceAndKeepsThePlace) {
    keys({kEscape, 264, 264, 264});
    const std::string chosen = cell(control_->menu().focus()).text;
    EXPECT_EQ(canvas_.font_px(), 17.0F);
    EXPECT_TRUE(canvas_.resize(1280, 720, 1.25F, 0.0F));
    EXPECT_EQ(canvas_.font_px(), 21.0F);
    EXPECT_FALSE(canvas_.resize(1280, 720, 1.25F, 0.0F));
    lay_out();
    EXPECT_EQ(cell(control_->menu().focus()).text, chosen);
    EXPECT_EQ(chosen, "Settings");
}

}  // namespace
}  // namespace plumbline::app::ui
