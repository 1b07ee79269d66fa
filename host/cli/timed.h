#pragma once

#include <chrono>

#include "base/stopwatch.h"

namespace calotype {

/// Runs `stage`, stores how many seconds of wall-clock time it took, and returns what it returns.
template <typename Stage>
auto timed(double& seconds, Stage&& stage) {
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    seconds = secondsSince(start);
    return result;
}

} // namespace calotype
