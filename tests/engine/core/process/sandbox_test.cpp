// A confined process: what it may do, and how it ends when it does more.
#include "engine/core/process/sandbox.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumbline {
namespace {

constexpr std::size_t kMiB = 1024ULL * 1024;

// Under a sanitizer nothing but the CPU time is limited: see enter_sandbox().
#ifndef __SANITIZE_ADDRESS__

/// What the child does confined; it ends with 0 unless something stops it.
template <class Work>
[[noreturn]] void confined(Work&& work) {
    const Result<Done> entered = enter_sandbox({.memory_bytes = 64 * kMiB, .cpu_s = 1});
    if (!entered) std::_Exit(99);
    work();
    std::_Exit(0);
}

TEST(SandboxDeathTest, ComputingMemoryExceptionsAndTheStreamsAreAllowed) {
    EXPECT_EXIT(confined([] {
                    std::vector<std::string> heap;
                    for (std::size_t i = 1; i < 40; ++i) heap.emplace_back(i * 20'000, 'x');
                    heap.clear();
                    try {
                        throw std::runtime_error("caught");
                    } catch (const std::exception& fault) {
                        const std::string line = std::string("said: ") + fault.what() + "\n";
                        if (::write(STDERR_FILENO, line.data(), line.size()) < 0) std::_Exit(2);
                    }
                }),
                testing::ExitedWithCode(0),
                "said: caught");
}

TEST(SandboxDeathTest, FilesAreNotOpenedAndNotTouched) {
    EXPECT_EXIT(confined([] { std::_Exit(::open("/dev/null", O_RDONLY) == -1 ? 7 : 2); }),
                testing::ExitedWithCode(7),
                "");
    EXPECT_EXIT(confined([] { ::mkdir("/tmp/x", 0700); }), testing::KilledBySignal(SIGSYS), "");
    EXPECT_EXIT(confined([] { ::unlink("/nonexistent/x"); }), testing::KilledBySignal(SIGSYS), "");
}

TEST(SandboxDeathTest, ProcessesSocketsAndSignalsForOthersEndIt) {
    EXPECT_EXIT(confined([] { ::fork(); }), testing::KilledBySignal(SIGSYS), "");
    EXPECT_EXIT(
        confined([] { ::socket(AF_UNIX, SOCK_STREAM, 0); }), testing::KilledBySignal(SIGSYS), "");
    EXPECT_EXIT(confined([] { ::kill(::getpid(), 0); }), testing::KilledBySignal(SIGSYS), "");
    EXPECT_EXIT(confined([] { ::execl("/bin/true", "true", nullptr); }),
                testing::KilledBySignal(SIGSYS),
                "");
}

TEST(SandboxDeathTest, ACrashIsStillACrash) {
    EXPECT_EXIT(confined([] { std::abort(); }), testing::KilledBySignal(SIGABRT), "");
}

TEST(SandboxDeathTest, MemoryBeyondTheLimitIsRefused) {
    EXPECT_EXIT(confined([] {
                    try {
                        const std::vector<char> block(96 * kMiB, 'x');
                        std::_Exit(2);
                    } catch (const std::bad_alloc&) {
                        std::_Exit(7);
                    }
                }),
                testing::ExitedWithCode(7),
                "");
}

TEST(SandboxDeathTest, NoOtherDescriptorStaysOpen) {
    int ends[2] = {-1, -1};
    ASSERT_EQ(::pipe(ends), 0);
    EXPECT_EXIT(confined([&] { std::_Exit(::write(ends[1], "x", 1) == -1 ? 7 : 2); }),
                testing::ExitedWithCode(7),
                "");
    ::close(ends[0]);
    ::close(ends[1]);
}

#endif

TEST(SandboxDeathTest, ComputingWithoutEndIsEnded) {
    EXPECT_EXIT(
        {
            if (!enter_sandbox({.memory_bytes = 64 * kMiB, .cpu_s = 1})) std::_Exit(99);
            volatile unsigned turns = 0;
            while (true) turns = turns + 1;
        },
        testing::KilledBySignal(SIGXCPU),
        "");
}

}  // namespace
}  // namespace plumbline
