#include "tests/engine/app/ui/pages_fixture.h"

#include <algorithm>

namespace plumbline::app::ui {
namespace {

TEST_F(PagesTest, EscapeAndEnterLeadInAndOut) {
    keys({kEscape});
    EXPECT_TRUE(control_->open());
    EXPECT_EQ(cell(control_->menu().focus()).text, "Go on");
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

TEST_F(PagesTest, SettingsAreStoredAtOnceAndKeptOverARestart) {
    keys({kEscape});
    choose("Settings");
    choose("low", "Level of detail");
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Low);
    EXPECT_NE(written("app.ui.toml").find("level = \"low\""), std::string::npos);
    ASSERT_TRUE(point_at("70", "Field of view"));
    keys({262, 262, 262});
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    choose("Sound");
    choose("off", "Mute");

    start();
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Low);
    EXPECT_EQ(config_->current().fov_deg, 85.0F);
    EXPECT_TRUE(config_->current().mute);

    keys({kEscape});
    choose("Settings");
    choose("Reset these");
    EXPECT_EQ(config_->current().quality_level, QualityLevel::Auto);
    EXPECT_EQ(config_->current().fov_deg, 70.0F);
    EXPECT_TRUE(config_->current().mute);  // another page's
}

TEST_F(PagesTest, AKeyIsBoundByPressingItAndKeptOverARestart) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    EXPECT_TRUE(control_->menu().page().title.starts_with("Press what shall do"));
    keys({'K'});
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"k", "pad.right_bumper"}));
    EXPECT_NE(written("bindings.ui.toml").find("drop = [\"k\", \"pad.right_bumper\"]"),
              std::string::npos);
    start();
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"k", "pad.right_bumper"}));
    EXPECT_TRUE(bindings_->faults().list().empty());
}

TEST_F(PagesTest, AChordAWheelStepAMouseButtonAndAPadButtonCanBeBound) {
    keys({kEscape});
    choose("Controls");
    InputSnapshot chord;
    chord.events = {{DeviceEventKind::Key, 341, true},
                    {DeviceEventKind::Key, 340, true},
                    {DeviceEventKind::Key, 'X', true}};
    const std::vector<std::pair<InputSnapshot, std::string>> presses{
        {chord, "ctrl+shift+x"},
        {{.events = {{DeviceEventKind::MouseButton, 4, true}}}, "mouse.5"},
        {{.events = {{DeviceEventKind::Wheel, 2, true}}}, "wheel.left"},
        {{.events = {{DeviceEventKind::PadButton, 8, true}}}, "pad.guide"},
        {{.events = {{DeviceEventKind::Key, 346, true}, {DeviceEventKind::Key, 346, false}}},
         "right_alt"}};
    for (const auto& [input, word] : presses) {
        choose("+", "drop the chosen thing");
        take(input);
        EXPECT_EQ(words(Action::Drop).back(), word);
    }
    choose("+", "drop the chosen thing");
    InputSnapshot trigger;
    trigger.pad_present = true;
    trigger.pad_axes = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    take(trigger);
    trigger.pad_axes[4] = 0.9F;
    take(trigger);
    EXPECT_EQ(words(Action::Drop).back(), "pad.left_trigger");
}

TEST_F(PagesTest, AConflictNamesBothActionsAndAsks) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    keys({'F'});
    EXPECT_EQ(control_->menu().page().title, "F is taken");
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "F does \"flashlight on and off\" now. Shall it do \"drop the chosen thing\" "
              "instead?");
    choose("No");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    choose("Q", "drop the chosen thing");
    keys({'F'});
    choose("Yes");
    EXPECT_EQ(words(Action::Drop)[0], "f");
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
    start();
    EXPECT_TRUE(bindings_->faults().list().empty());
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
}

TEST_F(PagesTest, EscapeLeavesABindingAsItWas) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "drop the chosen thing");
    keys({kEscape});
    EXPECT_EQ(control_->menu().page().title, "Controls");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    EXPECT_FALSE(fs::exists(user_ / "bindings.ui.toml"));
}

TEST_F(PagesTest, WhatCannotBeHeldIsRefusedWithItsReason) {
    keys({kEscape});
    choose("Controls");
    choose("W", "forward");
    InputSnapshot wheel;
    wheel.events = {{DeviceEventKind::Wheel, 0, true}};
    take(wheel);
    lay_out();
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "\"wheel.up\" cannot be held down, and \"forward\" needs that");
    keys({'I'});
    EXPECT_EQ(words(Action::Forward)[0], "i");
}

TEST_F(PagesTest, OneAGroupAndAllAreReset) {
    keys({kEscape});
    choose("Controls");
    ASSERT_TRUE(point_at("Q", "drop the chosen thing"));
    keys({kDelete});
    EXPECT_EQ(words(Action::Drop), std::vector<std::string>{"pad.right_bumper"});
    choose("reset", "drop the chosen thing");
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"q", "pad.right_bumper"}));
    EXPECT_EQ(written("bindings.ui.toml").find("drop"), std::string::npos);

    choose("Q", "drop the chosen thing");
    keys({'K'});
    choose("H", "this help");
    keys({'I'});
    choose("Reset all");
    for (const Action action : {Action::Drop, Action::Help})
        EXPECT_EQ(bindings_->current().of(action), bindings_->below().of(action));
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
