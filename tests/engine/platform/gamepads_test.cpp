#include "engine/platform/gamepads.h"

#include <gtest/gtest.h>

#include <array>

namespace plumbline::platform {
namespace {

// EXPERIENCE C6
TEST(Gamepads, APadThatComesBackUnderAnotherIndexIsTheSamePad) {
    std::array<std::string, 4> guids{"", "mine", "", "other"};
    EXPECT_EQ(pad_to_read(guids, -1, ""), 1);  // the first there is
    EXPECT_EQ(pad_to_read(guids, 1, "mine"), 1);
    guids = {"other", "", "mine", ""};  // pulled out, and in again beside another
    EXPECT_EQ(pad_to_read(guids, 1, "mine"), 2);
    guids = {"other", "mine", "mine", ""};  // two of a kind: the one in the hand
    EXPECT_EQ(pad_to_read(guids, 2, "mine"), 2);
    guids = {"", "", "", "other"};  // gone: what else there is
    EXPECT_EQ(pad_to_read(guids, 2, "mine"), 3);
    guids = {};
    EXPECT_EQ(pad_to_read(guids, 3, "other"), -1);
}

}  // namespace
}  // namespace plumbline::platform
