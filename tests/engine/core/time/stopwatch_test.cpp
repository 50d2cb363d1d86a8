#include "engine/core/time/stopwatch.h"

#include "engine/core/process/process_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline {
namespace {

TEST(Stopwatch, ClocksNeverGoBack) {
    double wall = wall_s();
    double thread = thread_cpu_s();
    double process = process_cpu_s();
    for (int i = 0; i < 1'000; ++i) {
        const double wall_now = wall_s();
        const double thread_now = thread_cpu_s();
        const double process_now = process_cpu_s();
        ASSERT_GE(wall_now, wall);
        ASSERT_GE(thread_now, thread);
        ASSERT_GE(process_now, process);
        wall = wall_now;
        thread = thread_now;
        process = process_now;
    }
}

TEST(Stopwatch, WorkTakesCpuTime) {
    const CpuTimer timer;
    volatile double sum = 0.0;
    while (timer.ms() < 1.0) sum = sum + 1.0;  // ends only if the clock runs
    EXPECT_GT(sum, 0.0);
    EXPECT_GE(process_cpu_s(), thread_cpu_s() * 0.5);
}

TEST(Stopwatch, ThisProcessBeganBeforeNow) {
    const double age_s = seconds_since_process_start();
    // The start is kept in ticks of a hundredth of a second.
    EXPECT_GE(age_s, -0.011);
    EXPECT_GE(seconds_since_process_start(), age_s);
}

TEST(ProcessMemory, PeakGrowsWithUse) {
    constexpr std::size_t kBytes = 64ULL * 1024 * 1024;
    const std::size_t before = peak_resident_bytes();
    ASSERT_GT(before, 100'000U);
    const std::vector<char> touched(kBytes, 1);
    EXPECT_GE(peak_resident_bytes(), before);
    EXPECT_GE(peak_resident_bytes(), kBytes);
    EXPECT_EQ(touched[kBytes / 2], 1);
}

}  // namespace
}  // namespace plumbline
