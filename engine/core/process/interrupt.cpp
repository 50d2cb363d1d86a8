#include "engine/core/process/interrupt.h"

#include "engine/core/process/exit_code.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

namespace plumbline {
namespace {

// Two signals may come to two threads at once.
std::atomic<bool> signal_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<int> polling{0};   // PollsInterrupts that live
std::atomic<int> ignoring{0};  // IgnoresInterrupts that live
static_assert(std::atomic<int>::is_always_lock_free);

constexpr int kExitCode = static_cast<int>(ExitCode::Interrupted);
constexpr unsigned kGrace_s = 1;
constexpr std::string_view kCutOff =
    "plumbline: interrupted: ended within work that took too long\n";

extern "C" void note_signal(int) {
    if (signal_seen.exchange(true)) _exit(kExitCode);
    alarm(kGrace_s);
}

extern "C" void cut_off(int) {
    if (polling > 0 && ignoring == 0) return;
    [[maybe_unused]] const ssize_t told = write(STDERR_FILENO, kCutOff.data(), kCutOff.size());
    _exit(kExitCode);
}

bool is_ignored(int number) {
    struct sigaction now {};
    return sigaction(number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    sigaction(SIGTERM, &action, nullptr);
    if (!is_ignored(SIGINT)) sigaction(SIGINT, &action, nullptr);
    if (!is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);
    action.sa_handler = cut_off;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
}

void ignore_write_signals() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

PollsInterrupts::PollsInterrupts() {
    ++polling;
}

PollsInterrupts::~PollsInterrupts() {
    --polling;
}

IgnoresInterrupts::IgnoresInterrupts() {
    ++ignoring;
    if (signal_seen) alarm(kGrace_s);  // work that begins after the signal has its second, too
}

IgnoresInterrupts::~IgnoresInterrupts() {
    --ignoring;
}

void cancel_cut_off() {
    alarm(0);
}

bool interrupted() {
    return signal_seen;
}

}  // namespace plumbline
