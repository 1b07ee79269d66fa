#include "cli/interrupt_deadline.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <unistd.h>

#include "base/output_lock.h"
#include "cli/exit_code.h"

namespace calotype {
namespace {

/// Nanoseconds. Steps that look for the signal do so more often, and then clean up.
constexpr long kPatience = 300'000'000;

// For the handlers, which may use little more.
volatile std::sig_atomic_t isActive = 0;
timer_t endTimer;
char endMessage[256];
size_t endMessageSize = 0;
std::string endFolder; ///< changed only while no object lives

void onTimer(int) {
    if (!isActive)
        return;
    removeLockFiles();
    if (!endFolder.empty())
        rmdir(endFolder.c_str());
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, endMessage, endMessageSize);
    _exit(kExitOther);
}

} // namespace

InterruptDeadline::InterruptDeadline(const std::string& sentence, const std::string& folder) {
    endFolder = folder;
    const std::string line = "calotype: " + sentence + "\n";
    // After a progress bar, in a line of its own.
    const std::string output = isatty(STDERR_FILENO) != 0 ? "\n" + line : line;
    endMessageSize = std::min(output.size(), sizeof endMessage);
    std::copy_n(output.data(), endMessageSize, endMessage);
    struct sigaction action {};
    action.sa_handler = onTimer;
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, nullptr);
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGALRM;
    isActive = timer_create(CLOCK_MONOTONIC, &event, &endTimer) == 0 ? 1 : 0;
}

InterruptDeadline::~InterruptDeadline() {
    if (!isActive)
        return;
    isActive = 0;
    timer_delete(endTimer);
}

void startInterruptDeadline() {
    if (!isActive)
        return;
    itimerspec expiry{};
    expiry.it_value.tv_nsec = kPatience;
    timer_settime(endTimer, 0, &expiry, nullptr);
}

} // namespace calotype
