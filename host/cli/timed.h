#pragma once

#include <chrono>

namespace calotype {

/// Runs `stage`, stores how many seconds of wall-clock time it took, and returns what it returns.
template <typename Stage>
auto timed(double& seconds, Stage&& stage) {
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace calotype
