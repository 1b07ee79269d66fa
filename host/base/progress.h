#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

namespace calotype {

/// Called with the share done, in [0, 1]. May throw to end the work; may be empty.
using OnProgress = std::function<void(double done)>;

/// For a part of the work: its shares from 0 to 1 become those from `begin` to `end` of the whole.
inline OnProgress partOf(const OnProgress& whole, double begin, double end) {
    if (!whole)
        return {};
    return [whole, begin, end](double done) { whole(begin + (end - begin) * done); };
}

/// Reports the progress of a loop of `count` steps, `index` of which are done: at most every
/// 2^14 steps, which take milliseconds.
inline void reportStep(const OnProgress& onProgress, uint64_t index, uint64_t count) {
    constexpr uint64_t kInterval = 1 << 14;
    if (onProgress && index % kInterval == 0)
        onProgress(std::min(1.0, static_cast<double>(index) / static_cast<double>(count)));
}

} // namespace calotype
