// What is left to read when the program crashes.
#pragma once

#include <filesystem>
#include <string_view>

namespace plumbline {

/// From now on a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) leaves `folder`/crash.txt:
/// `heading`, the signal, a backtrace and the last lines of the log; then the signal does what it
/// always does. Once a program. Without a folder, and under a sanitizer, nothing changes.
void report_crashes(const std::filesystem::path& folder, std::string_view heading);

/// The report that an earlier run left in `folder`, moved aside so that it is told of once; empty
/// when there is none.
std::filesystem::path take_crash_report(const std::filesystem::path& folder);

}  // namespace plumbline
