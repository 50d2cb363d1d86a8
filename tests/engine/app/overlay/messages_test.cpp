#include "engine/app/overlay/messages.h"

#include <gtest/gtest.h>

namespace plumbline::app {
namespace {

std::vector<std::string> texts(Messages& messages, double now_s) {
    std::vector<std::string> found;
    for (const ui::HudLine& line : messages.lines(now_s, false)) found.push_back(line.text);
    return found;
}

using Words = std::vector<std::string>;

// Four seconds, and a twenty-fifth for each letter.
TEST(MessagesTest, FadeInTheirLastSecondUnlessMotionIsReduced) {
    Messages messages;
    messages.say("12345");
    EXPECT_FLOAT_EQ(messages.lines(10.0, false).at(0).alpha, 1.0F);
    EXPECT_FLOAT_EQ(messages.lines(13.7, false).at(0).alpha, 0.5F);
    EXPECT_FLOAT_EQ(messages.lines(13.7, true).at(0).alpha, 1.0F);
    EXPECT_FLOAT_EQ(messages.lines(14.2, false).at(0).alpha, 0.05F) << "visible to the end";
    EXPECT_EQ(texts(messages, 14.3), Words{});
}

TEST(MessagesTest, OneThatIsStillUpIsRenewed) {
    Messages messages;
    messages.say("saved");
    EXPECT_EQ(texts(messages, 0.0), Words{"saved"});
    EXPECT_EQ(texts(messages, 3.0), Words{"saved"});
    messages.say("saved");
    EXPECT_EQ(texts(messages, 3.0), Words{"saved"});
    EXPECT_EQ(texts(messages, 7.0), Words{"saved"}) << "counted from the second time";
    EXPECT_EQ(texts(messages, 8.0), Words{});
}

TEST(MessagesTest, ANumberReplacesTheOneBeforeAndTheOldestGoFirst) {
    Messages messages;
    messages.say_latest("light: 80 %");
    messages.say_latest("fog: on");
    messages.say_latest("light: 100 %");
    EXPECT_EQ(texts(messages, 0.0), (Words{"fog: on", "light: 100 %"}));
    for (const char* line : {"a", "b", "c", "d", "e"}) messages.say(line);
    EXPECT_EQ(texts(messages, 0.0), (Words{"light: 100 %", "a", "b", "c", "d", "e"}));
}

}  // namespace
}  // namespace plumbline::app
