#pragma once

#include <thread>
#include <utility>

namespace calotype {

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
