// Ranges of numbers on the command line.
#include "game/command_line/option_ranges.h"

#include <gtest/gtest.h>

namespace plumbline::game {
namespace {

TEST(OptionRanges, TakeWhatLiesBetweenTheirEndsAndBothOfThem) {
    const RangeCheck check = between(-1.5, 30);
    for (const char* good : {"-1.5", "0", "+7", "3e1", "30", "-.5"}) EXPECT_EQ(check(good), "");
    for (const char* bad : {"-1.51", "30.1", "1e999", "inf", "-inf", "nan"})
        EXPECT_EQ(check(bad), std::string{bad} + ": expected a number from -1.5 to 30");
}

TEST(OptionRanges, TakeNoWordThatIsNoNumberAsAWhole) {
    for (const char* bad : {"", " ", "1 ", "1x", "x1", "1,5", "0x10", "+", "--1"}) {
        EXPECT_NE(between(-100, 100)(bad), "") << bad;
        EXPECT_NE(positive_up_to(100)(bad), "") << bad;
    }
}

TEST(OptionRanges, APositiveOneTakesNoNothing) {
    const RangeCheck check = positive_up_to(kLongestRun_s);
    EXPECT_EQ(check("1e-9"), "");
    EXPECT_EQ(check("1000000"), "");
    for (const char* bad : {"0", "-0", "-1", "1000001", "nan"})
        EXPECT_EQ(check(bad), std::string{bad} + ": expected a number above 0, up to 1000000");
}

}  // namespace
}  // namespace plumbline::game
