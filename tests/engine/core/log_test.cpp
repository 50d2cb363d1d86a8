#include "engine/core/log.h"

#include "engine/core/assert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace plumbline {
namespace {

std::string logged(const std::function<void()>& say) {
    testing::internal::CaptureStderr();
    say();
    return testing::internal::GetCapturedStderr();
}

TEST(Log, NamesTheProgramAndTheLevel) {
    set_log_level(LogLevel::Note);
    EXPECT_EQ(logged([] { log_warning("{} of {}", 2, "three"); }),
              "plumbline: warning: 2 of three\n");
    EXPECT_EQ(logged([] { log_error("broken"); }), "plumbline: error: broken\n");
}

TEST(Log, ShowsItsLevelAndAbove) {
    set_log_level(LogLevel::Note);
    EXPECT_EQ(logged([] { log_debug("unseen"); }), "");
    EXPECT_NE(logged([] { log_note("a note"); }), "");
    set_log_level(LogLevel::Error);
    EXPECT_EQ(logged([] { log_warning("unseen too"); }), "");
    EXPECT_NE(logged([] { log_error("seen"); }), "");
    set_log_level(LogLevel::Debug);
    EXPECT_NE(logged([] { log_debug("seen as well"); }), "");
    set_log_level(LogLevel::Note);
}

TEST(Log, FoldsRepeatsIntoACount) {
    set_log_level(LogLevel::Note);
    const std::string text = logged([] {
        for (int i = 0; i < 100; ++i) log_warning("the same again");
        log_warning("something else");
    });
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
    EXPECT_NE(text.find("99"), std::string::npos) << text;
}

TEST(Log, TextWithBracesIsText) {
    EXPECT_EQ(logged([] { log_line(LogLevel::Error, "{} %s {"); }), "plumbline: error: {} %s {\n");
}

TEST(AssertDeathTest, SaysWhatWasExpectedAndWhere) {
    EXPECT_DEATH(PL_ASSERT(1 > 2, "one above two"),
                 "log_test.cpp:[0-9]+: expected one above two \\(1 > 2\\)");
}

}  // namespace
}  // namespace plumbline
