#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <thread>
#include <vector>

#include "base/add_thread.h"

namespace calotype {

/// Whether to process the two halves of `count` primitives on two threads, after `depth` halvings:
/// as long as there are fewer parts than several times the threads, which balances unequal halves.
inline bool isWorthForking(size_t count, uint32_t depth, uint32_t threads) {
    constexpr size_t kFewestPrimitives = 8192; // a millisecond of work: much more than a thread
    constexpr uint64_t kForksPerThread = 8;
    return threads > 1 && count >= kFewestPrimitives &&
           (uint64_t{1} << depth) < kForksPerThread * threads;
}

/// Runs two independent functions and waits for both: on two threads if `parallel`, and if the
/// system gives another. Throws what they throw.
template <typename OnAnother, typename OnThis>
void forkJoin(bool parallel, OnAnother&& onAnother, OnThis&& onThis) {
    std::exception_ptr failure;
    {
        std::vector<std::jthread> other; // joined at the end of the block
        const auto work = [&] {
            try {
                onAnother();
            } catch (...) {
                failure = std::current_exception();
            }
        };
        if (!parallel || !addThread(other, work))
            work();
        onThis();
    }
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace calotype
