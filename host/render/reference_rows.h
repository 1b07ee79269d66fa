#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "base/parallel_for.h"
#include "settings/crop.h"

namespace calotype {

/// Calls pixel(x, y) for each pixel of the crop, counted from its top left corner, on `threads` >=
/// 1 threads. `onProgress`, if given, is called now and then with the share done in [0, 1]; it may
/// throw to end the work.
template <typename Pixel>
void forEachPixel(const Crop& crop, uint32_t threads, const Pixel& pixel,
                  const std::function<void(double)>& onProgress) {
    constexpr uint32_t kRowsAtOnce = 16;
    for (uint32_t begin = 0; begin < crop.height; begin += kRowsAtOnce) {
        const uint32_t end = std::min(begin + kRowsAtOnce, crop.height);
        parallelFor(begin, end, threads, [&](uint64_t row, uint32_t) {
            for (uint32_t x = 0; x < crop.width; ++x)
                pixel(x, static_cast<uint32_t>(row));
        });
        if (onProgress)
            onProgress(static_cast<double>(end) / crop.height);
    }
}

} // namespace calotype
