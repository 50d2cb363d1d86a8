#include "engine/core/process/crash_report.h"

#include "engine/core/log_tail.h"

#include <execinfo.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <string>

namespace plumbline {
namespace fs = std::filesystem;
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kReported = false;  // the sanitizer's own report says more
#else
constexpr bool kReported = true;
#endif

// Made before the crash: its handler may not allocate.
std::string report_file;
std::string report_heading;
std::array<char, 64 * 1024> handler_stack;  // what overflowed its stack has none left

void write_text(int file, std::string_view text) {
    // Nobody is left to hear of a failure.
    [[maybe_unused]] const ssize_t written = ::write(file, text.data(), text.size());
}

extern "C" void report_crash(int number) {
    constexpr int kMostFrames = 64;
    void* frames[kMostFrames];
    const int file = ::open(report_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const char* name = ::sigabbrev_np(number);
    if (file >= 0) {
        write_text(file, report_heading);
        write_text(file, "\nsignal SIG");
        write_text(file, name != nullptr ? name : "?");
        write_text(file, "\n\nbacktrace:\n");
        ::backtrace_symbols_fd(frames, ::backtrace(frames, kMostFrames), file);
        write_text(file, "\nlast lines of the log:\n");
        write_last_log_lines(file);
        ::close(file);
        write_text(STDERR_FILENO, "plumbline: crashed; what it was doing is in ");
        write_text(STDERR_FILENO, report_file);
        write_text(STDERR_FILENO, "\n");
    }
    ::raise(number);  // the handler is gone: as if there had never been one
}

}  // namespace

void report_crashes(const fs::path& folder, std::string_view heading) {
    if (!kReported || folder.empty()) return;
    std::error_code ignored;  // then there is no report
    fs::create_directories(folder, ignored);
    report_file = (folder / "crash.txt").string();
    report_heading = heading;
    void* frame = nullptr;
    ::backtrace(&frame, 1);  // loads what it needs, which allocates

    stack_t stack{};
    stack.ss_sp = handler_stack.data();
    stack.ss_size = handler_stack.size();
    ::sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = report_crash;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_ONSTACK | SA_NODEFER;
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        ::sigaction(number, &action, nullptr);
}

fs::path take_crash_report(const fs::path& folder) {
    const fs::path aside = folder / "crash.old.txt";
    std::error_code failed;
    if (folder.empty() || !fs::is_regular_file(folder / "crash.txt", failed)) return {};
    fs::rename(folder / "crash.txt", aside, failed);
    return failed ? folder / "crash.txt" : aside;
}

}  // namespace plumbline
