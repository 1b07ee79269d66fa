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
    // A file size limit or a closed pipe is then an error of the write, which is cleaned up after.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

bool isInterrupted() { return interrupted != 0; }

} // namespace calotype
