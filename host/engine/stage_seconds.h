#pragma once

#include <chrono>

#include "base/stopwatch.h"

namespace calotype {

/// Wall-clock seconds of each stage of a render.
struct StageSeconds {
    double load = 0.0;
    double build = 0.0; ///< of the BVH, including packing
    double upload = 0.0;
    double compile = 0.0;
    double features = 0.0;    ///< of the pixels: the pass of --denoise and of averaged layers
    double firstSample = 0.0; ///< from the start of the program until every pixel had one sample
    double render = 0.0;      ///< sampling alone
    double denoise = 0.0;
    double write = 0.0;
};

/// Runs `stage`, stores its wall-clock seconds, and returns its result.
template <typename Stage>
auto timed(double& seconds, Stage&& stage) {
    const auto start = std::chrono::steady_clock::now();
    auto result = stage();
    seconds = secondsSince(start);
    return result;
}

} // namespace calotype
