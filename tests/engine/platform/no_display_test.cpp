// What a person without a usable screen is told. Each test changes the environment, so each is a
// process of its own: gtest's death tests.
#include "engine/platform/window.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace plumbline::platform {
namespace {

/// Opens a window and leaves with its error on stderr and its exit code.
[[noreturn]] void open_and_leave() {
    const Result<std::unique_ptr<Window>> window = Window::open({});
    if (window.ok()) std::exit(0);
    std::fprintf(stderr, "%s\n", window.error().message.c_str());
    std::exit(static_cast<int>(window.error().exit_code));
}

TEST(NoDisplay, NamesTheVariableAndTheWayWithoutAScreen) {  // A1
    EXPECT_EXIT(
        {
            unsetenv("DISPLAY");
            unsetenv("WAYLAND_DISPLAY");
            open_and_leave();
        },
        testing::ExitedWithCode(3),
        "no display: DISPLAY is not set \\(.*DISPLAY environment variable is missing\\).*"
        "\\./play.*plumbline render");
}

TEST(NoDisplay, NamesTheDisplayThatDoesNotAnswer) {
    EXPECT_EXIT(
        {
            setenv("DISPLAY", ":9876", 1);
            open_and_leave();
        },
        testing::ExitedWithCode(3),
        "no display: DISPLAY=:9876 does not answer");
}

}  // namespace
}  // namespace plumbline::platform
