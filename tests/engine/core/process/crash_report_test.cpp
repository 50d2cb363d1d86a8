#include "engine/core/process/crash_report.h"

#include "engine/core/log.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#ifndef __SANITIZE_ADDRESS__

namespace plumbline {
namespace {

using test::TemporaryFolder;

/// A child that dies of `number`, after a word in the log. Gives how it ended.
int status_of_a_crash(const TemporaryFolder& folder, int number) {
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit no_core{};
        ::setrlimit(RLIMIT_CORE, &no_core);
        report_crashes(folder / "state", "plumbline 1.2.3\nplumbline play garden");
        log_warning("the last thing {} said", "it");
        ::raise(number);
        std::_Exit(0);
    }
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

// EXPERIENCE I4
TEST(CrashReport, SaysWhatWasGoingOnAndLetsTheSignalKill) {
    for (const auto& [number, name] : {std::pair{SIGSEGV, "SEGV"}, {SIGABRT, "ABRT"}}) {
        const TemporaryFolder folder;
        const int status = status_of_a_crash(folder, number);
        ASSERT_TRUE(WIFSIGNALED(status)) << status;
        EXPECT_EQ(WTERMSIG(status), number);
        const std::string report = folder.read("state/crash.txt");
        EXPECT_TRUE(report.starts_with("plumbline 1.2.3\nplumbline play garden\nsignal SIG" +
                                       std::string(name)))
            << report;
        EXPECT_NE(report.find("backtrace:\n"), std::string::npos) << report;
        EXPECT_NE(report.find("core_tests"), std::string::npos) << "frames of this program";
        EXPECT_NE(report.find("the last thing it said\n"), std::string::npos) << report;
    }
}

TEST(CrashReport, IsToldOfOnce) {
    const TemporaryFolder folder;
    EXPECT_EQ(take_crash_report(folder.path()), "");
    EXPECT_EQ(take_crash_report(""), "");
    folder.write("crash.txt", "it was like this");
    EXPECT_EQ(take_crash_report(folder.path()), folder / "crash.old.txt");
    EXPECT_EQ(folder.read("crash.old.txt"), "it was like this");
    EXPECT_EQ(take_crash_report(folder.path()), "");
}

// EXPERIENCE E12
TEST(CrashReport, AFolderThatCannotBeWrittenChangesNothing) {
    const TemporaryFolder folder;
    folder.write("state", "a file where the folder should be");
    const int status = status_of_a_crash(folder, SIGSEGV);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(folder.read("state"), "a file where the folder should be");
}

}  // namespace
}  // namespace plumbline

#endif
