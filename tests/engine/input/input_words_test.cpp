#include "engine/input/bindings.h"

#include <gtest/gtest.h>

#include <set>

namespace plumbline::input {
namespace {

Input parsed(std::string_view word) {
    const Result<Input> input = parse_input(word);
    EXPECT_TRUE(input.ok()) << word;
    return input.ok() ? *input : Input{};
}

TEST(InputWords, EveryWordParsesToItselfAndNoTwoMeanTheSame) {
    std::set<std::tuple<int, int, int>> meanings;
    for (const std::string_view word : input_words()) {
        const Input input = parsed(word);
        EXPECT_EQ(input.word, word);
        meanings.insert({static_cast<int>(input.kind), input.code, input.direction});
    }
    EXPECT_EQ(meanings.size(), input_words().size());
}

TEST(InputWords, KeysHaveTheCodesOfGlfw) {
    EXPECT_EQ(parsed("w").code, 'W');
    EXPECT_EQ(parsed("7").code, '7');
    EXPECT_EQ(parsed("[").code, '[');
    EXPECT_EQ(parsed("space").code, 32);
    EXPECT_EQ(parsed("escape").code, 256);
    EXPECT_EQ(parsed("f1").code, 290);
    EXPECT_EQ(parsed("f25").code, 314);
    EXPECT_EQ(parsed("kp_add").code, 334);
    EXPECT_EQ(parsed("left_shift").code, 340);
    EXPECT_EQ(parsed("right_super").code, 347);
}

TEST(InputWords, ChordsComeInOneOrder) {
    const Input input = parsed("shift+ctrl+x");
    EXPECT_EQ(input.word, "ctrl+shift+x");
    EXPECT_EQ(input.modifiers, kCtrl | kShift);
    EXPECT_EQ(input, parsed("ctrl+shift+x"));
    EXPECT_FALSE(input == parsed("x"));
    EXPECT_EQ(parsed("alt+wheel.up").kind, DeviceKind::Wheel);
    EXPECT_EQ(parsed("ctrl+=").code, '=');
}

TEST(InputWords, AxesEndInASign) {
    const Input back = parsed("pad.left_y+");
    EXPECT_EQ(back.kind, DeviceKind::PadAxis);
    EXPECT_EQ(back.code, 1);
    EXPECT_EQ(back.direction, 1);
    EXPECT_EQ(parsed("pad.left_y-").direction, -1);
    EXPECT_EQ(parsed("pad.right_trigger").code, 5);
}

TEST(InputWords, QuakeWordsGiveCanonicalOnes) {
    EXPECT_EQ(parsed("mouse1").word, "mouse.left");
    EXPECT_EQ(parsed("MOUSE3").word, "mouse.middle");
    EXPECT_EQ(parsed("mwheelup").word, "wheel.up");
    EXPECT_EQ(parsed("uparrow").word, "up");
    EXPECT_EQ(parsed("shift").word, "left_shift");
    EXPECT_EQ(parsed("ctrl").word, "left_control");
    EXPECT_EQ(parsed("kp_plus").word, "kp_add");
}

TEST(InputWords, LabelsAreOnePrintedCharacter) {
    const Input slash = parsed("label:/");
    EXPECT_EQ(slash.kind, DeviceKind::Label);
    EXPECT_EQ(slash.label, '/');
    EXPECT_EQ(parsed("label:Q").label, 'q');
    EXPECT_FALSE(parse_input("label:").ok());
    EXPECT_FALSE(parse_input("label:ab").ok());
    EXPECT_FALSE(parse_input("label:\n").ok());
}

TEST(InputWords, WhatIsNoWordNamesTheNearest) {
    EXPECT_EQ(parse_input("spcae").error().message, "unknown input \"spcae\". Nearest: \"space\"");
    EXPECT_EQ(parse_input("mouse.lft").error().message,
              "unknown input \"mouse.lft\". Nearest: \"mouse.left\"");
    EXPECT_FALSE(parse_input("").ok());
    EXPECT_FALSE(parse_input("ctrl+").ok());
    EXPECT_FALSE(parse_input("ctrl+mouse.move").ok());
    EXPECT_FALSE(parse_input("shift+pad.left_x-").ok());
    EXPECT_FALSE(parse_input(std::string(100'000, 'a')).ok());
}

}  // namespace
}  // namespace plumbline::input
