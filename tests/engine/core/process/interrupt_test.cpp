#include "engine/core/process/interrupt.h"

#include "engine/core/time/stopwatch.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
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

[[noreturn]] void work_on(double seconds, bool polls) {
    catch_interrupts();
    std::raise(SIGTERM);
    const double end_s = wall_s() + seconds;
    if (polls) {
        const PollsInterrupts looked_at;
        while (wall_s() < end_s) {
        }
        std::_Exit(interrupted() ? 7 : 1);
    }
    const PollsInterrupts within;
    const IgnoresInterrupts work;
    while (wall_s() < end_s) {
    }
    std::_Exit(1);
}

TEST(InterruptDeathTest, WorkThatDoesNotLookIsCutOffAfterASecond) {
    EXPECT_EXIT(work_on(60, false), testing::ExitedWithCode(130), "ended within work");
}

[[noreturn]] void wait_without_looking() {
    catch_interrupts();
    std::raise(SIGTERM);
    const double end_s = wall_s() + 60;
    while (wall_s() < end_s) {
    }
    std::_Exit(1);
}

// A load is several pieces of such work: none of them may begin unheard after the signal's second.
TEST(InterruptDeathTest, WorkThatBeginsLongAfterTheSignalIsCutOffToo) {
    EXPECT_EXIT(
        {
            catch_interrupts();
            const PollsInterrupts within;
            std::raise(SIGTERM);
            for (const double end_s = wall_s() + 1.2; wall_s() < end_s;) {
            }
            const IgnoresInterrupts work;
            for (const double end_s = wall_s() + 60; wall_s() < end_s;) {
            }
            std::_Exit(1);
        },
        testing::ExitedWithCode(130),
        "interrupted");
}

TEST(InterruptDeathTest, AProgramThatSaysNothingOfItsLooksIsCutOffToo) {
    EXPECT_EXIT(wait_without_looking(), testing::ExitedWithCode(130), "interrupted");
}

// A script's background job, and nohup.
TEST(InterruptDeathTest, WhatWasIgnoredAtTheStartStaysIgnoredButForSigterm) {
    EXPECT_EXIT(
        {
            for (const int signal : {SIGINT, SIGHUP, SIGTERM}) std::signal(signal, SIG_IGN);
            catch_interrupts();
            std::raise(SIGINT);
            std::raise(SIGHUP);
            const bool before = interrupted();
            std::raise(SIGTERM);
            std::_Exit(!before && interrupted() ? 7 : 1);
        },
        testing::ExitedWithCode(7),
        "");
}

TEST(InterruptDeathTest, WorkThatLooksMayTakeItsTime) {
    EXPECT_EXIT(work_on(1.5, true), testing::ExitedWithCode(7), "");
}

/// 7 when writing into a pipe that nobody reads fails, and nothing else happens.
[[noreturn]] void write_into_a_closed_pipe() {
    ignore_write_signals();
    int ends[2] = {-1, -1};
    const bool made = ::pipe(ends) == 0;
    ::close(ends[0]);
    const bool failed = ::write(ends[1], "x", 1) == -1;
    std::_Exit(made && failed ? 7 : 1);
}

TEST(InterruptDeathTest, AClosedPipeIsAFailedWriteNotTheEnd) {
    EXPECT_EXIT(write_into_a_closed_pipe(), testing::ExitedWithCode(7), "");
}

/// 7 when a file that reached its limit refuses more, and nothing else happens.
[[noreturn]] void write_past_the_limit() {
    ignore_write_signals();
    const rlimit most{10, 10};
    const int file = ::fileno(std::tmpfile());
    const bool limited = ::setrlimit(RLIMIT_FSIZE, &most) == 0;
    const bool filled = ::write(file, "0123456789", 10) == 10;
    const bool failed = ::write(file, "x", 1) == -1 && errno == EFBIG;
    std::_Exit(limited && filled && failed ? 7 : 1);
}

TEST(InterruptDeathTest, AFilesLimitIsAFailedWriteNotTheEnd) {
    EXPECT_EXIT(write_past_the_limit(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace plumbline
