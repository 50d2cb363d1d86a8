#include "engine/core/process/interrupt.h"

#include "engine/core/process/exit_code.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <initializer_list>
#include <string_view>

namespace plumbline {
namespace {

// Two signals may come to two threads at once.
std::atomic<bool> signal_seen{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<int> unheeding_works{0};
static_assert(std::atomic<int>::is_always_lock_free);

constexpr int kExitCode = static_cast<int>(ExitCode::Interrupted);
constexpr unsigned kGrace_s = 1;
constexpr std::string_view kCutOff = "plumbline: ended within a step that took too long\n";

extern "C" void note_signal(int) {
    if (signal_seen.exchange(true)) _exit(kExitCode);
    alarm(kGrace_s);
}

extern "C" void cut_off(int) {
    if (unheeding_works == 0) return;
    [[maybe_unused]] const ssize_t told = write(STDERR_FILENO, kCutOff.data(), kCutOff.size());
    _exit(kExitCode);
}

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
    action.sa_handler = cut_off;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

UnheedingWork::UnheedingWork() {
    ++unheeding_works;
}

UnheedingWork::~UnheedingWork() {
    --unheeding_works;
}

bool interrupted() {
    return signal_seen;
}

}  // namespace plumbline
