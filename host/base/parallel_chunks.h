#pragma once

#include <algorithm>
#include <cstdint>

#include "base/parallel_for.h"

namespace calotype {

/// Calls body(first, last) for consecutive parts of [0, count), on up to `threads` >= 1 threads.
/// The body must not throw.
template <typename Body>
void parallelChunks(uint64_t count, uint32_t threads, Body&& body) {
    constexpr uint64_t kChunk = 8192; // at least a fraction of a millisecond of work
    const uint64_t chunks = (count + kChunk - 1) / kChunk;
    const auto needed = static_cast<uint32_t>(std::clamp<uint64_t>(chunks, 1, threads));
    parallelFor(0, chunks, needed, [&](uint64_t chunk, uint32_t) {
        body(kChunk * chunk, std::min(kChunk * (chunk + 1), count));
    });
}

} // namespace calotype
