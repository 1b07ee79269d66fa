#include "render/reference_first_hits.h"

#include <algorithm>

#include "base/parallel_for.h"

namespace calotype {

FirstHitImage referenceFirstHits(const reference::ReferenceTracer& tracer,
                                 const RenderSettings& settings, uint32_t threads,
                                 const std::function<void(double)>& onProgress) {
    constexpr uint32_t kRowsAtOnce = 16;
    const Crop& crop = settings.crop;
    FirstHitImage hits(crop.width, crop.height);
    for (uint32_t begin = 0; begin < crop.height; begin += kRowsAtOnce) {
        const uint32_t end = std::min(begin + kRowsAtOnce, crop.height);
        parallelFor(begin, end, threads, [&](uint64_t row, uint32_t) {
            const auto y = static_cast<uint32_t>(row);
            for (uint32_t x = 0; x < crop.width; ++x)
                hits.at(x, y) = tracer.firstHit({crop.x + x, crop.y + y});
        });
        if (onProgress)
            onProgress(static_cast<double>(end) / crop.height);
    }
    return hits;
}

} // namespace calotype
