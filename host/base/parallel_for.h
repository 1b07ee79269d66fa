#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace calotype {

/// Calls body(index, thread) once for every index in [begin, end), on `threads` >= 1 threads
/// numbered from 0, this one among them. The body must not throw.
template <typename Body>
void parallelFor(uint32_t begin, uint32_t end, uint32_t threads, Body&& body) {
    std::atomic<uint32_t> next = begin;
    const auto work = [&](uint32_t thread) {
        for (uint32_t index = next++; index < end; index = next++)
            body(index, thread);
    };
    std::vector<std::jthread> others; // joined on leaving
    for (uint32_t thread = 1; thread < threads; ++thread)
        others.emplace_back(work, thread);
    work(0);
}

} // namespace calotype
