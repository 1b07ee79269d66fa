#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

#include "base/add_thread.h"

namespace calotype {

inline uint32_t allCores() { return std::max(1u, std::thread::hardware_concurrency()); }

/// Calls body(index, thread) once for every index in [begin, end), on up to `threads` >= 1 threads
/// numbered from 0, including the calling one. The body must not throw.
template <typename Body>
void parallelFor(uint64_t begin, uint64_t end, uint32_t threads, Body&& body) {
    std::atomic<uint64_t> next = begin;
    const auto work = [&](uint32_t thread) {
        for (uint64_t index = next++; index < end; index = next++)
            body(index, thread);
    };
    std::vector<std::jthread> others; // joined at the end
    for (uint32_t thread = 1; thread < threads; ++thread)
        if (!addThread(others, [&work, thread] { work(thread); }))
            break;
    work(0);
}

} // namespace calotype
