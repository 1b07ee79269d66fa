#include "cli/interrupt.h"

#include <csignal>
#include <ctime>
#include <unistd.h>

#include "base/error.h"
#include "cli/interrupt_deadline.h"

namespace calotype {
namespace {

/// Signals less than this apart, in seconds, count as one: `timeout` signals the program and then
/// its process group. A user cannot press Ctrl-C twice so fast.
constexpr double kSameSignal = 0.2;

constexpr int kEndingSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2};

/// Whether it ends the program at once the second time. SIGXCPU comes every second, and SIGHUP from
/// both the shell and the system.
bool isImpatient(int signal) { return signal == SIGINT || signal == SIGTERM; }

volatile std::sig_atomic_t interrupted = 0;
timespec firstSignalAt; // used by the handler only, which cannot interrupt itself

double secondsBetween(const timespec& begin, const timespec& end) {
    return double(end.tv_sec - begin.tv_sec) + double(end.tv_nsec - begin.tv_nsec) * 1e-9;
}

void onSignal(int signal) {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    if (!interrupted)
        firstSignalAt = now;
    else if (isImpatient(signal) && secondsBetween(firstSignalAt, now) > kSameSignal)
        _exit(128 + signal);
    interrupted = 1;
    startInterruptDeadline();
}

bool isIgnored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

} // namespace

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = SA_RESTART;
    for (const int signal : kEndingSignals)
        sigaddset(&action.sa_mask, signal);
    for (const int signal : kEndingSignals)
        if (!isIgnored(signal))
            sigaction(signal, &action, nullptr);
    // Then exceeding a file size limit, or a closed pipe, is an error of the write, with cleanup.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

bool isInterrupted() { return interrupted != 0; }

void throwIfInterrupted() {
    if (isInterrupted())
        throw Interrupted();
}

void throwIfInterrupted(const char* sentence) {
    if (isInterrupted())
        throw Error(sentence);
}

} // namespace calotype
