#pragma once

#include <string>

namespace calotype {

/// For work that leaves nothing behind, some steps of which cannot be stopped: decoders, drivers.
/// If a signal of catchInterrupts arrives while an object lives, and the object still lives 0.3 s
/// later, the program removes its locks and the folder, if one is given and it is empty, prints the
/// message, and ends with exit code 1. At most one object may live.
class InterruptDeadline {
public:
    explicit InterruptDeadline(const std::string& message, const std::string& folder = "");
    ~InterruptDeadline();
    InterruptDeadline(const InterruptDeadline&) = delete;
    InterruptDeadline& operator=(const InterruptDeadline&) = delete;
};

/// Called by the handler of these signals.
void startInterruptDeadline();

} // namespace calotype
