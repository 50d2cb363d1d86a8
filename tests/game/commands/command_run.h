// Commands called in the test's own process, with data of the test's own.
#pragma once

#include "engine/core/result.h"
#include "tests/support/scoped_variable.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>

namespace plumbline::test {

/// How a command ended, and what it wrote.
struct CommandRun {
    ExitCode code{ExitCode::Good};
    std::string out;
    std::string said;  ///< on the standard error
};

template <typename Command>
CommandRun ran(Command&& command) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    CommandRun run;
    run.code = command();
    run.out = testing::internal::GetCapturedStdout();
    run.said = testing::internal::GetCapturedStderr();
    return run;
}

/// A folder that the program takes for its data, and a user who has nothing yet.
class CommandTest : public testing::Test {
protected:
    CommandTest() {
        for (const char* folder : {"assets/scenes", "shaders", "config"})
            std::filesystem::create_directories(folder_ / folder);
    }
    /// What the pages of reports are made of.
    void install_page() const {
        for (const char* part : {"assets/report", "assets/data"})
            std::filesystem::copy(std::filesystem::path(PL_SOURCE_DIR) / part, folder_ / part);
    }

    TemporaryFolder folder_;
    ScopedVariable data_{"PLUMBLINE_DATA", folder_.path().string()};
    ScopedVariable users_{"XDG_DATA_HOME", (folder_ / "users").string()};
    ScopedVariable settings_{"XDG_CONFIG_HOME", (folder_ / "settings").string()};
};

}  // namespace plumbline::test
