// Needs an X server: CTest runs it under xvfb-run.
#include "engine/platform/window.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace plumbline::platform {
namespace {

TEST(OldGl, SaysWhatWasFoundAndWhatIsNeeded) {  // A3
    setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    const Result<std::unique_ptr<Window>> window = Window::open({.visible = false});
    ASSERT_FALSE(window.ok());
    EXPECT_EQ(window.error().exit_code, ExitCode::NoDisplay);
    EXPECT_NE(window.error().message.find("3.3 core is needed"), std::string::npos);
    EXPECT_NE(window.error().message.find("OpenGL 2.1"), std::string::npos)
        << window.error().message;
}

TEST(OldGl, StepsDownToWhatIsThere) {  // A2
    setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    const Result<std::unique_ptr<Window>> window = Window::open({.visible = false});
    EXPECT_TRUE(window.ok()) << window.error().message;
}

}  // namespace
}  // namespace plumbline::platform
