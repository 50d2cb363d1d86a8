// Keys are changed by pressing them.
#include "tests/engine/app/ui/pages_fixture.h"

namespace plumbline::app::ui {
namespace {

class ControlsPages : public PagesTest {};

TEST_F(ControlsPages, AKeyIsBoundByPressingItAndKeptOverARestart) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "Drop the selected object");
    EXPECT_TRUE(control_->menu().page().title.starts_with("Press a key for:"));
    keys({'I'});
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"i", "pad.right_bumper"}));
    EXPECT_NE(written("bindings.ui.toml").find("drop = [\"i\", \"pad.right_bumper\"]"),
              std::string::npos);
    start();
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"i", "pad.right_bumper"}));
    EXPECT_TRUE(bindings_->faults().list().empty());
}

TEST_F(ControlsPages, AChordAWheelStepAMouseButtonAndAPadButtonCanBeBound) {
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
        choose("+", "Drop the selected object");
        take(input);
        EXPECT_EQ(words(Action::Drop).back(), word);
    }
    choose("+", "Drop the selected object");
    InputSnapshot trigger;
    trigger.pad_present = true;
    trigger.pad_axes = {0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    take(trigger);
    trigger.pad_axes[4] = 0.9F;
    take(trigger);
    choose("Rebind");  // the left trigger is that of Use
    EXPECT_EQ(words(Action::Drop).back(), "pad.left_trigger");
}

TEST_F(ControlsPages, AConflictNamesBothActionsAndAsks) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "Drop the selected object");
    keys({'F'});
    EXPECT_EQ(control_->menu().page().title, "F is already in use");
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "F is bound to \"Flashlight on/off\". Bind it to \"Drop the selected object\" "
              "instead?");
    choose("Cancel");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    choose("Q", "Drop the selected object");
    keys({'F'});
    choose("Rebind");
    EXPECT_EQ(words(Action::Drop)[0], "f");
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
    start();
    EXPECT_TRUE(bindings_->faults().list().empty());
    EXPECT_EQ(words(Action::Flashlight), std::vector<std::string>{"pad.y"});
}

TEST_F(ControlsPages, AConflictSaysWhichActionIsLeftWithoutABinding) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "Drop the selected object");
    keys({'G'});
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "G is bound to \"Fog on/off\". Bind it to \"Drop the selected object\" instead? "
              "\"Fog on/off\" will then have no binding.");
}

TEST_F(ControlsPages, EscapeLeavesABindingAsItWas) {
    keys({kEscape});
    choose("Controls");
    choose("Q", "Drop the selected object");
    keys({kEscape});
    EXPECT_EQ(control_->menu().page().title, "Controls");
    EXPECT_EQ(words(Action::Drop)[0], "q");
    EXPECT_FALSE(fs::exists(user_ / "bindings.ui.toml"));
}

TEST_F(ControlsPages, WhatCannotBeHeldIsRefusedWithItsReason) {
    keys({kEscape});
    choose("Controls");
    choose("W", "Move forward");
    InputSnapshot wheel;
    wheel.events = {{DeviceEventKind::Wheel, 0, true}};
    take(wheel);
    lay_out();
    EXPECT_EQ(control_->menu().page().lines[0].label,
              "\"wheel.up\" cannot be held down, and \"forward\" needs that");
    keys({'I'});
    EXPECT_EQ(words(Action::Forward)[0], "i");
}

TEST_F(ControlsPages, OneAGroupAndAllAreReset) {
    keys({kEscape});
    choose("Controls");
    ASSERT_TRUE(point_at("Q", "Drop the selected object"));
    keys({kDelete});
    EXPECT_EQ(words(Action::Drop), std::vector<std::string>{"pad.right_bumper"});
    choose("reset", "Drop the selected object");
    EXPECT_EQ(words(Action::Drop), (std::vector<std::string>{"q", "pad.right_bumper"}));
    EXPECT_EQ(written("bindings.ui.toml").find("drop"), std::string::npos);

    choose("Q", "Drop the selected object");
    keys({'U'});
    choose("H", "Help");
    keys({'I'});
    choose("Reset all");
    for (const Action action : {Action::Drop, Action::Help})
        EXPECT_EQ(bindings_->current().of(action), bindings_->below().of(action));
}

TEST_F(ControlsPages, OfferHoldsWhereBothMakeSenseAndResetWhereSomethingDiffers) {
    keys({kEscape});
    choose("Controls");
    const auto cells_of = [this](const std::string& label) {
        std::vector<std::string> texts;
        for (const Line& line : control_->menu().page().lines)
            if (line.label == label)
                for (const Cell& each : line.cells) texts.push_back(each.text);
        return texts;
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(cells_of("Help"), (Texts{"H", "+"}));
    EXPECT_EQ(cells_of("Look around"), Texts{}) << "no press names a whole stick";
    EXPECT_EQ(cells_of("Sprint").back(), "hold");
    choose("hold", "Sprint");
    EXPECT_EQ(bindings_->current().hold_mode[index_of(Action::Sprint)], input::HoldMode::Toggle);
    lay_out();
    const Texts run = cells_of("Sprint");
    EXPECT_EQ(run.back(), "reset");
    EXPECT_EQ(run[run.size() - 2], "toggle");
    choose("reset", "Sprint");
    EXPECT_EQ(bindings_->current().hold_mode[index_of(Action::Sprint)], input::HoldMode::Hold);
}

}  // namespace
}  // namespace plumbline::app::ui
