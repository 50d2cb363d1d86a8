#include "engine/core/process/interrupt.h"

#include "engine/core/time/stopwatch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace plumbline {
namespace {

// Each in a process of its own: the flag is one for the whole program.
TEST(InterruptDeathTest, TheFirstSignalOnlySetsTheFlag) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        EXPECT_EXIT(
            {
                catch_interrupts();
                const bool before = interrupted();
                std::raise(signal);
                std::_Exit(!before && interrupted() ? 7 : 1);
            },
            testing::ExitedWithCode(7),
            "");
    }
}

TEST(InterruptDeathTest, TheSecondSignalEndsTheProgram) {
    EXPECT_EXIT(
        {
            catch_interrupts();
            std::raise(SIGINT);
            std::raise(SIGINT);
            std::_Exit(1);
        },
        testing::ExitedWithCode(130),
        "");
}

[[noreturn]] void work_on(double seconds, bool heeding) {
    catch_interrupts();
    std::raise(SIGTERM);
    const double end_s = wall_s() + seconds;
    if (heeding) {
        while (wall_s() < end_s) {
        }
        std::_Exit(interrupted() ? 7 : 1);
    }
    const UnheedingWork work;
    while (wall_s() < end_s) {
    }
    std::_Exit(1);
}

TEST(InterruptDeathTest, WorkThatDoesNotLookIsCutOffAfterASecond) {
    EXPECT_EXIT(work_on(60, false), testing::ExitedWithCode(130), "ended within a step");
}

TEST(InterruptDeathTest, WorkThatLooksMayTakeItsTime) {
    EXPECT_EXIT(work_on(1.5, true), testing::ExitedWithCode(7), "");
}

/// 7 when writing into a pipe that nobody reads fails, and nothing else happens.
[[noreturn]] void write_into_a_closed_pipe() {
    catch_interrupts();
    int ends[2] = {-1, -1};
    const bool made = ::pipe(ends) == 0;
    ::close(ends[0]);
    const bool failed = ::write(ends[1], "x", 1) == -1;
    std::_Exit(made && failed && !interrupted() ? 7 : 1);
}

TEST(InterruptDeathTest, AClosedPipeIsAFailedWriteNotTheEnd) {
    EXPECT_EXIT(write_into_a_closed_pipe(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace plumbline
