#include "cli/interrupt.h"

#include <csignal>
#include <unistd.h>

namespace calotype {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void onSignal(int signal) {
    if (interrupted)
        _exit(128 + signal);
    interrupted = 1;
}

} // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool isInterrupted() { return interrupted != 0; }

} // namespace calotype
