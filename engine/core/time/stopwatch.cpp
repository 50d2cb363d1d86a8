#include "engine/core/time/stopwatch.h"

#include <unistd.h>

#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace plumbline {
namespace {

double read_clock(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

// Field 22 of /proc/self/stat: start time in clock ticks since boot (proc(5)). The command name in
// field 2 may hold spaces, so counting begins behind its closing bracket.
double process_start_since_boot_s() {
    std::ifstream stat("/proc/self/stat");
    std::string text;
    std::getline(stat, text);
    const std::size_t bracket = text.rfind(')');
    if (bracket == std::string::npos) return read_clock(CLOCK_BOOTTIME);
    std::istringstream fields(text.substr(bracket + 1));
    std::string field;
    for (int i = 3; i <= 22; ++i) fields >> field;
    return std::strtod(field.c_str(), nullptr) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

double wall_s() {
    return read_clock(CLOCK_MONOTONIC);
}

double thread_cpu_s() {
    return read_clock(CLOCK_THREAD_CPUTIME_ID);
}

double process_cpu_s() {
    return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}

double seconds_since_process_start() {
    return read_clock(CLOCK_BOOTTIME) - process_start_since_boot_s();
}

}  // namespace plumbline
