#include "engine/app/controls/key_labels.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

std::string label(std::string_view word) {
    const Result<input::Input> input = input::parse_input(word);
    EXPECT_TRUE(input.ok()) << word;
    return label_of(*input);
}

TEST(KeyLabels, SayWhatAPersonReadsOnTheDevice) {
    EXPECT_EQ(label("ctrl+r"), "Ctrl+R");
    EXPECT_EQ(label("mouse.left"), "Left mouse");
    EXPECT_EQ(label("mouse.move"), "Mouse");
    EXPECT_EQ(label("alt+wheel.up"), "Alt+Wheel up");
    EXPECT_EQ(label("pad.a"), "South (A)");
    EXPECT_EQ(label("pad.left_y-"), "Left stick up");
    EXPECT_EQ(label("pad.right_bumper"), "Right bumper");
    EXPECT_EQ(label("pad.right_stick"), "Right stick");
    EXPECT_EQ(label("pad.start"), "Pad Start");
    EXPECT_EQ(label("label:/"), "/");
}

TEST(KeyLabels, AHintFollowsTheDeviceUsedLast) {
    const input::Bindings bindings = input::built_in_bindings();
    EXPECT_EQ(hint_for(bindings, Action::Drop, input::LastDevice::KeyboardMouse), "Q");
    EXPECT_EQ(hint_for(bindings, Action::Drop, input::LastDevice::Gamepad), "Right bumper");
    EXPECT_EQ(hint_for(bindings, Action::UndoDrop, input::LastDevice::Gamepad), "Z");
    EXPECT_EQ(all_labels(bindings, Action::Throw, true), "Left mouse or Right trigger");
    EXPECT_EQ(all_labels(bindings, Action::Throw, false), "Left mouse");
    EXPECT_EQ(walk_labels(bindings, input::LastDevice::KeyboardMouse), "W A S D");
}

}  // namespace
}  // namespace plumbline::app
