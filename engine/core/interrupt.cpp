#include "engine/core/interrupt.h"

#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace plumbline {
namespace {

volatile std::sig_atomic_t signals_seen = 0;

extern "C" void note_signal(int) {
    if (signals_seen != 0) _exit(130);
    signals_seen = 1;
}

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_signal;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaction(number, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() {
    return signals_seen != 0;
}

}  // namespace plumbline
