// What keys are called where no window system can be asked for a layout: as in the US.
#include "engine/platform/window.h"

#include <gtest/gtest.h>

namespace plumbline::platform {
namespace {

TEST(KeyNames, AreTheUsLettersWithoutAWindow) {
    EXPECT_EQ(printed_key_name('W'), "w");
    EXPECT_EQ(printed_key_name('1'), "1");
    EXPECT_EQ(printed_key_name(91), "[");
    EXPECT_EQ(printed_key_name(96), "`");
}

TEST(KeyNames, OfKeysThatPrintNothingAreWords) {
    EXPECT_EQ(printed_key_name(32), "Space");
    EXPECT_EQ(printed_key_name(256), "Escape");
    EXPECT_EQ(printed_key_name(341), "Left Ctrl");
    EXPECT_EQ(printed_key_name(345), "Right Ctrl");
    EXPECT_EQ(printed_key_name(348), "Menu");
}

TEST(KeyNames, OfTheKeypadAndFunctionKeysAreNumbered) {
    EXPECT_EQ(printed_key_name(290), "F1");
    EXPECT_EQ(printed_key_name(314), "F25");
    EXPECT_EQ(printed_key_name(320), "Keypad 0") << "not 0, which is another key";
    EXPECT_EQ(printed_key_name(329), "Keypad 9");
    EXPECT_EQ(printed_key_name(330), "Keypad .");
}

TEST(KeyNames, OfWhatIsNoKeyAreEmpty) {
    for (const int key : {-1, 0, 31, 97, 161, 315, 349, 100'000})
        EXPECT_EQ(printed_key_name(key), "");
}

}  // namespace
}  // namespace plumbline::platform
