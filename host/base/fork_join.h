#pragma once

#include <cstddef>
#include <cstdint>
#include <thread>
#include <utility>

namespace calotype {

/// Whether to go on with the halves of `count` primitives on two threads, `depth` halvings down:
/// while there is work for several times the threads, so that uneven halves even out.
inline bool isWorthForking(size_t count, uint32_t depth, uint32_t threads) {
    constexpr size_t kFewestPrimitives = 8192; // a millisecond's work, many times a thread's cost
    constexpr uint64_t kForksPerThread = 8;
    return threads > 1 && count >= kFewestPrimitives &&
           (uint64_t{1} << depth) < kForksPerThread * threads;
}

/// Runs two independent pieces of work and waits for both: on two threads if `parallel`, in which
/// case `onAnother` must not throw.
template <typename OnAnother, typename OnThis>
void forkJoin(bool parallel, OnAnother&& onAnother, OnThis&& onThis) {
    if (!parallel) {
        onAnother();
        onThis();
        return;
    }
    const std::jthread other(std::forward<OnAnother>(onAnother)); // joined on leaving
    onThis();
}

} // namespace calotype
