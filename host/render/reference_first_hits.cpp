#include "render/reference_first_hits.h"

#include "render/reference_rows.h"

namespace calotype {

FirstHitImage referenceFirstHits(const reference::ReferenceTracer& tracer,
                                 const RenderSettings& settings, uint32_t threads,
                                 const std::function<void(double)>& onProgress) {
    const Crop& crop = settings.crop;
    FirstHitImage hits(crop.width, crop.height);
    const auto find = [&](uint32_t x, uint32_t y) {
        hits.at(x, y) = tracer.firstHit({crop.x + x, crop.y + y});
    };
    forEachPixel(crop, threads, find, onProgress);
    return hits;
}

} // namespace calotype
